#include <atomic>
#include <fstream>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include <openvdb/Grid.h>
#include <openvdb/Metadata.h>
#include <openvdb/io/Archive.h>
#include <openvdb/openvdb.h>
#define XXH_INLINE_ALL  // the header is the library
#include <xxhash.h>

#include "host/base/parallel_for.h"
#include "host/io/atomic_file.h"
#include "host/io/vdb/vdb_check.h"
#include "host/io/vdb/vdb_values.h"
#include "host/io/vdb/vdb_volume.h"

namespace offing {
namespace {

using openvdb::FloatGrid;
using openvdb::Vec3SGrid;
using vdb::place_in_brick;

static_assert(CloudVolume::brick_cells == FloatGrid::TreeType::LeafNodeType::DIM, "a brick is a leaf");

/// A brick of the volume that has density.
struct KeptBrick {
  openvdb::Coord first_cell;
  std::size_t slot;
};

std::vector<KeptBrick> kept_bricks(const CloudVolume& volume) {
  const auto [nx, ny, nz] = volume.bricks;
  std::vector<KeptBrick> kept;
  std::size_t place = 0;
  for (int z = 0; z < nz; ++z) {
    for (int y = 0; y < ny; ++y) {
      for (int x = 0; x < nx; ++x, ++place) {
        const std::int32_t slot = volume.brick_of[place];
        constexpr int n = CloudVolume::brick_cells;
        if (slot != CloudVolume::no_brick)
          kept.push_back({{n * x, n * y, n * z}, static_cast<std::size_t>(slot)});
      }
    }
  }
  return kept;
}

/// Whether a volume may be written as it is. `most`: that the precision holds.
bool is_fit(const std::vector<float>& density, float most) {
  // Many at a time in each chunk: there may be 10^8. Numbers that are none fail both comparisons.
  constexpr std::size_t chunk = std::size_t{1} << 16;
  std::atomic<bool> fits = true;
  parallel_rows(static_cast<int>((density.size() + chunk - 1) / chunk), [&](int row) {
    const auto first = density.begin() + static_cast<std::ptrdiff_t>(chunk * static_cast<std::size_t>(row));
    const auto last =
        density.end() - first > static_cast<std::ptrdiff_t>(chunk) ? first + chunk : density.end();
    int misfits = 0;
    for (auto value = first; value != last; ++value) misfits += *value >= 0.0f && *value <= most ? 0 : 1;
    if (misfits > 0) fits = false;
  });
  return fits;
}

/// A copy without traces of rounding below 0. Throws for what is no density.
CloudVolume repaired(const std::filesystem::path& path, CloudVolume volume, float most) {
  std::vector<float>& density = volume.density;
  const auto place = [](std::size_t i) {
    return fmt::format("value {} of brick {}", i % CloudVolume::cells_of_brick,
                       i / CloudVolume::cells_of_brick);
  };
  vdb::clamp_density(density, [&](std::size_t i, const char* expected, const char*) {
    throw vdb::bad_vdb(path, place(i), expected, fmt::format("{:g}", density[i]), "make the volume again");
  });
  for (std::size_t i = 0; i < density.size(); ++i) {
    if (density[i] > most) {
      throw vdb::bad_vdb(path, place(i),
                         fmt::format("a density of at most {:g}, as half precision holds", most),
                         fmt::format("{:g}", density[i]), "write single precision");
    }
  }
  return volume;
}

/// A grid whose leaves are the bricks: active where there is density.
template <typename Grid, typename ValueOf>
typename Grid::Ptr grid_of(const std::vector<KeptBrick>& bricks, const std::vector<float>& density,
                           const ValueOf& value_of) {
  using Leaf = typename Grid::TreeType::LeafNodeType;
  typename Grid::Ptr grid = Grid::create();
  std::vector<std::unique_ptr<Leaf>> leaves(bricks.size());
  parallel_for(bricks.size(), 0, [&](std::size_t i) {
    const std::size_t first = bricks[i].slot * CloudVolume::cells_of_brick;
    auto leaf = std::make_unique<Leaf>(openvdb::PartialCreate(), bricks[i].first_cell);
    leaf->buffer().allocate();
    typename Grid::ValueType* values = leaf->buffer().data();
    typename Leaf::NodeMaskType active;
    // A word of the mask has the cells of one x.
    for (openvdb::Index x = 0, offset = 0; x < Leaf::DIM; ++x) {
      openvdb::Index64 word = 0;
      for (openvdb::Index bit = 0; bit < 64; ++bit, ++offset) {
        const std::size_t cell = first + place_in_brick(offset);
        const bool is_active = density[cell] > 0.0f;
        values[offset] = is_active ? value_of(cell) : typename Grid::ValueType(0.0f);
        word |= static_cast<openvdb::Index64>(is_active) << bit;
      }
      active.template getWord<openvdb::Index64>(x) = word;
    }
    if (active.isOff()) return;
    leaf->setValueMask(active);
    leaves[i] = std::move(leaf);
  });
  for (std::unique_ptr<Leaf>& leaf : leaves) {
    if (leaf) grid->tree().addLeaf(leaf.release());
  }
  return grid;
}

void place(openvdb::GridBase& grid, const char* name, const CloudVolume& volume, VdbPrecision precision) {
  grid.setName(name);
  grid.setGridClass(openvdb::GRID_FOG_VOLUME);
  grid.setSaveFloatAsHalf(precision == VdbPrecision::half);
  const glm::dvec3 middle_m = volume.origin_m + 0.5 * volume.cell_m;  // of the first cell
  openvdb::math::Transform::Ptr transform = openvdb::math::Transform::createLinearTransform(volume.cell_m);
  transform->postTranslate({middle_m.x, middle_m.y, middle_m.z});
  grid.setTransform(transform);
  grid.insertMeta(vdb::extinction_name, openvdb::DoubleMetadata(volume.extinction_per_m));
  grid.insertMeta(vdb::bricks_name,
                  openvdb::Vec3IMetadata({volume.bricks[0], volume.bricks[1], volume.bricks[2]}));
}

/// Writes grids to a stream that throws. Its protected base has what io::File does, whose own stream does not
/// tell of a full disk.
class GridWriter : private openvdb::io::Archive {
 public:
  /// Values of active cells alone, as they are: Blosc takes half of the time of all, and makes what noise
  /// frays a sixth smaller.
  GridWriter() { setCompression(openvdb::io::COMPRESS_ACTIVE_MASK); }

