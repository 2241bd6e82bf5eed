#include "host/terrain/lakes/lake_layer.h"

#include <algorithm>
#include <cstddef>

#include "host/ocl/program.h"

namespace offing::terrain {

LakeLayer::LakeLayer(const ocl::Device& device, const std::vector<std::shared_ptr<const Lake>>& lakes)
    : device_(device),
      planes_kernel_(
          ocl::Program::build(device, "terrain/lakes/lake_planes.cl", ocl::Defines().set("LANES", 1))
              .kernel("lake_planes")),
      waters_(device, lakes.size(), "lakes"),
      waves_(device, 1, "waves of lakes") {
  std::vector<std::uint8_t> cells;
  for (const auto& lake : lakes) {
    LakeWater& box = boxes_.emplace_back();
    box.level_m = static_cast<float>(lake->level_m);
    box.first_x = lake->first_column;
    box.first_z = lake->first_row;
    box.columns = lake->columns - 1;
    box.rows = lake->rows - 1;
    box.first_byte = static_cast<int>(cells.size());
    for (int row = lake->first_row; row + 1 < lake->first_row + lake->rows; ++row) {
      for (int column = lake->first_column; column + 1 < lake->first_column + lake->columns; ++column) {
        const bool has_water = lake->is_wet_at(column, row) || lake->is_wet_at(column + 1, row) ||
                               lake->is_wet_at(column, row + 1) || lake->is_wet_at(column + 1, row + 1);
        cells.push_back(has_water ? 1 : 0);
      }
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

void LakeLayer::stand_before(const TerrainField& field, const TerrainView& view,
                             const ocl::Buffer<TerrainHit>& hits, ocl::Buffer<float>& distances_m) const {
  planes_kernel_.launch({{static_cast<std::size_t>(view.width_px), static_cast<std::size_t>(view.height_px)}},
                        field, view, hits, waters_, cells_, count(), distances_m);
}

}  // namespace offing::terrain
