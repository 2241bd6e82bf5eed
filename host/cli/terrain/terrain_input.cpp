#include "host/cli/terrain/terrain_input.h"

#include <charconv>
#include <cstdint>
#include <string_view>

#include <CLI/Option.hpp>
#include <fmt/format.h>

#include "host/base/argument.h"
#include "host/base/error.h"
#include "host/command_line/general_flags.h"
#include "host/io/tile_store/tile_store.h"

namespace offing::cli {
namespace {

/// A value that marks voids: any number, also nan.
double read_nodata(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) {
    throw bad_argument("--nodata", "a number, nan or inf", text, "-9999");
  }
  return value;
}

int read_side(std::string_view text) {
  const auto most = static_cast<std::int64_t>(like_scene("terrain.raw_columns", "--raw-size").high);
  return static_cast<int>(read_whole("--raw-size", text, 1, most, "1025x1025"));
}

}  // namespace

void HeightMapFlags::add_to(CLI::App& command) {
  using Map = HeightMapOptions;
  constexpr auto map = &Settings::map;
  constexpr const char* heights = "Heights";
  options_.add_to(
      command,
      {{scene::choice(scene::path(map, &Map::encoding), names_in_scene("terrain.encoding")),
        like_scene("terrain.encoding", "--encoding")},
       {scene::path(map, &Map::vertical_scale), like_scene("terrain.vertical_scale", "--scale")},
       {scene::path(map, &Map::offset_m), like_scene("terrain.offset_m", "--offset-m")},
       {scene::path(map, &Map::band), like_scene("terrain.band", "--band")},
       {scene::path(map, &Map::exr_channel),
        {.key = "channel",
         .help = "channel of an EXR that holds the heights",
         .example = "Y",
         .absent = "the only one, or height, Y, Z, R",
         .rule = scene::ParameterRule::name}},
       {scene::path(map, &Map::void_height_m), like_scene("terrain.void_height_m", "--void-height-m")}},
      heights);
  command.add_option("--nodata", nodata_, "additional value that marks voids in the file; may be nan")
      ->type_name("V")
      ->group(heights);
  constexpr const char* place = "Spacing";
  options_.add_to(
      command,
      {{&Settings::spacing_m, like_scene("terrain.spacing_x_m", "--spacing-m", "distance between posts")},
       {scene::path(map, &Map::spacing_x_m), like_scene("terrain.spacing_x_m", "--spacing-x-m")},
       {scene::path(map, &Map::spacing_z_m), like_scene("terrain.spacing_z_m", "--spacing-z-m")},
       {scene::choice(scene::path(map, &Map::horizontal_unit), names_in_scene("terrain.horizontal_unit")),
        like_scene("terrain.horizontal_unit", "--unit")},
       {scene::path(map, &Map::reproject_to),
        {.key = "reproject",
         .help = "resample to metres in this coordinate system: utm, or a name such as EPSG:32719",
         .example = "utm",
         .absent = "no resampling",
         .rule = scene::ParameterRule::name}}},
      place);
  CLI::Option* both = command.get_option("--spacing-m");
  for (const char* one : {"--spacing-x-m", "--spacing-z-m"}) command.get_option(one)->excludes(both);
  constexpr const char* raw = "Files without a header (.r16, .r32, .raw, .bin)";
  command.add_option("--raw-size", raw_size_, "number of posts along x and z")->type_name("WxH")->group(raw);
  options_.add_to(
      command,
      {{scene::choice_or("by_name", scene::path(map, &Map::raw_type), {"u16", "s16", "f32"}),
        like_scene("terrain.raw_type", "--raw-type")},
       {scene::choice(scene::path(map, &Map::raw_byte_order), names_in_scene("terrain.raw_order")),
        like_scene("terrain.raw_order", "--raw-order")}},
      raw);
}

bool HeightMapFlags::are_given() const {
  return options_.are_given() || !nodata_.empty() || !raw_size_.empty();
}

HeightMapOptions HeightMapFlags::read() const {
  const Settings settings = options_.read();
  HeightMapOptions options = settings.map;
  if (settings.spacing_m) options.spacing_x_m = options.spacing_z_m = settings.spacing_m;
  if (!nodata_.empty()) options.nodata = read_nodata(nodata_);
  if (!raw_size_.empty()) {
    const std::size_t cross = raw_size_.find('x');
    if (cross == std::string::npos) {
      throw bad_argument("--raw-size", "COLUMNSxROWS", raw_size_, "1025x1025");
    }
    const std::string_view text = raw_size_;
    options.raw_columns = read_side(text.substr(0, cross));
    options.raw_rows = read_side(text.substr(cross + 1));
  }
  return options;
}

void TerrainInput::add_to(CLI::App& command) {
  command
      .add_option("FILE", file_,
                  "height map: GeoTIFF, SRTM .hgt (.hgt.zip), USGS DEM, ASCII grid, PNG, EXR, .r16, .r32 or "
                  "another format of docs/terrain.md; or a tile store")
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
                "give this command the map from which the store was made");
  }
  HeightMapFile file = read_height_map(file_, options());
  warn_of_assumed_spacing(file_, file.source);
  return file;
}

terrain::HeightField make_field(const HeightMap& map, const ocl::Device& device) {
  return {device, terrain::post_grid(map), map.heights_m};
}

}  // namespace offing::cli