  void write_grids(std::ostream& stream, const openvdb::GridCPtrVec& grids) const {
    constexpr bool is_seekable = true;
    Archive::write(stream, grids, is_seekable);
  }
};

/// The library marks each file by a random number; ours is made of the content, so that the same cloud gives
/// the same bytes.
std::string mark_of(const VdbCloud& cloud, const std::vector<float>& density) {
  const XXH128_hash_t values = XXH3_128bits(density.data(), density.size() * sizeof(float));
  const XXH64_hash_t colours =
      XXH3_64bits(cloud.albedo.data(), cloud.albedo.size() * sizeof(cloud.albedo.front()));
  const XXH64_hash_t bricks =
      XXH3_64bits(cloud.volume.brick_of.data(), cloud.volume.brick_of.size() * sizeof(std::int32_t));
  const std::uint64_t low = values.low64 ^ colours ^ bricks;
  return fmt::format("{:08x}-{:04x}-4{:03x}-8{:03x}-{:012x}", values.high64 >> 32,
                     values.high64 >> 16 & 0xffff, values.high64 & 0xfff, low >> 52, low & 0xffff'ffff'ffff);
}

void write_file(const std::filesystem::path& path, const openvdb::GridCPtrVec& grids,
                const std::string& mark) {
  // Magic number 8 bytes, format 4, library 8, one that says whether there are offsets.
  constexpr std::streamoff mark_offset = 21;
  std::ofstream stream(path, std::ios::binary | std::ios::trunc);
  stream.exceptions(std::ios::failbit | std::ios::badbit);
  GridWriter().write_grids(stream, grids);
  stream.seekp(mark_offset);
  stream.write(mark.data(), static_cast<std::streamsize>(mark.size()));
  stream.close();
}

}  // namespace

void write_vdb(const std::filesystem::path& path, const VdbCloud& cloud, VdbPrecision precision,
               Existing existing) {
  const float most = precision == VdbPrecision::half ? 65504.0f : std::numeric_limits<float>::max();
  std::optional<CloudVolume> fitted;  // few need it
  if (!is_fit(cloud.volume.density, most)) fitted = repaired(path, cloud.volume, most);
  const CloudVolume& volume = fitted ? *fitted : cloud.volume;
  require_valid(volume);
  if (!cloud.albedo.empty() && cloud.albedo.size() != volume.density.size()) {
    throw vdb::bad_vdb(path, "color", "one albedo per density", "others", "make them again");
  }
  AtomicFile file(path, existing);
  vdb::initialize();
  const std::vector<float>& density = volume.density;
  const std::vector<KeptBrick> bricks = kept_bricks(volume);
  openvdb::GridCPtrVec grids;
  const FloatGrid::Ptr density_grid =
      grid_of<FloatGrid>(bricks, density, [&](std::size_t cell) { return density[cell]; });
  place(*density_grid, "density", volume, precision);
  grids.push_back(density_grid);
  if (!cloud.albedo.empty()) {
    const Vec3SGrid::Ptr colour_grid = grid_of<Vec3SGrid>(bricks, density, [&](std::size_t cell) {
      const auto [red, green, blue] = cloud.albedo[cell];
      return openvdb::Vec3s(red, green, blue);
    });
    place(*colour_grid, "color", volume, precision);
    grids.push_back(colour_grid);
  }
  try {
    write_file(file.temporary(), grids, mark_of(cloud, density));
  } catch (const std::exception& failure) {
    throw Error(ErrorKind::file,
                fmt::format("{}: cannot be written: {}", one_line(path.string()), printable(failure.what())),
                "free space on the disk, or write to another one");
  }
  file.commit();
}

}  // namespace offing
