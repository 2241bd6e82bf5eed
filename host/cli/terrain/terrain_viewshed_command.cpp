#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CLI/Option.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/base/error.h"
#include "host/base/progress.h"
#include "host/cli/common/device_choice.h"
#include "host/cli/terrain/earth_curve_flags.h"
#include "host/cli/terrain/place_system.h"
#include "host/cli/terrain/store_flags.h"
#include "host/cli/terrain/terrain_batch.h"
#include "host/cli/terrain/terrain_camera.h"
#include "host/cli/terrain/terrain_commands.h"
#include "host/cli/terrain/terrain_place.h"
#include "host/command_line/new_output.h"
#include "host/command_line/print_results.h"
#include "host/command_line/setting_options.h"
#include "host/io/file_extension.h"
#include "host/io/height_maps/new_raster.h"
#include "host/scene/prepare/stored_terrain.h"
#include "host/terrain/analysis/many_viewsheds.h"
#include "host/terrain/analysis/needed_height.h"
#include "host/terrain/analysis/sight_counts.h"
#include "host/terrain/analysis/sight_limits.h"
#include "host/terrain/analysis/viewshed.h"

namespace offing::cli {

namespace {

constexpr double highest_m = 1e6, farthest_m = 1e9;
constexpr std::uint8_t visible = 255, of_void = 128;

/// What becomes of posts beyond the radius and the angles.
enum class OutsidePosts { hidden, nodata };

/// Beside the parameters of a viewshed.
struct ViewshedSettings {
  double azimuth_from_rad = 0.0, azimuth_to_rad = 2.0 * std::numbers::pi;
  double lowest_rad = -0.5 * std::numbers::pi, highest_rad = 0.5 * std::numbers::pi;
  OutsidePosts outside = OutsidePosts::hidden;
  int best = 0;

  terrain::SightLimits limits() const { return {azimuth_from_rad, azimuth_to_rad, lowest_rad, highest_rad}; }
};

struct TerrainViewshedArguments {
  TerrainInput input;
  CacheFlags cache;
  EarthCurveFlags curve;
  PlaceFlags places;
  std::string observer, output, points, layer, united, shares, needed;
  SettingOptions<terrain::ViewshedParameters> settings;
  SettingOptions<ViewshedSettings> more;
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

std::vector<scene::Row<ViewshedSettings>> angle_rows() {
  return {{&ViewshedSettings::azimuth_from_rad,
           {.key = "azimuth_from_deg",
            .unit = "deg",
            .low = -360.0,
            .high = 360.0,
            .help = "start of the observer's sector, clockwise from north",
            .scale = radians_per_degree}},
          {&ViewshedSettings::azimuth_to_rad,
           {.key = "azimuth_to_deg",
            .unit = "deg",
            .low = -360.0,
            .high = 360.0,
            .help = "end of the sector, clockwise from its start; 360 degrees apart are all azimuths",
            .scale = radians_per_degree}},
          {&ViewshedSettings::lowest_rad,
           {.key = "lowest_deg",
            .unit = "deg",
            .low = -90.0,
            .high = 90.0,
            .help = "lowest angle at which the observer looks, up from level",
            .scale = radians_per_degree}},
          {&ViewshedSettings::highest_rad,
           {.key = "highest_deg",
            .unit = "deg",
            .low = -90.0,
            .high = 90.0,
            .help = "highest angle at which the observer looks, up from level",
            .scale = radians_per_degree}},
          {scene::choice(&ViewshedSettings::outside, {"hidden", "nodata"}),
           {.key = "outside", .help = "value of posts outside the radius and angles"}}};
}

std::vector<scene::Row<ViewshedSettings>> best_rows() {
  return {
      {&ViewshedSettings::best,
       {.key = "best",
        .low = 1.0,
        .high = static_cast<double>(terrain::most_observers),
        .help = "choose this many observers that together see the most; compares all choices if there are "
                "at most 5000, otherwise adds the best one at a time",
        .example = "3",
        .absent = "none"}}};
}

/// A map, or the part of a store that is near enough, and where its first post is.
struct SeenMap {
  HeightMap map;
  double first_x_m = 0.0, first_z_m = 0.0;
};

// Of a post: heights here and on the device, maxima, voids, and what is seen.
constexpr double bytes_a_post = 12.0;

/// The columns of a file of observers.
QuestionColumns observer_columns() {
  return {{.names = {"x_m", "z_m"},
           .meaning = "for each observer, its x and z in m",
           .example = "1200,350.5",
           .optional = {"observer_height_m", "target_height_m", "radius_m", "azimuth_from_deg",
                        "azimuth_to_deg", "lowest_deg", "highest_deg"}},
          {{.prefix = "", .x = 0, .z = 1}}};
}

/// The observers of a command, as the map has them, and the file that they come from.
struct Observers {
  std::vector<terrain::Observer> all;
  std::vector<std::string> names;      ///< the flag, the lines or the features
  std::unique_ptr<QuestionFile> file;  // null for --observer
  QuestionBlock block;

