#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <new>
#include <optional>
#include <set>
#include <utility>

#include <fmt/ranges.h>
#include <openvdb/Grid.h>
#include <openvdb/Metadata.h>
#include <openvdb/io/Archive.h>
#include <openvdb/io/GridDescriptor.h>
#include <openvdb/openvdb.h>

#include "host/base/host_memory.h"
#include "host/io/vdb/vdb_check.h"
#include "host/io/vdb/vdb_values.h"
#include "host/io/vdb/vdb_volume.h"

namespace offing {
namespace {

using openvdb::Coord;
using openvdb::CoordBBox;
using vdb::bad_vdb;

constexpr int edge = CloudVolume::brick_cells;
constexpr std::size_t cells = CloudVolume::cells_of_brick;

/// A file of grids, read through a stream that throws where it ends: the library's own readers take what lies
/// beyond the end for values.
class VdbFile : private openvdb::io::Archive {
 public:
  explicit VdbFile(const std::filesystem::path& path) : path_(path) {
    require_file();
    stream_.open(path, std::ios::binary);
    if (!stream_) {
      throw Error(ErrorKind::file, fmt::format("{}: cannot be read", one_line(path.string())),
                  "make it readable");
    }
    require_magic();
    reading("the header", [&](const vdb::PartOfVdb& part) {
      stream_.exceptions(std::ios::failbit | std::ios::badbit | std::ios::eofbit);
      readHeader(stream_);
      setFormatVersion(stream_);
      setLibraryVersion(stream_);
      setDataCompression(stream_);
      require_version();
      vdb::check_metadata(stream_, part);
      openvdb::MetaMap().readMeta(stream_);
    });
  }

  /// The grids of these names that the file has, without a second of the same name.
  std::map<std::string, openvdb::GridBase::Ptr> grids(const std::set<std::string>& wanted) {
    std::map<std::string, openvdb::GridBase::Ptr> found;
    reading("the list of grids", [&](const vdb::PartOfVdb& part) {
      const std::int32_t count = readGridCount(stream_);
      for (std::int32_t i = 0; i < count; ++i) read_grid(part, wanted, found);
    });
    return found;
  }

  /// Of all grids in the file, by the last grids().
  const std::vector<std::string>& names() const { return names_; }

 private:
  void require_file() const {
    std::error_code ignored;
    const std::filesystem::file_status status = std::filesystem::status(path_, ignored);
    if (!std::filesystem::exists(status))
      throw bad_vdb(path_, "", "an OpenVDB file", "none", "check its name");
    if (!std::filesystem::is_regular_file(status)) {
      throw bad_vdb(path_, "", "an OpenVDB file", "a folder or a device", "give the path of a file");
    }
  }

  void require_magic() {
    constexpr std::string_view magic(" BDV\0\0\0\0", 8);
    std::string start(magic.size(), '?');
    stream_.read(start.data(), static_cast<std::streamsize>(start.size()));
    if (start != magic) {
      throw bad_vdb(path_, "", "an OpenVDB file", "something else", "give a .vdb file that OpenVDB wrote");
    }
    stream_.clear();
    stream_.seekg(0);
  }

  void require_version() const {
    if (fileVersion() >= openvdb::OPENVDB_FILE_VERSION_NODE_MASK_COMPRESSION) return;
    throw bad_vdb(path_, "",
                  fmt::format("an OpenVDB file of format {} or later (2013)",
                              static_cast<int>(openvdb::OPENVDB_FILE_VERSION_NODE_MASK_COMPRESSION)),
                  fmt::format("format {}", fileVersion()),
                  "write it again: vdb_tool -read OLD.vdb -write NEW.vdb");
  }

  void read_grid(const vdb::PartOfVdb& list, const std::set<std::string>& wanted,
                 std::map<std::string, openvdb::GridBase::Ptr>& found) {
    openvdb::io::GridDescriptor descriptor;
    vdb::check_descriptor(stream_, list);
    const openvdb::GridBase::Ptr grid = descriptor.read(stream_);
    const std::streamoff begin = stream_.tellg();
    const std::string name = descriptor.gridName();
    names_.push_back(name);
    if (wanted.contains(name) && !found.contains(name)) {
      if (descriptor.isInstance()) {
        throw bad_vdb(path_, name, "a grid of its own",
                      fmt::format("one that shares the values of {}", descriptor.instanceParentName()),
                      "write the file without instances");
      }
      if (inputHasGridOffsets()) descriptor.seekToGrid(stream_);
      read_values(grid, descriptor);
      found.emplace(name, grid);
    } else if (!inputHasGridOffsets()) {
      read_values(grid, descriptor);
    }
    if (!inputHasGridOffsets()) return;
    descriptor.seekToEnd(stream_);
    // Or a crafted list would be read again and again.
    if (stream_.tellg() < begin) {
      throw bad_vdb(path_, fmt::format("grid {}", printable(name)), "an end after its start",
                    "an end before it", "copy or write the file again");
    }
  }

