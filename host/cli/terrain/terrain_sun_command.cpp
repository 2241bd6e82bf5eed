#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "host/base/argument.h"
#include "host/base/error.h"
#include "host/base/progress.h"
#include "host/base/utc_time.h"
#include "host/cli/common/device_choice.h"
#include "host/cli/terrain/earth_curve_flags.h"
#include "host/cli/terrain/map_raster.h"
#include "host/cli/terrain/terrain_commands.h"
#include "host/cli/terrain/terrain_input.h"
#include "host/command_line/new_output.h"
#include "host/command_line/print_results.h"
#include "host/command_line/setting_options.h"
#include "host/io/file_extension.h"
#include "host/scene/prepare/maps/terrain_sun.h"

namespace offing::cli {

namespace {

constexpr std::int64_t seconds_per_hour = 3600, seconds_per_day = 86400;
// A mask is a band of a file that a GIS opens.
constexpr std::size_t most_masks = 2000;

struct SunCommandSettings {
  double turbidity = sky::usual_turbidity;
  int azimuths = terrain::usual_azimuths;
  double utc_offset_h = 0.0;
  std::optional<double> latitude_rad, longitude_rad;
};

struct TerrainSunArguments {
  TerrainInput input;
  EarthCurveFlags curve;
  SettingOptions<SunCommandSettings> settings;
  std::string from, to, step = "1h", output, masks;
  bool json = false;
  Existing existing = Existing::keep;
};

/// Whether a text has a form, in which d is a digit.
bool has_form(std::string_view text, std::string_view form) {
  return std::ranges::equal(text, form, [](char letter, char expected) {
    return expected == 'd' ? letter >= '0' && letter <= '9' : letter == expected;
  });
}

/// Of a text that is no day and no time.
[[noreturn]] void refuse_moment(std::string_view flag, const std::string& text) {
  constexpr std::string_view day = "dddd-dd-dd", offset = "+dd:dd";
  if (has_form(text, day) && !parse_iso_time(text + "T00:00Z")) {
    throw bad_argument(flag, "a day that exists, as YYYY-MM-DD", text, "2026-06-21");
  }
  const std::size_t sign = text.size() < offset.size() ? 0 : text.size() - offset.size();
  if (sign > day.size() && parse_iso_time(text.substr(0, sign) + "Z") &&
      (has_form(text.substr(sign), offset) || has_form(text.substr(sign), "-dd:dd"))) {
    const std::string hours = text.substr(sign, 3), minutes = text.substr(sign + 4);
    throw Error(ErrorKind::bad_usage,
                fmt::format("{}: expected a time without an offset from UTC, got \"{}\"", flag, text),
                fmt::format("write {} {} --utc-offset-h {:g}", flag, text.substr(0, sign),
                            std::stod(hours) + (hours[0] == '-' ? -1.0 : 1.0) * std::stod(minutes) / 60.0));
  }
  throw bad_argument(flag,
                     "a day or a time of the years 1901 to 2099, as YYYY-MM-DD, YYYY-MM-DDTHH:MM or "
                     "YYYY-MM-DDTHH:MMZ",
                     text, "2026-06-21");
}

/// Seconds since 1970 of a day's start or end, or of a time of day, both by a clock ahead of UTC.
std::int64_t read_moment(std::string_view flag, const std::string& text, bool is_end, double utc_offset_h) {
  std::optional<UtcTime> time = parse_iso_time(text);
  if (!time) time = parse_iso_time(text + "Z");
  const bool is_day = !time;
  if (is_day) time = parse_iso_time(text + "T00:00Z");
  constexpr int first_year = 1901, last_year = 2099;
  if (!time || time->year < first_year || time->year > last_year) {
    refuse_moment(flag, text);
  }
  const std::int64_t clock_s = unix_seconds(*time) + (is_day && is_end ? seconds_per_day : 0);
  return clock_s - std::llround(utc_offset_h * static_cast<double>(seconds_per_hour));
}

/// A time with its unit: s, min or h.
std::int64_t read_step(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const std::string_view unit(end, static_cast<std::size_t>(text.data() + text.size() - end));
  const double seconds = unit == "s" ? 1.0 : unit == "min" ? 60.0 : unit == "h" ? 3600.0 : 0.0;
  const double step_s = std::round(value * seconds);
  if (error != std::errc{} || !(step_s >= 1.0) || step_s > static_cast<double>(seconds_per_day)) {
    throw bad_argument("--step", "a time of 1 s to 24 h with its unit, s, min or h", text,
                       unit == "m" ? text + "in" : "15min");
  }
  return static_cast<std::int64_t>(step_s);
}

scene::SunSettings sun_settings(const TerrainSunArguments& arguments, const SunCommandSettings& settings) {
  const scene::SunSettings sun{.from_s = read_moment("--from", arguments.from, false, settings.utc_offset_h),
                               .to_s = read_moment("--to", arguments.to, true, settings.utc_offset_h),
                               .step_s = read_step(arguments.step),
                               .linke_turbidity = settings.turbidity,
                               .azimuths = settings.azimuths,
                               .curve = arguments.curve.read()};
  if (sun.to_s <= sun.from_s) {
    throw bad_argument("--to", fmt::format("a time after --from {}", printable(arguments.from)), arguments.to,
                       "2026-12-31");
  }
  const std::int64_t moments = (sun.to_s - sun.from_s) / sun.step_s;
  if (moments >= scene::most_moments) {
    throw bad_argument(
        "--step", fmt::format("at most {} steps from --from to --to, found {}", scene::most_moments, moments),
        arguments.step, "1h");
  }
  scene::require_valid(sun);
  return sun;
}

/// The place of the whole map, where the flags give one.
std::optional<sky::GeoPosition> given_position(const SunCommandSettings& settings) {
  if (settings.latitude_rad.has_value() != settings.longitude_rad.has_value()) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("expected --latitude-deg and --longitude-deg, found only --{}-deg",
                            settings.latitude_rad ? "latitude" : "longitude"),
                "give both: --latitude-deg -32.5 --longitude-deg -70.5");
  }
  if (!settings.latitude_rad) return std::nullopt;
  return sky::GeoPosition{*settings.latitude_rad, *settings.longitude_rad};
}

