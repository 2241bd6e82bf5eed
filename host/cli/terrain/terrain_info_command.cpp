// `offing terrain info`: what a height map or a tile store holds.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glm/vec2.hpp>
#include <nlohmann/json.hpp>

#include "host/base/error.h"
#include "host/cli/terrain/place_system.h"
#include "host/cli/terrain/terrain_commands.h"
#include "host/cli/terrain/terrain_input.h"
#include "host/cli/terrain/terrain_place.h"
#include "host/command_line/print_results.h"
#include "host/io/tile_store/tile_store.h"
#include "host/scene/prepare/stored_terrain.h"

namespace offing::cli {
namespace {

enum class InfoStyle { text, json };

/// The corners of a map in a system, from the north-west clockwise.
struct Corners {
  std::string system;
  std::vector<glm::dvec2> places;
};

/// In local metres and in the systems that the map's file allows: its own, longitude and latitude, and what
/// --crs names. Throws what PlaceSystem throws for that one.
std::vector<Corners> corners_of(const MapFrame& map, const std::string& asked) {
  const double width_m = map.spacing_x_m * (map.columns - 1), depth_m = map.spacing_z_m * (map.rows - 1);
  const std::vector<glm::dvec2> local{{0.0, 0.0}, {width_m, 0.0}, {width_m, depth_m}, {0.0, depth_m}};
  std::vector<std::string> systems{local_places};
  if (map.georeference.step_x != 0.0) systems.emplace_back(map_places);
  if (!map.georeference.coordinate_system.empty()) systems.emplace_back(lonlat_places);
  if (std::ranges::find(systems, asked) == systems.end()) systems.push_back(asked);
  std::vector<Corners> corners;
  for (const std::string& system : systems) {
    try {
      corners.push_back({system, PlaceSystem(map, system).of_map(local)});
    } catch (const Error&) {
      // A system that is nowhere on the Earth, as that of generated terrain.
      if (system == asked) throw;
    }
  }
  return corners;
}

nlohmann::ordered_json corners_json(const std::vector<Corners>& all) {
  nlohmann::ordered_json json;
  for (const Corners& corners : all) {
    for (const glm::dvec2& place : corners.places) {
      json[corners.system].push_back(std::isnan(place.x) ? nlohmann::ordered_json()
                                                         : nlohmann::ordered_json{place.x, place.y});
    }
  }
  return json;
}

void print_corners(const std::vector<Corners>& all) {
  const std::array names{"north-west", "north-east", "south-east", "south-west"};
  for (std::size_t corner = 0; corner < names.size(); ++corner) {
    std::string text;
    for (const Corners& corners : all) {
      const glm::dvec2 place = corners.places[corner];
      // A hundredth of a millimetre of a degree, and a millimetre of what is likely to be a metre.
      text +=
          std::isnan(place.x) ? fmt::format("{}{}: none", text.empty() ? "" : "; ", one_line(corners.system))
          : corners.system == lonlat_places ? fmt::format("; lonlat {:.10f}, {:.10f}", place.x, place.y)
                                            : fmt::format("{}{} {:.12g}, {:.12g}", text.empty() ? "" : "; ",
                                                          one_line(corners.system), place.x, place.y);
    }
    fmt::print("  {:<10} {}: {}\n", corner == 0 ? "corners" : "", names[corner], text);
  }
}

/// Prints what a tile store says of its map, as `offing terrain info` does of other maps.
void print_store_info(const std::string& folder, const std::string& crs, InfoStyle style) {
  const TileStoreHeader header = TileStore(folder).header();
  const std::vector<Corners> corners = corners_of(frame_of(folder, scene::place_of(header)), crs);
  const TileSetShape& shape = header.shape;
  const double width_m = header.spacing_x_m * (shape.columns - 1),
               depth_m = header.spacing_z_m * (shape.rows - 1);
  if (style == InfoStyle::json) {
    nlohmann::ordered_json json = {{"file", folder},
                                   {"format", "tile store"},
                                   {"columns", shape.columns},
                                   {"rows", shape.rows},
                                   {"spacing_x_m", header.spacing_x_m},
                                   {"spacing_z_m", header.spacing_z_m},
                                   {"extent_x_m", width_m},
                                   {"extent_z_m", depth_m},
                                   {"lowest_m", header.lowest_m},
                                   {"highest_m", header.highest_m},
                                   {"void_posts", header.void_posts},
                                   {"levels", shape.levels},
                                   {"tiles", shape.tile_count()},
                                   {"heights_checksum", fmt::format("{:016x}", header.heights_checksum)}};
    const auto or_null = [](const std::optional<double>& value) {
      return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
    };
    json["centre_latitude_deg"] = or_null(header.centre_latitude_deg);
    json["centre_longitude_deg"] = or_null(header.centre_longitude_deg);
    json["corners"] = corners_json(corners);
    print_json(json);
    return;
  }
  fmt::print("{}: tile store, {} tiles of {} levels\n", one_line(folder), shape.tile_count(), shape.levels);
  fmt::print("  posts      {} x {}\n", shape.columns, shape.rows);
  fmt::print("  spacing    {:.6g} m along x, {:.6g} m along z\n", header.spacing_x_m, header.spacing_z_m);
  fmt::print("  extent     {:.6g} m x {:.6g} m\n", width_m, depth_m);
  fmt::print("  heights    {:g} ... {:g} m\n", header.lowest_m, header.highest_m);
  fmt::print("  voids      {}\n",
             header.void_posts == 0 ? "none" : fmt::format("{} posts, filled", header.void_posts));
  if (header.centre_latitude_deg && header.centre_longitude_deg) {
    fmt::print("  centre     {:.6f} N, {:.6f} E\n", *header.centre_latitude_deg,
               *header.centre_longitude_deg);
  }
  print_corners(corners);
}

struct TerrainInfoArguments {
  TerrainInput input;
  PlaceFlags places;
  bool json = false;
};

const char* name_of(SpacingSource source) {
  switch (source) {
    case SpacingSource::file:
      return "file";
    case SpacingSource::latitude:
      return "latitude";
    case SpacingSource::mercator:
      return "mercator";
    case SpacingSource::reprojected:
      return "reprojected";
    case SpacingSource::options:
      return "options";
    case SpacingSource::assumed:
      return "assumed";
  }
  return "";
}

std::string explanation(const HeightMapSource& source) {
  switch (source.spacing_source) {
    case SpacingSource::file:
      return "from the file";
    case SpacingSource::latitude:
      return "degrees, in metres at the latitude of the middle row";
    case SpacingSource::mercator:
      return fmt::format("from the file, divided by the Mercator scale {:.5g} at the middle row",
                         source.projection_scale);
    case SpacingSource::reprojected:
      return "resampled to metres";
    case SpacingSource::options:
      return "as asked";
    case SpacingSource::assumed:
      return "assumed, because the file gives none; set it with --spacing-m";
  }
  return "";
}

const char* name_of(SampleExtent extent) {
  return extent == SampleExtent::area ? "area" : extent == SampleExtent::point ? "point" : "unknown";
}

const char* name_of(const HeightMapOptions& options) {
  return options.void_height_m ? "constant" : "pull-push";
}

nlohmann::ordered_json info_json(const TerrainInfoArguments& arguments, const HeightMapOptions& options,
                                 const HeightMapFile& file, const std::vector<Corners>& corners) {
  const auto& [map, source] = file;
  const auto or_null = [](const std::optional<double>& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
  };
  nlohmann::ordered_json json = {{"file", arguments.input.file()},
                                 {"format", source.format},
                                 {"sample_type", source.sample_type},
                                 {"sample_extent", name_of(source.sample_extent)},
                                 {"columns", map.columns},
                                 {"rows", map.rows},
                                 {"spacing_x_m", map.spacing_x_m},
                                 {"spacing_z_m", map.spacing_z_m},
                                 {"spacing_source", name_of(source.spacing_source)},
                                 {"projection_scale", source.projection_scale},
                                 {"extent_x_m", map.spacing_x_m * (map.columns - 1)},
                                 {"extent_z_m", map.spacing_z_m * (map.rows - 1)},
                                 {"lowest_m", source.lowest_m},
                                 {"highest_m", source.highest_m},
                                 {"void_posts", source.void_posts},
                                 {"void_area_m2", source.void_area_m2}};
  json["void_fill"] =
      source.void_posts > 0 ? nlohmann::ordered_json(name_of(options)) : nlohmann::ordered_json();
  json["coordinate_system"] = source.coordinate_system.empty()
                                  ? nlohmann::ordered_json()
                                  : nlohmann::ordered_json(source.coordinate_system);
  json["first_post"] = map.georeference.step_x == 0.0
                           ? nlohmann::ordered_json()
                           : nlohmann::ordered_json{map.georeference.origin_x, map.georeference.origin_y};
  json["centre_latitude_deg"] = or_null(source.centre_latitude_deg);
  json["centre_longitude_deg"] = or_null(source.centre_longitude_deg);
  json["corners"] = corners_json(corners);
  return json;
}

void print_text(const TerrainInfoArguments& arguments, const HeightMapOptions& options,
                const HeightMapFile& file, const std::vector<Corners>& corners) {
  const auto& [map, source] = file;
  constexpr double m2_a_km2 = 1e6;
  const auto line = [](const char* label, const std::string& text) {
    fmt::print("  {:<10} {}\n", label, text);
  };
  fmt::print("{}: {}, {}\n", one_line(arguments.input.file()), source.format, source.sample_type);
  line("posts", fmt::format("{} x {}", map.columns, map.rows));
  line("spacing", fmt::format("{:.6g} m along x, {:.6g} m along z ({})", map.spacing_x_m, map.spacing_z_m,
                              explanation(source)));
  line("extent", fmt::format("{:.6g} m x {:.6g} m", map.spacing_x_m * (map.columns - 1),
                             map.spacing_z_m * (map.rows - 1)));
  line("heights", fmt::format("{:g} ... {:g} m", source.lowest_m, source.highest_m));
  line("voids", source.void_posts == 0
                    ? "none"
                    : fmt::format("{} post{}, {:.4g} km^2, {}", source.void_posts,
                                  source.void_posts == 1 ? "" : "s", source.void_area_m2 / m2_a_km2,
                                  options.void_height_m ? fmt::format("set to {:g} m", *options.void_height_m)
                                                        : "filled from the posts around them (pull-push)"));
  if (map.georeference.step_x != 0.0) {
    line("place", fmt::format("first post at {:.10g}, {:.10g} in {}", map.georeference.origin_x,
                              map.georeference.origin_y,
                              source.coordinate_system.empty() ? "a system without name"
                                                               : one_line(source.coordinate_system)));
  }
  if (source.centre_latitude_deg) {
    line("centre",
         fmt::format("{:.6f} N, {:.6f} E", *source.centre_latitude_deg, *source.centre_longitude_deg));
  }
  print_corners(corners);
}

void run(const TerrainInfoArguments& arguments) {
  if (is_tile_store(arguments.input.file())) {
    print_store_info(arguments.input.file(), arguments.places.system(),
                     arguments.json ? InfoStyle::json : InfoStyle::text);
    return;
  }
  const HeightMapOptions options = arguments.input.options();
  const HeightMapFile file = arguments.input.read();
  const std::vector<Corners> corners =
      corners_of(frame_of(arguments.input.file(), file.map), arguments.places.system());
  if (arguments.json) {
    print_json(info_json(arguments, options, file, corners));
  } else {
    print_text(arguments, options, file, corners);
  }
}

}  // namespace

void add_terrain_info_command(CLI::App& terrain, GlobalOptions& options) {
  const auto arguments = std::make_shared<TerrainInfoArguments>();
  CLI::App* command =
      terrain.add_subcommand("info", "print size, spacing, heights, voids and place of a height map");
  arguments->input.add_to(*command);
  arguments->places.add_to(*command);
  command->add_flag("--json", arguments->json, "print the results as JSON");
  add_global_options(*command, options, DeviceUse::none);
  command->footer(R"(
FILE may also be a tile store made by `offing terrain tile`.

The corners are printed in local metres, the map's own coordinates, longitude and latitude, and the system of
--crs.

Voids are posts without a height. They are filled from the posts around them and stay marked as voids.

Examples:
  offing terrain info N42E001.hgt.zip
  offing terrain info tile.png --encoding terrarium --spacing-m 75 --json
  offing terrain info heights.r16 --raw-size 1025x1025 --scale 0.1 --spacing-m 75)");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace offing::cli