  /// Leaves a grid empty whose type no cloud has.
  void read_values(const openvdb::GridBase::Ptr& grid, const openvdb::io::GridDescriptor& descriptor) {
    const std::string name = printable(descriptor.gridName());
    if (vdb::is_readable(*grid)) {
      reading(fmt::format("grid {}", name), [&](const vdb::PartOfVdb& part) {
        vdb::check_grid(stream_, part, *grid);
        readGrid(grid, descriptor, stream_);
      });
    } else if (!inputHasGridOffsets()) {
      throw bad_vdb(path_, fmt::format("grid {}", name),
                    "float, double or three floats, in a file that is a stream", printable(grid->valueType()),
                    "write the file again: vdb_tool -read OLD.vdb -write NEW.vdb");
    }
  }

  /// Calls `read` and says where what it throws comes from.
  template <typename Read>
  void reading(const std::string& what, const Read& read) {
    const vdb::PartOfVdb part{path_, what};
    const auto broken = [&](std::string_view found) { return vdb::broken_vdb(part, found); };
    try {
      read(part);
    } catch (const Error&) {
      throw;
    } catch (const std::bad_alloc&) {
      throw broken("sizes that do not fit into memory");
    } catch (const std::ios_base::failure&) {
      throw broken("its end");
    } catch (const std::exception& failure) {
      throw broken(printable(failure.what()));
    }
  }

  std::filesystem::path path_;
  std::ifstream stream_;
  std::vector<std::string> names_;
};

/// Makes volumes of grids, brick by brick.
class GridReader {
 public:
  GridReader(const std::filesystem::path& path, std::string_view name, const VdbLimits& limits)
      : path_(path), name_(name), limits_(limits) {}

  template <typename Grid>
  CloudVolume read(const Grid& grid) {
    require_fog(grid);
    if (grid.background() != typename Grid::ValueType(0)) {
      fail("a background of 0", fmt::format("{:g}", static_cast<double>(grid.background())),
           "name a grid that is a density");
    }
    CloudVolume volume;
    find_bricks(grid.tree(), volume);
    place(grid, volume);
    fill(grid.tree(), volume);
    vdb::clamp_density(volume.density, [&](std::size_t i, const char* expected, const char* hint) {
      const Coord cell = cell_of(volume, i);
      fail(fmt::format("{} at cell ({}, {}, {})", expected, cell.x(), cell.y(), cell.z()),
           fmt::format("{:g}", volume.density[i]), hint);
    });
    return volume;
  }

  /// Colours at the cells of a volume that read() made; empty where they lie elsewhere or are none.
  std::vector<std::array<float, 3>> colours(const openvdb::Vec3SGrid& grid,
                                            const openvdb::math::Transform& density_transform,
                                            const CloudVolume& volume) const {
    if (grid.transform() != density_transform) return {};
    require_memory(sizeof(std::array<float, 3>) * static_cast<double>(volume.density.size()));
    std::vector<std::array<float, 3>> albedo(volume.density.size());
    openvdb::Vec3SGrid::ConstAccessor accessor = grid.getConstAccessor();
    for (std::size_t i = 0; i < albedo.size(); ++i) {
      const openvdb::Vec3s value = accessor.getValue(cell_of(volume, i));
      for (int channel = 0; channel < 3; ++channel) {
        const float share = value[channel];
        albedo[i][static_cast<std::size_t>(channel)] = share > 0.0f ? std::min(share, 1.0f) : 0.0f;
      }
    }
    return albedo;
  }

 private:
  [[noreturn]] void fail(std::string_view expected, std::string_view got, std::string hint) const {
    throw bad_vdb(path_, name_, expected, got, std::move(hint));
  }

  void require_memory(double bytes) const {
    require_host_memory(bytes, fmt::format("{}: {}: its bricks", one_line(path_.string()), name_),
                        "resample it to larger cells, or cut it");
  }

  void require_fog(const openvdb::GridBase& grid) const {
    if (grid.getGridClass() == openvdb::GRID_LEVEL_SET) {
      fail("a fog volume", "a level set", "convert it to a fog volume first");
    }
  }