/// The file of masks: a band a moment.
std::unique_ptr<BandedRasterWriter> create_masks(const TerrainSunArguments& arguments, const HeightMap& map,
                                                 const terrain::RowBand& first,
                                                 const std::vector<std::int64_t>& times_s) {
  if (times_s.empty() || times_s.size() > most_masks) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("--masks: expected 1 ... {} times at which the sun is up, found {}", most_masks,
                    times_s.size()),
        times_s.empty() ? "give other days or a shorter --step" : "give fewer days or a longer --step");
  }
  std::vector<BandedRaster::Band> bands;
  for (const std::int64_t time_s : times_s) {
    bands.push_back({"", "sunlit at " + iso_time(from_unix_seconds(time_s)).value_or("?")});
  }
  return create_banded_raster(arguments.masks, raster_on_map(map, first, true, std::move(bands)),
                              arguments.existing);
}

void run_sun(const TerrainSunArguments& arguments, const GlobalOptions& options) {
  for (const std::string& file : {arguments.output, arguments.masks}) {
    if (!file.empty()) require_extension(file, {".tif", ".tiff"});
  }
  require_distinct({{"--output", arguments.output}, {"--masks", arguments.masks}});
  for (const std::string& file : {arguments.output, arguments.masks}) {
    require_new(file, arguments.existing, {{arguments.input.file()}, arguments.input.trust()});
  }
  const SunCommandSettings settings = arguments.settings.read();
  const scene::SunSettings when = sun_settings(arguments, settings);
  const std::optional<sky::GeoPosition> place = given_position(settings);
  const HeightMap map = arguments.input.read().map;
  const MapFrame frame = frame_of(arguments.input.file(), map);
  if (!place) scene::require_place(frame);
  const ocl::Device device = ocl::Device::open(choose_one_device(options.device));
  const terrain::HeightField field = make_field(map, device);
  scene::TerrainSun sun(device, field, map, frame, place, when);
  const std::vector<terrain::RowBand> bands = sun.bands();
  std::unique_ptr<BandedRasterWriter> masks;
  if (!arguments.masks.empty()) masks = create_masks(arguments, map, bands.front(), sun.up_s());
  const auto raster = create_banded_raster(
      arguments.output,
      raster_on_map(map, bands.front(), false,
                    {{"h", "hours of sun"}, {"kWh/m2", "direct sunlight on the ground under a clear sky"}}),
      arguments.existing);
  Progress progress(static_cast<int>(bands.size()), "blocks of rows", options.verbosity);
  RasterRange hours_range, energy_range;
  std::vector<float> hours, energy_kwh;
  std::vector<std::uint8_t> lit;
  for (const terrain::RowBand& band : bands) {
    options.cancel.throw_if_cancelled();
    const std::size_t posts = static_cast<std::size_t>(band.rows) * static_cast<std::size_t>(map.columns);
    hours.resize(posts);
    energy_kwh.resize(posts);
    sun.read(band, hours, energy_kwh);
    for (auto* values : {&hours, &energy_kwh}) mark_voids<float>(map, band, float_nodata, *values);
    raster->write(0, band.first_row, std::span<const float>(hours));
    raster->write(1, band.first_row, std::span<const float>(energy_kwh));
    hours_range.add(hours);
    energy_range.add(energy_kwh);
    lit.resize(masks ? posts : 0);
    for (std::size_t i = 0; masks && i < sun.up_s().size(); ++i) {
      sun.read_mask(band, i, lit);
      mark_voids<std::uint8_t>(map, band, byte_nodata, lit);
      masks->write(i, band.first_row, std::span<const std::uint8_t>(lit));
    }
    progress.advance();
  }
  options.cancel.throw_if_cancelled();
  if (masks) masks->commit();
  raster->commit();
  if (arguments.json) {
    const auto json_of = [](const RasterRange& range) {
      return nlohmann::ordered_json{
          {"lowest", range.low()}, {"mean", range.mean()}, {"highest", range.high()}};
    };
    print_json({{"file", arguments.output},
                {"columns", map.columns},
                {"rows", map.rows},
                {"from", iso_time(from_unix_seconds(when.from_s)).value_or("")},
                {"to", iso_time(from_unix_seconds(when.to_s)).value_or("")},
                {"step_s", when.step_s},
                {"times_up", sun.up_s().size()},
                {"hours", json_of(hours_range)},
                {"energy_kwh_per_m2", json_of(energy_range)},
                {"void_posts", std::count(map.is_void.begin(), map.is_void.end(), 1)}});
  } else {
    print_summary("{}: {:.6g} ... {:.6g} hours of sun, {:.5g} ... {:.5g} kWh/m^2\n",
                  one_line(arguments.output), hours_range.low(), hours_range.high(), energy_range.low(),
                  energy_range.high());
  }
}

