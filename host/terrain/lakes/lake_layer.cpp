#include "host/terrain/lakes/lake_layer.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/ocl/program.h"
#include "host/terrain/cast/image_rays.h"
#include "host/terrain/field/height_field.h"
#include "host/terrain/tiles/tiled_field.h"

namespace offing::terrain {
namespace {

/// As kernels/shared/lakes.h has them.
std::uint8_t cell_flags(const Lake& lake, int column, int row) {
  int flags = 0;
  for (int corner = 0; corner < 4; ++corner) {
    const int x = column + corner % 2, z = row + corner / 2;
    if (lake.is_wet_at(x, z)) flags |= LAKE_CELL_WET;
    if (lake.is_near(x, z)) flags |= 1 << (LAKE_NEAR_SHIFT + corner);
  }
  return static_cast<std::uint8_t>(flags);
}

/// The lake's box, and a cell more on each side; from byte 0 on.
LakeWater box_of(const Lake& lake) {
  LakeWater box{};
  box.level_m = static_cast<float>(lake.level_m);
  box.first_x = lake.first_column - 1;
  box.first_z = lake.first_row - 1;
  box.columns = lake.columns + 1;
  box.rows = lake.rows + 1;
  return box;
}

}  // namespace

LakeLayer::LakeLayer(const ocl::Device& device, const std::vector<std::shared_ptr<const Lake>>& lakes)
    : device_(device),
      planes_kernel_(
          ocl::Program::build(device, "terrain/lakes/lake_planes.cl", ocl::Defines().set("LANES", 1))
              .kernel("lake_planes")),
      waters_(device, lakes.size(), "lakes"),
      waves_(device, 1, "waves of lakes") {
  constexpr std::int64_t most_bytes = std::numeric_limits<int>::max();
  std::int64_t bytes = 0;
  for (const auto& lake : lakes) {
    LakeWater& box = boxes_.emplace_back(box_of(*lake));
    box.first_byte = static_cast<int>(bytes);
    bytes += static_cast<std::int64_t>(box.columns) * box.rows;
    if (bytes > most_bytes) {
      throw Error(
          ErrorKind::bad_input,
          fmt::format("lakes: expected boxes around them of at most {} cells in all, found more", most_bytes),
          "leave out a large lake, or use a coarser map");
    }
  }
  std::vector<std::uint8_t> cells;
  cells.reserve(static_cast<std::size_t>(bytes));
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    const LakeWater& box = boxes_[i];
    for (int row = box.first_z; row < box.first_z + box.rows; ++row) {
      for (int column = box.first_x; column < box.first_x + box.columns; ++column)
        cells.push_back(cell_flags(*lakes[i], column, row));
    }
  }
  cells_ = ocl::Buffer<std::uint8_t>(device, cells, "cells of lakes");
  waters_.write(boxes_);
}

void LakeLayer::set_looks(std::span<const LakeLook> looks) {
  std::vector<LakeWater> waters;
  std::vector<LakeWave> waves;
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    LakeWater water = looks[i].water;
    const LakeWater& box = boxes_[i];
    water.level_m = box.level_m;
    water.first_x = box.first_x;
    water.first_z = box.first_z;
    water.columns = box.columns;
    water.rows = box.rows;
    water.first_byte = box.first_byte;
    water.first_wave = static_cast<int>(waves.size());
    water.wave_count = static_cast<int>(looks[i].waves.size());
    waters.push_back(water);
    waves.insert(waves.end(), looks[i].waves.begin(), looks[i].waves.end());
  }
  waters_.write(waters);
  if (waves.empty()) return;
  if (waves_.size() < waves.size()) waves_ = ocl::Buffer<LakeWave>(device_, waves.size(), "waves of lakes");
  waves_.write(waves);
}

void LakeLayer::stand_before(const HeightField& field, const Camera& camera,
                             const ocl::Buffer<TerrainHit>& hits, ocl::Buffer<float>& distances_m) const {
  stand_before(field.device_field(CastMethod::parity), device_view(camera, field.grid()), hits, distances_m);
}

void LakeLayer::stand_before(const TiledField& field, const Camera& camera,
                             const ocl::Buffer<TerrainHit>& hits, ocl::Buffer<float>& distances_m) const {
  stand_before(field.device_field(), field.device_view(camera), hits, distances_m);
}

void LakeLayer::stand_before(const TerrainField& field, const TerrainView& view,
                             const ocl::Buffer<TerrainHit>& hits, ocl::Buffer<float>& distances_m) const {
  planes_kernel_.launch({{static_cast<std::size_t>(view.width_px), static_cast<std::size_t>(view.height_px)}},
                        field, view, hits, waters_, cells_, count(), distances_m);
}

}  // namespace offing::terrain