  /// Index of the brick of each leaf and each active tile, and the box around them.
  template <typename Tree>
  void find_bricks(const Tree& tree, const CloudVolume&) {
    for (auto leaf = tree.cbeginLeaf(); leaf; ++leaf) add_brick(brick_at(leaf->origin()));
    typename Tree::ValueOnCIter tile = tree.cbeginValueOn();
    tile.setMaxDepth(Tree::ValueOnCIter::LEAF_DEPTH - 1);
    for (; tile; ++tile) {
      if (tile.getValue() == typename Tree::ValueType(0)) continue;
      const CoordBBox box = tile.getBoundingBox();
      const std::size_t bricks = static_cast<std::size_t>(box.volume()) / cells;
      if (bricks + bricks_.size() <= limits_.bricks)
        add_tile(box);
      else
        refuse_size(bricks + bricks_.size());
    }
    if (bricks_.empty()) fail("values", "an empty grid", "write the grid again, or name another");
  }

  void add_tile(const CoordBBox& box) {
    const Coord low = brick_at(box.min()), high = brick_at(box.max());
    for (int z = low.z(); z <= high.z(); ++z) {
      for (int y = low.y(); y <= high.y(); ++y) {
        for (int x = low.x(); x <= high.x(); ++x) add_brick({x, y, z});
      }
    }
  }

  void add_brick(const Coord& brick) {
    if (bricks_.size() == limits_.bricks) refuse_size(bricks_.size() + 1);
    bricks_.push_back(brick);
    box_.expand(brick);
  }

  [[noreturn]] void refuse_size(std::size_t bricks) const {
    fail(fmt::format("at most {} bricks of 8^3 cells with a value", limits_.bricks),
         fmt::format("{} or more", bricks), "resample it to larger cells, or cut it");
  }

  static Coord brick_at(const Coord& cell) {
    const auto down = [](int value) { return value >> 3; };  // rounded toward -infinity
    static_assert(edge == 1 << 3);
    return {down(cell.x()), down(cell.y()), down(cell.z())};
  }

  Coord cell_of(const CloudVolume&, std::size_t value) const {
    const Coord brick = bricks_[value / cells];
    const int inside = static_cast<int>(value % cells);
    return {edge * brick.x() + inside % edge, edge * brick.y() + inside / edge % edge,
            edge * brick.z() + inside / (edge * edge)};
  }

  /// Where the volume is, and which brick is where in it.
  void place(const openvdb::GridBase& grid, CloudVolume& volume) {
    const double scale = cube_edge_m(grid);
    widen_to_all(grid);
    const Coord low = box_.min();
    const openvdb::Vec3d first =
        grid.transform().indexToWorld(Coord(edge * low.x(), edge * low.y(), edge * low.z()));
    volume.cell_m = scale;
    volume.origin_m = glm::dvec3(first.x(), first.y(), first.z()) - 0.5 * scale;
    const std::array<double, 3> bricks{box_.extents().x() + 0.0, box_.extents().y() + 0.0,
                                       box_.extents().z() + 0.0};
    if (bricks[0] * bricks[1] * bricks[2] > static_cast<double>(limits_.places)) {
      fail(fmt::format("values within a box of at most {} bricks of 8^3 cells", limits_.places),
           fmt::format("{:.0f} x {:.0f} x {:.0f}", bricks[0], bricks[1], bricks[2]),
           "resample it to larger cells, or cut off what lies far away");
    }
    require_memory(sizeof(std::int32_t) * bricks[0] * bricks[1] * bricks[2] +
                   sizeof(float) * static_cast<double>(cells * bricks_.size()));
    volume.bricks = {box_.extents().x(), box_.extents().y(), box_.extents().z()};
    volume.extinction_per_m = extinction_of(grid);
    const auto [nx, ny, nz] = volume.bricks;
    volume.brick_of.assign(static_cast<std::size_t>(nx) * ny * nz, CloudVolume::no_brick);
    for (std::size_t i = 0; i < bricks_.size(); ++i) {
      const Coord at = bricks_[i] - low;
      const std::size_t row = static_cast<std::size_t>(at.z()) * ny + at.y();
      volume.brick_of[row * nx + at.x()] = static_cast<std::int32_t>(i);
    }
  }