scene::Parameter place_facts(std::string_view key, std::string_view flag, std::string_view help) {
  scene::Parameter facts = like_scene(key, flag, help);
  facts.absent = "the file's place";
  return facts;
}

std::vector<scene::Row<SunCommandSettings>> sun_rows() {
  return {
      {&SunCommandSettings::turbidity,
       {.key = "turbidity",
        .low = 1.0,
        .high = 20.0,
        .help = "Linke turbidity: number of clean, dry atmospheres that dim the sun as much; 2 in "
                "mountains, 3 in clear air, 5 in haze"}},
      {&SunCommandSettings::azimuths,
       {.key = "azimuths",
        .low = static_cast<double>(terrain::fewest_azimuths),
        .high = static_cast<double>(terrain::most_azimuths),
        .help = "azimuths in which horizons are found; between them they are linear"}},
      {&SunCommandSettings::utc_offset_h,
       {.key = "utc_offset_h",
        .unit = "h",
        .low = -14.0,
        .high = 14.0,
        .help = "how far the clock of --from and --to is ahead of UTC"}},
      {&SunCommandSettings::latitude_rad,
       place_facts("world.latitude_deg", "--latitude-deg", "latitude used for the whole map, with north up")},
      {&SunCommandSettings::longitude_rad, place_facts("world.longitude_deg", "--longitude-deg",
                                                       "longitude used for the whole map, east positive")}};
}

}  // namespace

void add_terrain_sun_command(CLI::App& terrain, GlobalOptions& options) {
  const auto arguments = std::make_shared<TerrainSunArguments>();
  CLI::App* command = terrain.add_subcommand(
      "sun", "map hours of sun, direct sunlight under a clear sky and shadows, as GeoTIFFs");
  arguments->input.add_to(*command);
  const auto add = [&](const char* names, std::string& target, const char* placeholder, const char* help) {
    return command->add_option(names, target, help)->type_name(placeholder);
  };
  add("--from", arguments->from, "DATE",
      "first day, such as 2026-06-21, or time, such as 2026-06-21T09:30; UTC")
      ->required();
  add("--to", arguments->to, "DATE", "last day, which counts whole, or time")->required();
  add("--step", arguments->step, "TIME", "time between sun positions, with its unit s, min or h; default 1h");
  arguments->settings.add_to(*command, sun_rows());
  arguments->curve.add_to(*command);
  add("-o,--output", arguments->output, "FILE",
      "GeoTIFF to write (.tif): hours of sun, and direct sunlight in kWh/m^2")
      ->required();
  add("--masks", arguments->masks, "FILE",
      "also write a GeoTIFF with a band per time at which the sun is up: 255 sunlit, 0 in shadow");
  add_force_flag(*command, arguments->existing);
  command->add_flag("--json", arguments->json, "print the results as JSON");
  add_global_options(*command, options, DeviceUse::one);
  command->footer(R"(
The sun shines where part of its disc is above the horizon of the terrain, lifted by refraction as in
almanacs: on level ground, when its centre is above -0.833 degrees. Sunlight follows the clear-sky model of
Ineichen and Perez, on the ground as it slopes. Meridian convergence of the map is taken into account. A map
without a place in the world needs --latitude-deg and --longitude-deg. The rasters have the georeference of
the map.

Examples:
  offing terrain sun S33W071.tif --from 2026-01-01 --to 2026-12-31 --step 1h -o year.tif
  offing terrain sun valley.tif --latitude-deg 46.5 --longitude-deg 8 --from 2026-12-21 --to 2026-12-21 \
    --step 15min --masks shadows.tif -o solstice.tif)");
  command->callback([arguments, &options] { run_sun(*arguments, options); });
}

}  // namespace offing::cli
