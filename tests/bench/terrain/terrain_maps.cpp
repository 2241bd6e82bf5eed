// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include "tests/bench/terrain/terrain_maps.h"

#include <cstdlib>
#include <filesystem>

#include "host/io/height_maps/read_height_map.h"
#include "host/terrain/generate/fractal_terrain.h"

namespace offing::bench {

NamedMap valleys(int size) {
  const terrain::FractalParameters parameters{.posts = size + 1, .side_m = 20'480.0};
  terrain::FractalTerrain terrain(parameters);
  HeightMap map;
  map.columns = map.rows = parameters.posts;
  map.spacing_x_m = map.spacing_z_m = parameters.side_m / size;
  map.heights_m.resize(map.index(0, map.rows));
  for (int row = 0; row < map.rows; ++row) {
    terrain.fill_row(
        row, std::span(map.heights_m).subspan(map.index(0, row), static_cast<std::size_t>(map.columns)));
  }
  return {"valleys", std::move(map)};
}

std::vector<NamedMap> real_maps(RealMaps which) {
  const char* folder = std::getenv("OFFING_TEST_DATA");
  if (folder == nullptr) return {};
  const std::filesystem::path terrain = std::filesystem::path(folder) / "terrain";
  HeightMapOptions andes;
  andes.raw_columns = andes.raw_rows = 1025;
  andes.vertical_scale = 0.1;
  andes.spacing_x_m = andes.spacing_z_m = 75.0;
  std::vector<NamedMap> maps;
  maps.push_back({"andes", read_height_map(terrain / "andes_1025_75m.r16", andes).map});
  maps.push_back({"cape_flattery", read_height_map(terrain / "N48W125.hgt.zip").map});
  if (which == RealMaps::all) {
    for (const char* name : {"N42E001.hgt.zip", "S33W071.tif", "SainteHelens.dem"}) {
      maps.push_back({name, read_height_map(terrain / name).map});
    }
  }
  return maps;
}

}  // namespace offing::bench
