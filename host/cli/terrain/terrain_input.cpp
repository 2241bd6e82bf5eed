#include "host/cli/terrain/terrain_input.h"

#include <CLI/Option.hpp>
#include <fmt/format.h>

#include "host/base/error.h"
#include "host/command_line/general_flags.h"
#include "host/io/tile_store/tile_store.h"

namespace offing::cli {

void TerrainInput::add_to(CLI::App& command) {
  command
      .add_option("FILE", file_,
                  "GeoTIFF, SRTM .hgt (.hgt.zip), USGS DEM, ASCII grid, PNG, EXR, .r16, .r32, or another "
                  "raster of docs/terrain.md; or a tile store")
      ->required()
      ->type_name("");
  flags_.add_to(command);
  add_trust_flag(command, trust_);
}

HeightMapOptions TerrainInput::options() const {
  HeightMapOptions options = flags_.read();
  options.trust.trust = trust_;
  return options;
}

HeightMapFile TerrainInput::read() const {
  if (is_tile_store(file_)) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected a height map, found a tile store", one_line(file_)),
                "give this command the map that it was made of");
  }
  HeightMapFile file = read_height_map(file_, options());
  warn_of_assumed_spacing(file_, file.source);
  return file;
}

terrain::HeightField make_field(const HeightMap& map, const ocl::Device& device) {
  return {device, terrain::post_grid(map), map.heights_m};
}

}  // namespace offing::cli
