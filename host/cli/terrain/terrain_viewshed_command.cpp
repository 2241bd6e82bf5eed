#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/cli/common/device_choice.h"
#include "host/cli/terrain/earth_curve_flags.h"
#include "host/cli/terrain/place_system.h"
#include "host/cli/terrain/store_flags.h"
#include "host/cli/terrain/terrain_commands.h"
#include "host/cli/terrain/terrain_place.h"
#include "host/command_line/new_output.h"
#include "host/command_line/print_results.h"
#include "host/command_line/setting_options.h"
#include "host/io/file_extension.h"
#include "host/io/height_maps/new_raster.h"
#include "host/scene/prepare/stored_terrain.h"
#include "host/terrain/analysis/viewshed.h"

namespace offing::cli {

namespace {

constexpr double highest_m = 1e6, farthest_m = 1e9;
constexpr std::uint8_t visible = 255, of_void = 128;

struct TerrainViewshedArguments {
  TerrainInput input;
  CacheFlags cache;
  EarthCurveFlags curve;
  PlaceFlags places;
  std::string observer, output;
  SettingOptions<terrain::ViewshedParameters> settings;
  bool json = false;
  Existing existing = Existing::keep;
};

std::vector<scene::Row<terrain::ViewshedParameters>> viewshed_rows() {
  using terrain::ViewshedParameters;
  return {{&ViewshedParameters::observer_height_m,
           {.key = "observer_height_m",
            .unit = "m",
            .low = 0.0,
            .high = highest_m,
            .help = "height of the eye above ground"}},
          {&ViewshedParameters::target_height_m,
           {.key = "target_height_m",
            .unit = "m",
            .low = 0.0,
            .high = highest_m,
            .help = "height of the target above ground; 0 is the ground itself",
            .example = "10"}},
          {&ViewshedParameters::radius_m,
           {.key = "radius_m",
            .unit = "m",
            .low = 1e-3,
            .high = farthest_m,
            .help = "largest horizontal distance; everything farther counts as hidden",
            .example = "20000",
            .absent = "no limit"}}};
}

/// A map, or the part of a store that is near enough, and where its first post is.
struct SeenMap {
  HeightMap map;
  double first_x_m = 0.0, first_z_m = 0.0;
};

// Of a post: heights here and on the device, maxima, voids, and what is seen.
constexpr double bytes_a_post = 12.0;

void place_observer(const PlaceSystem& system, const GivenPlace& observer,
                    terrain::ViewshedParameters& parameters) {
  const glm::dvec2 place_m = system.within_map("--observer", observer.place);
  parameters.observer_x_m = place_m.x;
  parameters.observer_z_m = place_m.y;
}

/// Sets the observer's place too.
SeenMap read_store(const TerrainViewshedArguments& arguments, const GivenPlace& observer,
                   terrain::ViewshedParameters& parameters) {
  const TileStore store(arguments.input.file(), arguments.input.trust());
  const TileStoreHeader& header = store.header();
  place_observer({frame_of(arguments.input.file(), scene::place_of(header)), arguments.places.system()},
                 observer, parameters);
  const double x_m = parameters.observer_x_m, z_m = parameters.observer_z_m;
  const terrain::TiledMap of = scene::tiled_map(header);
  require_within("--observer", of.width_m(), of.depth_m(), x_m, z_m);
  const scene::PostWindow window = scene::window_around(header, x_m, z_m, parameters.radius_m);
  constexpr double mebibyte = 1 << 20;
  const double needed_mb = std::ceil(bytes_a_post * window.columns * window.rows / mebibyte);
  const double found_mb = static_cast<double>(arguments.cache.read().cache_bytes()) / mebibyte;
  if (needed_mb > found_mb) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format(
            "{}: expected a viewshed for which {:.0f} MiB are enough, found one of {} x {} posts, which "
            "takes {:.0f} MiB",
            one_line(arguments.input.file()), found_mb, window.columns, window.rows, needed_mb),
        fmt::format("give a smaller --radius-m, or --cache-mb {:.0f}", needed_mb));
  }
  return {scene::read_window(store, window), window.first_column * header.spacing_x_m,
          window.first_row * header.spacing_z_m};
}

/// The same for a map.
SeenMap read_map(const TerrainViewshedArguments& arguments, const GivenPlace& observer,
                 terrain::ViewshedParameters& parameters) {
  SeenMap seen_map{arguments.input.read().map};
  place_observer({frame_of(arguments.input.file(), seen_map.map), arguments.places.system()}, observer,
                 parameters);
  return seen_map;
}

