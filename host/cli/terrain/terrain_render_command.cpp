#include <algorithm>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/base/argument.h"
#include "host/base/error.h"
#include "host/base/work.h"
#include "host/cli/common/device_choice.h"
#include "host/cli/pictures/terrain_render.h"
#include "host/cli/terrain/place_system.h"
#include "host/cli/terrain/store_flags.h"
#include "host/cli/terrain/terrain_camera.h"
#include "host/cli/terrain/terrain_commands.h"
#include "host/cli/terrain/terrain_place.h"
#include "host/command_line/new_output.h"
#include "host/command_line/print_results.h"
#include "host/command_line/setting_options.h"
#include "host/io/exr_image.h"
#include "host/io/file_extension.h"
#include "host/io/height_maps/read_colour_map.h"
#include "host/scene/model/terrain_scene.h"
#include "host/scene/prepare/stored_terrain.h"
#include "host/terrain/lakes/lake.h"
#include "host/terrain/tiles/tile_posts.h"
#include "host/terrain/walk/relief_height.h"

namespace offing::cli {

namespace {

/// Numbers and choices of a picture.
struct RenderSettings {
  double field_of_view_rad = 60.0 * radians_per_degree;
  double exposure_ev = 0.0;
  double sea_level_m = 0.0;
  std::optional<double> tree_line_m, snow_line_m;
  scene::SkyVisibility sky_visibility = scene::SkyVisibility::on;
  terrain::Landscape landscape = terrain::Landscape::plain;
  terrain::Canopy canopy;
  double relief = 1.0;
  double finest_detail_m = 0.0;
  int samples = 0;  ///< 0: as many as a pixel needs
  TerrainShow show = TerrainShow::light;
};

struct TerrainRenderArguments {
  TerrainInput input;
  CacheFlags cache;
  PlaceFlags places;
  std::string camera = "fly", size = "1280x720", output, depth, sun, colour, canopy_map;
  std::vector<std::string> lakes;
  SettingOptions<RenderSettings> settings;
  bool json = false;
  Existing existing = Existing::keep;
};

Camera read_camera(const TerrainRenderArguments& arguments, const RenderSettings& settings,
                   const PlaceSystem& system, CameraTerrain terrain) {
  if (!system.is_local())
    terrain.on_map = [&system](const glm::dvec2& place) { return system.on_map("--camera", place); };
  Camera camera = read_terrain_camera(arguments.camera, terrain);
  keep_above_ground(camera, terrain);
  read_image_size(arguments.size, camera);
  camera.vertical_field_of_view_rad = settings.field_of_view_rad;
  return camera;
}

std::vector<scene::Row<RenderSettings>> picture_rows() {
  return {{&RenderSettings::field_of_view_rad, like_scene("camera.fov_deg", "--fov-deg")},
          {&RenderSettings::exposure_ev, like_scene("render.exposure_ev", "--exposure-ev")},
          {&RenderSettings::sea_level_m, like_scene("terrain.water_line_m", "--sea-level-m",
                                                    "height up to which ground is painted as water")},
          {&RenderSettings::tree_line_m, like_scene("terrain.tree_line_m", "--tree-line-m")},
          {&RenderSettings::snow_line_m, like_scene("terrain.snow_line_m", "--snow-line-m")},
          {scene::choice(&RenderSettings::sky_visibility, names_in_scene("terrain.sky_visibility")),
           like_scene("terrain.sky_visibility", "--sky-visibility",
                      "whether surrounding ground blocks light from the sky; off for tile stores")},
          {scene::choice(&RenderSettings::landscape, names_in_scene("terrain.landscape")),
           like_scene("terrain.landscape", "--landscape", "set of materials on the ground")},
          {scene::path(&RenderSettings::canopy, &terrain::Canopy::share),
           like_scene("terrain.canopy.share", "--canopy-share",
                      "share of the ground below the tree line that woods cover, 0 for none")},
          {scene::path(&RenderSettings::canopy, &terrain::Canopy::height_m),
           like_scene("terrain.canopy.height_m", "--canopy-height-m")},
          {&RenderSettings::relief, like_scene("terrain.relief", "--relief")},
          {&RenderSettings::finest_detail_m, like_scene("terrain.finest_detail_m", "--finest-detail-m")},
          {&RenderSettings::samples,
           {.key = "samples",
            .low = 1.0,
            .high = 4096.0,
            .help = "rays per pixel; auto: 1, and 4 or 16 where light or coverage changes between pixels",
            .example = "16",
            .absent = "auto"}},
          {scene::choice(&RenderSettings::show, {"light", "steps"}),
           {.key = "show",
            .help = "what to draw: light, or the steps that each ray took (blue 0, green 16, yellow 40, red "
                    "80 and more)"}}};
}

TerrainScenery read_scenery(const TerrainRenderArguments& arguments, const RenderSettings& settings,
                            std::optional<double> latitude_deg) {
  TerrainScenery scenery;
  if (!arguments.sun.empty()) {
    const auto sun = read_numbers("--sun", arguments.sun, 2, "AZIMUTH_DEG,ELEVATION_DEG", "225,30");
    scenery.sun_azimuth_rad = sun[0] * radians_per_degree;
    scenery.sun_elevation_rad =
        read_number("--sun", fmt::format("{}", sun[1]), "degrees", -90.0, 90.0, "225,30") *
        radians_per_degree;
  }
  scenery.landscape = settings.landscape;
  scenery.sees_horizons = settings.sky_visibility == scene::SkyVisibility::on;
  scenery.relief = settings.relief;
  scenery.finest_detail_m = settings.finest_detail_m;
  if (latitude_deg) scenery.lines = world::cover_lines(*latitude_deg);
  scenery.lines.sea_level_m = settings.sea_level_m;
  scenery.lines.tree_line_m = settings.tree_line_m.value_or(scenery.lines.tree_line_m);
  scenery.lines.snow_line_m = settings.snow_line_m.value_or(scenery.lines.snow_line_m);
  scenery.canopy = terrain::wood_of(settings.canopy, nullptr, scenery.lines.tree_line_m);
  if (settings.samples > 0) scenery.sampling = {.rays = settings.samples, .least_contrast = -1.0};
  scenery.exposure_ev = settings.exposure_ev;
  return scenery;
}

/// Puts the woods of `--canopy-map` in place of those of `--canopy-share`.
void plant(ColourMap picture, const RenderSettings& settings, TerrainScenery& scenery) {
  scenery.canopy =
      terrain::wood_of(settings.canopy, terrain::cover_map(std::move(picture)), scenery.lines.tree_line_m);
}

/// Of `--lake X,Z` and `--lake X,Z,LEVEL`.
void add_lakes(const TerrainRenderArguments& arguments, const PlaceSystem& system,
               const terrain::TerrainPosts& posts, const CancelToken& cancel, TerrainScenery& scenery) {
  for (const std::string& text : arguments.lakes) {
    const bool has_level = std::ranges::count(text, ',') == 2;
    const GivenPlace given = read_place("--lake", text, has_level ? PlaceForm::level : PlaceForm::plan,
                                        system.name(), has_level ? "1200,350.5,2600" : "1200,350.5");
    const glm::dvec2 place_m = system.within_map("--lake", given.place);
    const std::optional<double> level_m = has_level ? std::optional(given.height_m) : std::nullopt;
    world::LakeSettings lake;
    lake.lake = std::make_shared<const terrain::Lake>(
        terrain::fill_lake(posts, place_m.x, place_m.y, level_m, "--lake", Work(cancel)));
    for (std::size_t i = 0; i < scenery.lakes.size(); ++i) {
      if (!terrain::overlap(*scenery.lakes[i].lake, *lake.lake)) continue;
      throw Error(ErrorKind::bad_input,
                  fmt::format("--lake: expected no other lake there, found {} in the water of {}",
                              printable(text), printable(arguments.lakes[i])),
                  "leave out one of them");
    }
    scenery.lakes.push_back(std::move(lake));
  }
}

void write_depth(const std::string& file, const Camera& camera, const std::vector<float>& distances_m,
                 Existing existing) {
  const ExrImage image{
      .width = camera.width_px,
      .height = camera.height_px,
      .channels = {{"Z", distances_m}},
      .attributes = {{"meaning", "metres along each pixel's ray; infinite where it is sky"}}};
  write_exr(file, image, PixelType::float_32, ExrCompression::zip, existing);
}

struct Rendered {
  Camera camera;
  nlohmann::ordered_json eye;  ///< in the system of --crs; null for local places
  TerrainRender picture;
};

nlohmann::ordered_json eye_in(const PlaceSystem& system, const Camera& camera) {
  return system.to_json({camera.eye_m.x, camera.eye_m.z}, &camera.eye_m.y);
}

/// Whether water reaches the edge of a map: the sea then goes on beyond it.
bool has_water_at_edges(const HeightMap& map, double level_m) {
  const auto is_under = [&](int column, int row) {
    return static_cast<double>(map.heights_m[map.index(column, row)]) <= level_m;
  };
  bool is_wet = false;
  for (int column = 0; column < map.columns; ++column)
    is_wet = is_wet || is_under(column, 0) || is_under(column, map.rows - 1);
  for (int row = 0; row < map.rows; ++row)
    is_wet = is_wet || is_under(0, row) || is_under(map.columns - 1, row);
  return is_wet;
}

/// Brings a camera on foot to the ground as it is drawn.
void stand_on_relief(const terrain::TerrainPosts& posts, const TerrainScenery& scenery, Camera& camera) {
  camera.eye_m.y += terrain::relief_height_m(posts, scenery.relief_settings(), camera.eye_m.x, camera.eye_m.z,
                                             camera.eye_m);
}

Rendered render_map(const TerrainRenderArguments& arguments, const RenderSettings& settings,
                    const GlobalOptions& options) {
  const HeightMapFile file = arguments.input.read();
  const PlaceSystem system(frame_of(arguments.input.file(), file.map), arguments.places.system());
  Camera camera = read_camera(arguments, settings, system, camera_terrain(file.map));
  TerrainScenery scenery = read_scenery(arguments, settings, file.source.centre_latitude_deg);
  scenery.sea_goes_on = has_water_at_edges(file.map, settings.sea_level_m);
  if (!arguments.colour.empty())
    scenery.colours = read_colour_map(arguments.colour, file.map, {.trust = arguments.input.trust()});
  if (!arguments.canopy_map.empty()) {
    plant(read_colour_map(arguments.canopy_map, file.map, {.trust = arguments.input.trust()}), settings,
          scenery);
  }
  add_lakes(arguments, system, terrain::posts_of(file.map), options.cancel, scenery);
  if (arguments.camera == "walk") stand_on_relief(terrain::posts_of(file.map), scenery, camera);
  const ocl::Device device = ocl::Device::open(choose_one_device(options.device));
  terrain::HeightField field = make_field(file.map, device);
  options.cancel.throw_if_cancelled();
  return {camera, eye_in(system, camera), draw_terrain(device, field, camera, scenery, settings.show)};
}

Rendered render_store(const TerrainRenderArguments& arguments, const RenderSettings& settings,
                      const GlobalOptions& options) {
  const TileStore store(arguments.input.file(), arguments.input.trust());
  const TileStoreHeader& header = store.header();
  TerrainScenery scenery = read_scenery(arguments, settings, header.centre_latitude_deg);
  scenery.sea_goes_on = static_cast<double>(header.lowest_m) <= settings.sea_level_m;
  if (!arguments.colour.empty()) {
    scenery.colours =
        read_colour_map(arguments.colour, scene::place_of(header), {.trust = arguments.input.trust()});
  }
  if (!arguments.canopy_map.empty()) {
    plant(read_colour_map(arguments.canopy_map, scene::place_of(header), {.trust = arguments.input.trust()}),
          settings, scenery);
  }
  const ocl::Device device = ocl::Device::open(choose_one_device(options.device));
  terrain::TiledField field = make_field(store, device, arguments.cache.read());
  const PlaceSystem system(frame_of(arguments.input.file(), scene::place_of(header)),
                           arguments.places.system());
  Camera camera = read_camera(arguments, settings, system, camera_terrain(field));
  if (!arguments.lakes.empty() && field.map().edge != terrain::MapEdge::ends) {
    throw Error(ErrorKind::bad_usage, "--lake: expected a map that ends at its edges, found --edge",
                "leave out --edge");
  }
  const terrain::TerrainPosts posts =
      terrain::posts_of(scene::tiled_map(header), scene::tile_reader(store), terrain::Unreadable::refused);
  add_lakes(arguments, system, posts, options.cancel, scenery);
  if (arguments.camera == "walk" && field.map().edge == terrain::MapEdge::ends)
    stand_on_relief(posts, scenery, camera);
  field.look_and_wait(camera);
  options.cancel.throw_if_cancelled();
  return {camera, eye_in(system, camera), draw_terrain(device, field, camera, scenery, settings.show)};
}

void run(const TerrainRenderArguments& arguments, const GlobalOptions& options) {
  const RenderSettings settings = arguments.settings.read();
  require_flags_of(arguments.input, arguments.cache);
  require_extension(arguments.output, {".png"});
  if (!arguments.depth.empty()) require_extension(arguments.depth, {".exr"});
  for (const std::string& file : {arguments.output, arguments.depth}) {
    require_new(file, arguments.existing,
                {{arguments.input.file(), arguments.colour, arguments.canopy_map}, arguments.input.trust()});
  }
  const auto [camera, eye, picture] = is_tile_store(arguments.input.file())
                                          ? render_store(arguments, settings, options)
                                          : render_map(arguments, settings, options);
  options.cancel.throw_if_cancelled();
  write_png(arguments.output, picture.image, arguments.existing, PngCompression::fast);
  if (!arguments.depth.empty()) {
    write_depth(arguments.depth, camera, picture.distances_m, arguments.existing);
  }

  const double ground_share =
      static_cast<double>(picture.terrain_pixels) / static_cast<double>(picture.distances_m.size());
  if (arguments.json) {
    nlohmann::ordered_json json = {{"picture", arguments.output},
                                   {"eye_m", {camera.eye_m.x, camera.eye_m.y, camera.eye_m.z}},
                                   {"yaw_deg", camera.yaw_rad / radians_per_degree},
                                   {"pitch_deg", camera.pitch_rad / radians_per_degree},
                                   {"ground_share", ground_share},
                                   {"mean_steps", picture.mean_steps},
                                   {"refined_share", picture.refined_share}};
    if (!eye.is_null()) json["eye"] = eye;
    print_json(json);
  } else {
    print_summary("{}: from ({:.1f}, {:.1f}, {:.1f}) m, {:.1f} % ground, {:.1f} steps per ray\n",
                  one_line(arguments.output), camera.eye_m.x, camera.eye_m.y, camera.eye_m.z,
                  100.0 * ground_share, picture.mean_steps);
  }
}

}  // namespace

void add_terrain_render_command(CLI::App& terrain, GlobalOptions& options) {
  const auto arguments = std::make_shared<TerrainRenderArguments>();
  CLI::App* command = terrain.add_subcommand("render", "render a height map under a clear sky");
  arguments->input.add_to(*command);
  arguments->cache.add_to(*command);
  arguments->cache.add_edge_to(*command);
  const auto add = [&](const char* names, std::string& target, const char* placeholder, const char* help) {
    return command->add_option(names, target, help)->type_name(placeholder)->group("Picture");
  };
  add("-o,--output", arguments->output, "FILE", "PNG to write")->required();
  add("--depth", arguments->depth, "FILE",
      "also write an EXR with the distance along each pixel's ray, in m, in channel Z");
  add("--camera", arguments->camera, "CAMERA",
      "fly, walk, or X,Y,Z,YAW_DEG,PITCH_DEG: X east and Z south of the map's north-west post, Y the height, "
      "all in m; yaw clockwise from north (default fly). With --crs: X,Y,HEIGHT,YAW_DEG,PITCH_DEG");
  arguments->places.add_to(*command, "Picture");
  add("--size", arguments->size, "WxH", "size in pixels (default 1280x720)");
  add("--sun", arguments->sun, "AZIMUTH_DEG,ELEVATION_DEG",
      "direction of the sun, azimuth clockwise from north (default 225,30)");
  arguments->settings.add_to(*command, picture_rows(), "Picture");
  add("--colour", arguments->colour, "FILE",
      "aerial picture of the ground (GeoTIFF, PNG, ...), placed by its georeference; stretched "
      "over the map if it has none");
  add("--canopy-map", arguments->canopy_map, "FILE",
      "picture of the woods, white where they are dense, placed as --colour; replaces --canopy-share");
  command
      ->add_option("--lake", arguments->lakes,
                   "draw the lake at this place, full or up to a LEVEL in m; may be repeated")
      ->type_name("X,Z[,LEVEL]")
      ->group("Picture");
  add_force_flag(*command, arguments->existing);
  command->add_flag("--json", arguments->json, "print the results as JSON");
  add_global_options(*command, options, DeviceUse::one);
  command->footer(R"(
FILE may also be a tile store made by `offing terrain tile`.

Examples:
  offing terrain render S33W071.tif -o andes.png
  offing terrain render S33W071.tif --camera walk --sun 300,12 --size 1920x1080 -o dusk.png --depth dusk.exr
  offing terrain render dem.tif --colour orthophoto.tif --camera 4000,2500,9000,20,-15 -o valley.png
  offing terrain render S33W071.tif --camera walk --lake 47000,55000 -o lake.png
  offing terrain render heights.r16 --raw-size 1025x1025 --spacing-m 75 --show steps -o steps.png)");
  command->callback([arguments, &options] { run(*arguments, options); });
}

}  // namespace offing::cli