  double cube_edge_m(const openvdb::GridBase& grid) const {
    const char* hint = "resample it to cubes along x, y and z";
    if (!grid.transform().isLinear()) fail("cells that are cubes", "a perspective", hint);
    // Not its affine map: the making of one whose cells are too small to have an inverse ends the process.
    const openvdb::math::MapBase& map = *grid.transform().baseMap();
    const double scale = map.applyJacobian(openvdb::Vec3d(1.0, 0.0, 0.0)).x();
    constexpr double tolerance = 1e-5;  // of transforms that were written as floats
    if (!(scale > 0.0) || !std::isfinite(scale))
      fail("cells of a size above 0", fmt::format("{:g}", scale), hint);
    for (int row = 0; row < 3; ++row) {
      openvdb::Vec3d axis(0.0);
      axis[row] = 1.0;
      const openvdb::Vec3d along = map.applyJacobian(axis);
      for (int column = 0; column < 3; ++column) {
        const double due = row == column ? scale : 0.0;
        if (!(std::abs(along[column] - due) <= tolerance * scale)) {
          fail("cells that are cubes along the axes", "others", hint);
        }
      }
    }
    const openvdb::Vec3d origin = map.applyMap(openvdb::Vec3d(0.0));
    if (!std::isfinite(origin.x()) || !std::isfinite(origin.y()) || !std::isfinite(origin.z()))
      fail("a finite place", "another", hint);
    return scale;
  }

  /// A file of ours says how large the volume was.
  void widen_to_all(const openvdb::GridBase& grid) {
    const auto all = grid.getMetadata<openvdb::Vec3IMetadata>(vdb::bricks_name);
    if (!all) return;
    const openvdb::Vec3i bricks = all->value();
    const CoordBBox whole(Coord(0), Coord(bricks.x() - 1, bricks.y() - 1, bricks.z() - 1));
    if (!whole.empty() && whole.isInside(box_)) box_ = whole;
  }

  double extinction_of(const openvdb::GridBase& grid) const {
    const auto told = grid.getMetadata<openvdb::DoubleMetadata>(vdb::extinction_name);
    if (!told) return 1.0;
    if (!(told->value() > 0.0) || !std::isfinite(told->value())) {
      fail(fmt::format("{} above 0", vdb::extinction_name), fmt::format("{:g}", told->value()),
           "write the file again");
    }
    return told->value();
  }

  template <typename Tree>
  void fill(const Tree& tree, CloudVolume& volume) const {
    volume.density.resize(bricks_.size() * cells);
    std::size_t next = 0;
    for (auto leaf = tree.cbeginLeaf(); leaf; ++leaf, ++next) {
      for (openvdb::Index offset = 0; offset < cells; ++offset) {
        volume.density[next * cells + vdb::place_in_brick(offset)] =
            static_cast<float>(leaf->getValue(offset));
      }
    }
    // What follows are bricks of tiles, each of one value.
    for (; next < bricks_.size(); ++next) {
      const Coord& brick = bricks_[next];
      const auto value =
          static_cast<float>(tree.getValue(Coord(edge * brick.x(), edge * brick.y(), edge * brick.z())));
      std::fill_n(volume.density.begin() + static_cast<std::ptrdiff_t>(next * cells), cells, value);
    }
  }

  const std::filesystem::path& path_;
  std::string name_;
  VdbLimits limits_;
  std::vector<Coord> bricks_;  // leaves in the order of their tree, then those of tiles
  CoordBBox box_;
};

}  // namespace

VdbCloud read_vdb(const std::filesystem::path& path, std::string_view grid, const VdbLimits& limits) {
  vdb::initialize();
  VdbFile file(path);
  const std::string name(grid);
  const auto grids = file.grids({name, "color", "Cd"});
  const auto found = grids.find(name);
  if (found == grids.end()) {
    std::vector<std::string> names;
    for (const std::string& each : file.names()) names.push_back(printable(each));
    throw bad_vdb(path, "", fmt::format("a grid {}", name),
                  names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", ")),
                  "name one of its grids");
  }
  GridReader reader(path, name, limits);
  VdbCloud cloud;
  cloud.tells_extinction = bool(found->second->getMetadata<openvdb::DoubleMetadata>(vdb::extinction_name));
  if (const auto floats = openvdb::gridPtrCast<openvdb::FloatGrid>(found->second)) {
    cloud.volume = reader.read(*floats);
  } else if (const auto doubles = openvdb::gridPtrCast<openvdb::DoubleGrid>(found->second)) {
    cloud.volume = reader.read(*doubles);
  } else {
    throw bad_vdb(path, name, "a grid of float or double", printable(found->second->valueType()),
                  "name a grid that is a density");
  }
  for (const char* colour : {"color", "Cd"}) {
    const auto colours = grids.find(colour);
    if (!cloud.albedo.empty() || colours == grids.end()) continue;
    if (const auto vectors = openvdb::gridPtrCast<openvdb::Vec3SGrid>(colours->second)) {
      cloud.albedo = reader.colours(*vectors, found->second->transform(), cloud.volume);
    }
  }
  return cloud;
}

}  // namespace offing