  void add(terrain::Observer observer, std::string name) {
    all.push_back(std::move(observer));
    names.push_back(std::move(name));
  }
};

terrain::Observer observer_of(const terrain::ViewshedParameters& parameters, const ViewshedSettings& settings,
                              const glm::dvec2& place_m) {
  terrain::Observer observer{parameters, settings.limits()};
  observer.parameters.observer_x_m = place_m.x;
  observer.parameters.observer_z_m = place_m.y;
  return observer;
}

/// Those of a file: the columns that it has count more than the flags.
Observers read_observers(const TerrainViewshedArguments& arguments, const MapFrame& map,
                         const terrain::ViewshedParameters& parameters, const ViewshedSettings& settings) {
  Observers observers;
  observers.file =
      open_questions({arguments.points, arguments.layer}, map, arguments.places.system(), observer_columns());
  observers.block = observers.file->next(terrain::most_observers + 1);
  const QuestionBlock& block = observers.block;
  if (block.count > terrain::most_observers) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected at most {} observers, found more", one_line(arguments.points),
                            terrain::most_observers),
                "cut them into several files");
  }
  const terrain::PostGrid grid{.columns = map.columns,
                               .rows = map.rows,
                               .spacing_x_m = map.spacing_x_m,
                               .spacing_z_m = map.spacing_z_m};
  for (std::size_t i = 0; i < block.count; ++i) {
    const glm::dvec2 place_m(block.rows[2 * i], block.rows[2 * i + 1]);
    terrain::Observer observer = observer_of(parameters, settings, place_m);
    const std::string name = block.place_of(i);
    require_within(name, grid.spacing_x_m * (grid.columns - 1), grid.spacing_z_m * (grid.rows - 1), place_m.x,
                   place_m.y);
    const std::array values{&observer.parameters.observer_height_m,
                            &observer.parameters.target_height_m,
                            &observer.parameters.radius_m,
                            &observer.limits.azimuth_from_rad,
                            &observer.limits.azimuth_to_rad,
                            &observer.limits.lowest_rad,
                            &observer.limits.highest_rad};
    constexpr std::size_t first_angle = 3;
    for (std::size_t value = 0; value < values.size(); ++value) {
      const double given = block.optional[i * values.size() + value];
      if (!std::isnan(given)) *values[value] = value < first_angle ? given : given * radians_per_degree;
    }
    // As the columns are named: "viewshed: radius_m: ..." and "viewshed: lowest: ..., found 95 degrees".
    const auto refuse = [&name](const Error& error, const char* unit) {
      constexpr std::string_view library = "viewshed: ";
      std::string what = error.what();
      if (what.starts_with(library)) what.erase(0, library.size());
      what.insert(std::min(what.find(':'), what.size()), unit);
      throw Error(error.kind(), fmt::format("{}: {}", name, what), error.hint());
    };
    try {
      terrain::require_valid(observer.parameters, grid);
    } catch (const Error& error) {
      refuse(error, "");
    }
    try {
      terrain::require_valid(observer.limits);
    } catch (const Error& error) {
      refuse(error, "_deg");
    }
    observers.add(observer, name);
  }
  return observers;
}