void run(const TerrainViewshedArguments& arguments, const GlobalOptions& options) {
  const GivenPlace observer =
      read_place("--observer", arguments.observer, PlaceForm::plan, arguments.places.system(), "1200,350");
  terrain::ViewshedParameters parameters = arguments.settings.read({.curve = arguments.curve.read()});
  require_extension(arguments.output, {".tif", ".tiff"});
  require_new(arguments.output, arguments.existing, {{arguments.input.file()}, arguments.input.trust()});
  require_flags_of(arguments.input, arguments.cache);
  const SeenMap seen_map = is_tile_store(arguments.input.file()) ? read_store(arguments, observer, parameters)
                                                                 : read_map(arguments, observer, parameters);
  const HeightMap& map = seen_map.map;
  parameters.observer_x_m -= seen_map.first_x_m;
  parameters.observer_z_m -= seen_map.first_z_m;
  const terrain::TerrainPoint terrain =
      terrain_under("--observer", terrain::posts_of(map), parameters.observer_x_m, parameters.observer_z_m);
  const ocl::Device device = ocl::Device::open(choose_one_device(options.device));
  const terrain::HeightField field = make_field(map, device);
  options.cancel.throw_if_cancelled();
  ocl::Buffer<std::uint8_t> buffer(device, map.heights_m.size(), "viewshed");
  terrain::Viewshed(device).at(field, parameters, buffer);
  std::vector<std::uint8_t> seen = buffer.read();
  options.cancel.throw_if_cancelled();
  for (std::size_t i = 0; i < map.is_void.size(); ++i) {
    if (map.is_void[i] != 0) seen[i] = of_void;
  }
  write_byte_raster(arguments.output,
                    {.columns = map.columns,
                     .rows = map.rows,
                     .values = seen,
                     .georeference = map.georeference,
                     .nodata = map.is_void.empty() ? std::nullopt : std::optional(of_void)},
                    arguments.existing);

  const auto seen_posts = std::count(seen.begin(), seen.end(), visible);
  const double area_m2 = static_cast<double>(seen_posts) * map.spacing_x_m * map.spacing_z_m;
  const double eye_m = terrain.height_m + parameters.observer_height_m;
  if (arguments.json) {
    print_json({{"file", arguments.output},
                {"columns", map.columns},
                {"rows", map.rows},
                {"eye_m", eye_m},
                {"seen_posts", seen_posts},
                {"seen_area_m2", area_m2},
                {"void_posts", std::count(map.is_void.begin(), map.is_void.end(), 1)}});
  } else {
    print_summary("{}: from {:.1f} m up, {} of {} posts are seen, {:.4g} km^2\n", one_line(arguments.output),
                  eye_m, seen_posts, seen.size(), 1e-6 * area_m2);
  }
}

}  // namespace

void add_terrain_viewshed_command(CLI::App& terrain, GlobalOptions& options) {
  const auto arguments = std::make_shared<TerrainViewshedArguments>();
  CLI::App* command =
      terrain.add_subcommand("viewshed", "map the ground that is visible from a point, as a GeoTIFF");
  arguments->input.add_to(*command);
  arguments->cache.add_to(*command);
  const auto add = [&](const char* names, std::string& target, const char* placeholder, const char* help) {
    return command->add_option(names, target, help)->type_name(placeholder);
  };
  add("--observer", arguments->observer, "X,Z", "position of the observer, in m, or in the system of --crs")
      ->required();
  arguments->places.add_to(*command);
  arguments->settings.add_to(*command, viewshed_rows());
  arguments->curve.add_to(*command);
  add("-o,--output", arguments->output, "FILE", "GeoTIFF to write (.tif), complete or not at all")
      ->required();
  add_force_flag(*command, arguments->existing);
  command->add_flag("--json", arguments->json, "print the results as JSON");
  add_global_options(*command, options, DeviceUse::one);
  command->footer(fmt::format(R"(
{}
The raster has one byte per post and the georeference of the map: 255 visible, 0 hidden, 128 (nodata) where
the map has a void. Visibility is exact: it follows the surface between the posts instead of stepping from
post to post. For a tile store, the raster covers the square that --radius-m reaches, in full detail.
--cache-mb must be large enough for it, at 12 bytes per post.

Examples:
  offing terrain viewshed S33W071.tif --observer 47000,55000 -o seen.tif
  offing terrain viewshed S33W071.tif --crs lonlat --observer -70.5,-32.6 -o seen.tif
  offing terrain viewshed S33W071.tif --observer 47000,55000 --observer-height-m 30 --target-height-m 2 \
    --radius-m 40000 --curvature -o mast.tif)",
                              place_footer));
  command->callback([arguments, &options] { run(*arguments, options); });
}

}  // namespace offing::cli
