#include "host/cli/terrain_input.h"

#include <CLI/Option.hpp>

namespace offing::cli {

void TerrainInput::add_to(CLI::App& command) {
  command
      .add_option("FILE", file_,
                  "GeoTIFF, SRTM .hgt (.hgt.zip), USGS DEM, ASCII grid, PNG, EXR, .r16, .r32, or another "
                  "raster that GDAL reads")
      ->required()
      ->type_name("");
  flags_.add_to(command);
}

terrain::HeightField make_field(const HeightMap& map, const ocl::Device& device) {
  return {device, terrain::post_grid(map), map.heights_m};
}

}  // namespace offing::cli