/// The posts of a store that are within the radii of all observers.
SeenMap read_near(const TerrainViewshedArguments& arguments, const TileStore& store,
                  const std::vector<terrain::Observer>& observers) {
  const TileStoreHeader& header = store.header();
  int left = header.shape.columns, top = header.shape.rows, right = 0, bottom = 0;
  for (const terrain::Observer& observer : observers) {
    const terrain::ViewshedParameters& at = observer.parameters;
    const scene::PostWindow near =
        scene::window_around(header, at.observer_x_m, at.observer_z_m, at.radius_m);
    left = std::min(left, near.first_column);
    top = std::min(top, near.first_row);
    right = std::max(right, near.first_column + near.columns);
    bottom = std::max(bottom, near.first_row + near.rows);
  }
  const scene::PostWindow window{left, top, right - left, bottom - top};
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

/// Looks from places over a map.
class Looking {
 public:
  Looking(const SeenMap& seen_map, const std::vector<terrain::Observer>& observers, const ocl::Device& device)
      : map_(seen_map.map), device_(device), observers_(observers), field_(make_field(map_, device)) {
    for (terrain::Observer& observer : observers_) {
      observer.parameters.observer_x_m -= seen_map.first_x_m;
      observer.parameters.observer_z_m -= seen_map.first_z_m;
    }
  }

  /// Calls take(index, seen) for each observer, [rows][columns]: 255 seen, 0 hidden, 128 where the map has a
  /// void, and `outside` beyond the radius and the angles.
  void from_each(std::uint8_t outside,
                 const std::function<void(std::size_t, std::span<const std::uint8_t>)>& take) const {
    terrain::look_from_each(device_, field_, map_.heights_m, observers_, outside,
                            [&](std::size_t observer, std::span<std::uint8_t> seen) {
                              for (std::size_t i = 0; i < map_.is_void.size(); ++i) {
                                if (map_.is_void[i] != 0) seen[i] = of_void;
                              }
                              take(observer, seen);
                            });
  }

  /// How high above each post a target must be for an observer to see it, m; NaN beyond the radius and the
  /// angles.
  std::vector<float> needed_m(std::size_t index, const CancelToken& cancel) const {
    const terrain::Observer& observer = observers_[index];
    std::vector<float> needed = terrain::needed_heights(map_, observer.parameters, cancel);
    std::vector<std::uint8_t> marks(needed.size(), 0);
    terrain::mark_outside(field_.grid(), map_.heights_m, observer.parameters, observer.limits,
                          terrain::sight_outside, marks);
    for (std::size_t i = 0; i < needed.size(); ++i) {
      if (marks[i] != 0) needed[i] = std::numeric_limits<float>::quiet_NaN();
    }
    return needed;
  }

 private:
  const HeightMap& map_;
  ocl::Device device_;
  std::vector<terrain::Observer> observers_;
  terrain::HeightField field_;
};

double area_m2(const HeightMap& map, std::size_t posts) {
  return static_cast<double>(posts) * map.spacing_x_m * map.spacing_z_m;
}

void write_seen(const std::string& file, const HeightMap& map, std::span<const std::uint8_t> seen,
                bool has_nodata, Existing existing) {
  write_byte_raster(file,
                    {.columns = map.columns,
                     .rows = map.rows,
                     .values = seen,
                     .georeference = map.georeference,
                     .nodata = has_nodata ? std::optional(of_void) : std::nullopt},
                    existing);
}

/// The raster of heights that targets need: the least of all observers.
class NeededRaster {
 public:
  explicit NeededRaster(const HeightMap& map)
      : map_(map), needed_m_(map.heights_m.size(), std::numeric_limits<float>::quiet_NaN()) {}

  void add(const std::vector<float>& needed_m) {
    for (std::size_t i = 0; i < needed_m.size(); ++i) needed_m_[i] = std::fmin(needed_m_[i], needed_m[i]);
  }

  void write(const std::string& file, Existing existing) {
    constexpr float none = -9999.0f;
    for (std::size_t i = 0; i < needed_m_.size(); ++i) {
      const bool is_void = !map_.is_void.empty() && map_.is_void[i] != 0;
      if (is_void || std::isnan(needed_m_[i])) needed_m_[i] = none;
    }
    write_post_raster(file,
                      {.columns = map_.columns,
                       .rows = map_.rows,
                       .values = needed_m_,
                       .georeference = map_.georeference,
                       .nodata = none,
                       .unit = "m",
                       .description = "height above ground that is needed to be seen"},
                      existing);
  }

 private:
  const HeightMap& map_;
  std::vector<float> needed_m_;
};

void look_from_one(const TerrainViewshedArguments& arguments, const ViewshedSettings& settings,
                   const Observers& observers, const SeenMap& seen_map, const ocl::Device& device,
                   const GlobalOptions& options) {
  const HeightMap& map = seen_map.map;
  const terrain::ViewshedParameters& parameters = observers.all.front().parameters;
  const terrain::TerrainPoint terrain =
      terrain_under("--observer", terrain::posts_of(map), parameters.observer_x_m - seen_map.first_x_m,
                    parameters.observer_z_m - seen_map.first_z_m);
  const Looking looking(seen_map, observers.all, device);
  options.cancel.throw_if_cancelled();
  const bool marks_outside = settings.outside == OutsidePosts::nodata;
  std::vector<std::uint8_t> seen;
  looking.from_each(
      marks_outside ? terrain::sight_outside : 0,
      [&](std::size_t, std::span<const std::uint8_t> found) { seen.assign(found.begin(), found.end()); });
  options.cancel.throw_if_cancelled();
  if (!arguments.needed.empty()) {
    NeededRaster needed(map);
    needed.add(looking.needed_m(0, options.cancel));
    needed.write(arguments.needed, arguments.existing);
  }
  write_seen(arguments.output, map, seen, marks_outside || !map.is_void.empty(), arguments.existing);
  const auto seen_posts = static_cast<std::size_t>(std::count(seen.begin(), seen.end(), visible));
  const double eye_m = terrain.height_m + parameters.observer_height_m;
  if (arguments.json) {
    print_json({{"file", arguments.output},
                {"columns", map.columns},
                {"rows", map.rows},
                {"eye_m", eye_m},
                {"seen_posts", seen_posts},
                {"seen_area_m2", area_m2(map, seen_posts)},
                {"void_posts", std::count(map.is_void.begin(), map.is_void.end(), 1)}});
  } else {
    print_summary("{}: from {:.1f} m up, {} of {} posts are seen, {:.4g} km^2\n", one_line(arguments.output),
                  eye_m, seen_posts, seen.size(), 1e-6 * area_m2(map, seen_posts));
  }
}

/// The raster of counts: how many observers see each post.
void write_counts(const TerrainViewshedArguments& arguments, const HeightMap& map, bool marks_outside,
                  const terrain::SightCounts& counts) {
  constexpr std::uint16_t none = 65535;
  std::vector<std::uint16_t> values(counts.counts().begin(), counts.counts().end());
  std::vector<std::uint8_t> united(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool is_void = !map.is_void.empty() && map.is_void[i] != 0;
    const bool is_none = is_void || (marks_outside && !counts.is_reached(i));
    united[i] = is_none ? of_void : values[i] > 0 ? visible : 0;
    if (is_none) values[i] = none;
  }
  const bool has_nodata = marks_outside || !map.is_void.empty();
  write_post_raster(arguments.output,
                    {.columns = map.columns,
                     .rows = map.rows,
                     .values = values,
                     .georeference = map.georeference,
                     .nodata = has_nodata ? std::optional<double>(none) : std::nullopt,
                     .unit = {},
                     .description = "observers that see the post"},
                    arguments.existing);
  if (!arguments.united.empty()) write_seen(arguments.united, map, united, has_nodata, arguments.existing);
}

/// What each observer sees, beside its line or feature.
void write_shares(const TerrainViewshedArguments& arguments, const HeightMap& map, const MapFrame& frame,
                  const Observers& observers, const terrain::SightCounts& counts,
                  const terrain::BestObservers& best) {
  const std::unique_ptr<AnswerFile> file =
      create_answers(arguments.shares, arguments.existing, frame, *observers.file,
                     {{"seen_posts", 0, AttributeKind::whole},
                      {"seen_area_m2", 9},
                      {"seen_share", 7},
                      {"only_posts", 0, AttributeKind::whole},
                      {"best_rank", 0, AttributeKind::whole}});
  const std::vector<std::size_t> only_posts = counts.only_posts();
  std::vector<AttributeValue> values;
  for (std::size_t i = 0; i < counts.observers(); ++i) {
    const std::size_t seen = counts.seen_posts()[i], reached = counts.reached_posts()[i];
    const auto rank = std::ranges::find(best.observers, i) - best.observers.begin();
    const bool is_best = rank < std::ssize(best.observers);
    values.insert(values.end(),
                  {static_cast<std::int64_t>(seen), area_m2(map, seen),
                   reached == 0 ? 0.0 : static_cast<double>(seen) / static_cast<double>(reached),
                   static_cast<std::int64_t>(only_posts[i]),
                   is_best ? AttributeValue(static_cast<std::int64_t>(rank + 1)) : AttributeValue()});
  }
  file->write(observers.block, values);
  file->commit();
}

void look_from_all(const TerrainViewshedArguments& arguments, const ViewshedSettings& settings,
                   const Observers& observers, const SeenMap& seen_map, const MapFrame& frame,
                   const ocl::Device& device, const GlobalOptions& options) {
  const HeightMap& map = seen_map.map;
  const bool keeps_each = settings.best > 0 || !arguments.shares.empty();
  if (keeps_each) terrain::require_room(map.heights_m.size(), observers.all.size());
  terrain::SightCounts counts(map.heights_m.size(), keeps_each);
  const Looking looking(seen_map, observers.all, device);
  Progress progress(static_cast<int>(observers.all.size()), "viewsheds", options.verbosity);
  NeededRaster needed(map);
  looking.from_each(terrain::sight_outside, [&](std::size_t observer, std::span<const std::uint8_t> seen) {
    options.cancel.throw_if_cancelled();
    counts.add(seen);
    if (!arguments.needed.empty()) needed.add(looking.needed_m(observer, options.cancel));
    progress.advance();
  });
  terrain::BestObservers best;
  if (settings.best > 0)
    best = terrain::best_observers(counts.each(), static_cast<std::size_t>(settings.best), options.cancel);
  options.cancel.throw_if_cancelled();
  if (!arguments.needed.empty()) needed.write(arguments.needed, arguments.existing);
  if (!arguments.shares.empty()) write_shares(arguments, map, frame, observers, counts, best);
  write_counts(arguments, map, settings.outside == OutsidePosts::nodata, counts);
  const std::size_t seen_posts = counts.union_posts();
  if (arguments.json) {
    nlohmann::ordered_json json = {{"file", arguments.output},
                                   {"columns", map.columns},
                                   {"rows", map.rows},
                                   {"observers", counts.observers()},
                                   {"seen_posts", seen_posts},
                                   {"seen_area_m2", area_m2(map, seen_posts)},
                                   {"largest_count", *std::ranges::max_element(counts.counts())},
                                   {"void_posts", std::count(map.is_void.begin(), map.is_void.end(), 1)}};
    if (settings.best > 0) {
      json["best_exhaustive"] = best.is_exhaustive;
      for (std::size_t i = 0; i < best.observers.size(); ++i) {
        json["best"].push_back({{"observer", best.observers[i] + 1},
                                {"place", observers.names[best.observers[i]]},
                                {"seen_posts", best.seen_posts[i]}});
      }
    }
    print_json(json);
    return;
  }
  print_summary("{}: {} observers see {} of {} posts, {:.4g} km^2\n", one_line(arguments.output),
                counts.observers(), seen_posts, map.heights_m.size(), 1e-6 * area_m2(map, seen_posts));
  for (std::size_t i = 0; i < best.observers.size(); ++i) {
    fmt::print("best {}: {}, together {} posts\n", i + 1, observers.names[best.observers[i]],
               best.seen_posts[i]);
  }
}

void require_outputs(const TerrainViewshedArguments& arguments) {
  if (arguments.observer.empty() == arguments.points.empty()) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("expected --observer or --points, found {}",
                            arguments.points.empty() ? "neither" : "both"),
                "give --observer X,Z for one observer, or --points FILE for many");
  }
  require_extension(arguments.output, {".tif", ".tiff"});
  for (const std::string& file : {arguments.united, arguments.needed}) {
    if (!file.empty()) require_extension(file, {".tif", ".tiff"});
  }
  require_answer_name(arguments.shares);
  require_distinct({{"--output", arguments.output},
                    {"--union", arguments.united},
                    {"--shares", arguments.shares},
                    {"--needed", arguments.needed}});
  for (const std::string& file : {arguments.output, arguments.united, arguments.shares, arguments.needed}) {
    require_new(file, arguments.existing,
                {{arguments.input.file(), arguments.points}, arguments.input.trust()});
  }
}

void run(const TerrainViewshedArguments& arguments, const GlobalOptions& options) {
  require_outputs(arguments);
  GivenPlace given;
  if (arguments.points.empty())
    given =
        read_place("--observer", arguments.observer, PlaceForm::plan, arguments.places.system(), "1200,350");
  const terrain::ViewshedParameters parameters = arguments.settings.read({.curve = arguments.curve.read()});
  const ViewshedSettings settings = arguments.more.read();
  if (settings.highest_rad <= settings.lowest_rad) {
    throw Error(
        ErrorKind::bad_usage,
        fmt::format("--highest-deg: expected an angle above --lowest-deg {:g}, found {:g}",
                    settings.lowest_rad / radians_per_degree, settings.highest_rad / radians_per_degree),
        "give the lower angle as --lowest-deg");
  }
  require_flags_of(arguments.input, arguments.cache);
  std::optional<TileStore> store;
  SeenMap seen_map;
  if (is_tile_store(arguments.input.file())) {
    store.emplace(arguments.input.file(), arguments.input.trust());
  } else {
    seen_map.map = arguments.input.read().map;
  }
  const MapFrame frame =
      frame_of(arguments.input.file(), store ? scene::place_of(store->header()) : seen_map.map);
  Observers observers;
  if (arguments.points.empty()) {
    const glm::dvec2 place_m =
        PlaceSystem(frame, arguments.places.system()).within_map("--observer", given.place);
    require_within("--observer", frame.spacing_x_m * (frame.columns - 1),
                   frame.spacing_z_m * (frame.rows - 1), place_m.x, place_m.y);
    observers.add(observer_of(parameters, settings, place_m), "--observer");
  } else {
    observers = read_observers(arguments, frame, parameters, settings);
  }
  if (store) seen_map = read_near(arguments, *store, observers.all);
  const ocl::Device device = ocl::Device::open(choose_one_device(options.device));
  if (arguments.points.empty()) {
    look_from_one(arguments, settings, observers, seen_map, device, options);
  } else {
    look_from_all(arguments, settings, observers, seen_map, frame, device, options);
  }
}

}  // namespace

void add_terrain_viewshed_command(CLI::App& terrain, GlobalOptions& options) {
  const auto arguments = std::make_shared<TerrainViewshedArguments>();
  CLI::App* command = terrain.add_subcommand(
      "viewshed", "write a viewshed as a GeoTIFF: the posts seen from one or more observers");
  arguments->input.add_to(*command);
  arguments->cache.add_to(*command);
  const auto add = [&](const char* names, std::string& target, const char* placeholder, const char* help) {
    return command->add_option(names, target, help)->type_name(placeholder);
  };
  add("--observer", arguments->observer, "X,Z", "place of the observer: m, or coordinates of --crs");
  arguments->places.add_to(*command);
  arguments->settings.add_to(*command, viewshed_rows());
  arguments->more.add_to(*command, angle_rows());
  arguments->curve.add_to(*command);
  add("-o,--output", arguments->output, "FILE", "GeoTIFF to write (.tif), complete or not at all")
      ->required();
  add("--needed", arguments->needed, "FILE",
      "also write a GeoTIFF of the smallest height above ground at which a target is seen, in m; takes "
      "longer");
  constexpr const char* many = "Many observers";
  CLI::Option* points = add("--points", arguments->points, "FILE",
                            (points_help(observer_columns().numbers, "points") +
                             fmt::format("\nColumns and attributes {} replace the flags of these names",
                                         fmt::join(observer_columns().numbers.optional, ", ")))
                                .c_str())
                            ->group(many)
                            ->excludes(command->get_option("--observer"));
  add_layer_option(*command, arguments->layer, many);
  add("--union", arguments->united, "FILE",
      "also write a GeoTIFF of the posts that at least one observer sees")
      ->group(many)
      ->needs(points);
  add("--shares", arguments->shares, "FILE",
      "also write what each observer sees, as CSV or GeoPackage (.gpkg)")
      ->group(many)
      ->needs(points);
  arguments->more.add_to(*command, best_rows(), many);
  command->get_option("--best")->needs(points);
  add_force_flag(*command, arguments->existing);
  command->add_flag("--json", arguments->json, "print the results as JSON");
  add_global_options(*command, options, DeviceUse::one);
  command->footer(fmt::format(R"(
{}
The raster has one byte per post and the georeference of the map: 255 seen, 0 hidden, 128 (nodata) where the
map has a void. What is seen is exact: it follows the surface between the posts instead of stepping from
post to post. For a tile store, the raster covers the square that --radius-m reaches, in full detail.
--cache-mb must be large enough for it, at 12 bytes per post.

With --points, the raster has 16 bits per post: how many observers see it, 65535 (nodata) where the map has
a void. A count is the sum of the viewsheds of single observers.

Examples:
  offing terrain viewshed S33W071.tif --observer 47000,55000 -o seen.tif
  offing terrain viewshed S33W071.tif --crs lonlat --observer -70.5,-32.6 -o seen.tif
  offing terrain viewshed S33W071.tif --observer 47000,55000 --observer-height-m 30 --target-height-m 2 \
    --radius-m 40000 --curvature -o mast.tif
  offing terrain viewshed S33W071.tif --points masts.gpkg --best 3 --shares seen.gpkg -o counts.tif)",
                              place_footer));
  command->callback([arguments, &options] { run(*arguments, options); });
}

}  // namespace offing::cli
