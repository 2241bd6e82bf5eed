#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/Option.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/base/error.h"
#include "host/base/progress.h"
#include "host/base/utc_time.h"
#include "host/cli/common/device_choice.h"
#include "host/cli/common/parameter_options.h"
#include "host/cli/ocean/ocean_commands.h"
#include "host/cli/ocean/query_settings.h"
#include "host/cli/ocean/query_text.h"
#include "host/cli/ocean/series_file.h"
#include "host/cli/ocean/wake_history.h"
#include "host/cli/ocean/water_left_out.h"
#include "host/command_line/new_output.h"
#include "host/command_line/print_results.h"
#include "host/command_line/setting_options.h"
#include "host/io/atomic_file.h"
#include "host/io/file_extension.h"
#include "host/io/number_table.h"
#include "host/scene/file/scene_hash.h"
#include "host/scene/prepare/sea.h"

namespace offing::cli {

namespace {

/// Points that are asked for at once.
constexpr std::size_t block_points = 65536;

struct QuerySettings {
  double time_s = 0.0;
  ocean::WaterQuery query;
};

struct QueryArguments {
  ParameterOptions parameters;
  std::string at, points_file, times, output_file;
  SettingOptions<QuerySettings> settings;
  bool json = false, is_exact = false;
  Existing existing = Existing::keep;

  bool writes_file() const { return !output_file.empty() && !is_standard_output(output_file); }
  bool writes_netcdf() const { return writes_file() && lower_extension(output_file) == ".nc"; }
};

/// The points of the command: one, or those of a file, in blocks.
class PointSource {
 public:
  PointSource(const QueryArguments& arguments, const TimeRange& times) {
    if (arguments.points_file.empty()) {
      single_ = read_point("--at", arguments.at);
      return;
    }
    file_.emplace(arguments.points_file, NumberColumns{.names = {"x_m", "z_m"},
                                                       .meaning = "for each point, its x and z in m",
                                                       .example = "12.5,-40"});
    // NetCDF begins with the number of points.
    const std::int64_t readings = times.count + (arguments.writes_netcdf() ? 1 : 0);
    if (readings > 1 && !file_->can_rewind()) {
      throw Error(
          ErrorKind::bad_usage,
          fmt::format(
              "--points: expected a file that can be read {} times, found one that can be read only once: {}",
              readings, arguments.points_file),
          "write the points to a file first, or ask for one time as CSV");
    }
  }

  /// Reads all of them, and goes back to the first.
  std::size_t count() {
    std::size_t count = 0;
    for (auto block = next(); !block.empty(); block = next()) count += block.size();
    rewind();
    return count;
  }

  /// Back to the first point. What was not read yet is not rewound: a pipe cannot be.
  void rewind() {
    if (file_ && !is_at_start_) {
      file_->rewind();
    }
    is_at_start_ = true;
  }

  /// None at the end.
  std::vector<ocean::WaterPoint> next() {
    std::vector<ocean::WaterPoint> points;
    if (file_) {
      const std::vector<double> numbers = file_->next(block_points);
      for (std::size_t i = 0; i < numbers.size(); i += 2) points.push_back({numbers[i], numbers[i + 1]});
    } else if (is_at_start_) {
      points.push_back(single_);
    }
    is_at_start_ = false;
    return points;
  }

 private:
  ocean::WaterPoint single_;
  std::optional<NumberTable> file_;
  bool is_at_start_ = true;
};

/// Where answers go: a file that appears when all are there, or standard output; as CSV, NetCDF, JSON or in
/// words.
class AnswerSink {
 public:
  AnswerSink(const QueryArguments& arguments, const TimeRange& times, const SeriesFile::Facts& facts)
      : depth_m_(facts.depth_m), style_(style_of(arguments, times)) {
    if (style_ == Style::netcdf) {
      series_.emplace(arguments.output_file, arguments.existing, facts);
    } else if (arguments.writes_file()) {
      file_.emplace(arguments.output_file, arguments.existing);
    }
    if (style_ == Style::csv) {
      text_ = csv_header();
    } else if (style_ == Style::json_array) {
      text_ = "[";
    }
  }

  void add(const QueryAnswer& answer) {
    ++count_;
    largest_residual_m_ = std::max(largest_residual_m_, answer.sample.residual_m);
    error_rms_m_ = std::max(error_rms_m_, answer.sample.error_rms_m);
    missed_ += answer.sample.residual_m <= ocean::WaterQuery{}.tolerance_m * 1.1 ? 0 : 1;
    if (series_) {
      series_->add(answer);
    } else if (style_ == Style::csv) {
      append_csv(answer, text_);
    } else if (style_ == Style::json_object) {
      text_ += to_json(answer).dump(2) + '\n';
    } else if (style_ == Style::json_array) {
      text_ += (count_ > 1 ? ",\n " : "\n ") + to_json(answer).dump();
    } else {
      text_ += query_text(answer, depth_m_);
    }
  }

  /// Passes on what was added.
  void flush() {
    if (series_) {
      series_->flush();
    } else if (file_) {
      file_->write(text_);
    } else {
      fmt::print("{}", text_);
    }
    text_.clear();
  }

  void finish() {
    if (style_ == Style::json_array) {
      text_ += "\n]\n";
    }
    flush();
    if (series_) {
      series_->finish();
    } else if (file_) {
      file_->commit();
    }
  }

  std::size_t count() const { return count_; }
  std::size_t missed() const { return missed_; }
  float largest_residual_m() const { return largest_residual_m_; }
  float error_rms_m() const { return error_rms_m_; }

 private:
  enum class Style { words, csv, netcdf, json_object, json_array };

  static Style style_of(const QueryArguments& arguments, const TimeRange& times) {
    if (arguments.writes_file()) {
      if (arguments.writes_netcdf()) return Style::netcdf;
      return lower_extension(arguments.output_file) == ".json" ? Style::json_array : Style::csv;
    }
    const bool is_single = arguments.points_file.empty() && times.count == 1;
    if (arguments.json) {
      return is_single ? Style::json_object : Style::json_array;
    }
    return is_single && arguments.output_file.empty() ? Style::words : Style::csv;
  }

  double depth_m_;
  Style style_;
  std::optional<AtomicFile> file_;
  std::optional<SeriesFile> series_;
  std::string text_;
  std::size_t count_ = 0, missed_ = 0;
  float largest_residual_m_ = 0.0f, error_rms_m_ = 0.0f;
};

TimeRange read_times(const QueryArguments& arguments) {
  if (!arguments.times.empty()) {
    return read_time_range("--times", arguments.times);
  }
  return {.first_s = arguments.settings.read().time_s};
}

std::vector<scene::Row<QuerySettings>> flow_rows() {
  constexpr auto query = &QuerySettings::query;
  return {{scene::path(query, &ocean::WaterQuery::depth_m),
           velocity_depth_facts(
               "velocity, pressure and acceleration at this depth below the moving surface, down to the "
               "bed, by linear theory with Wheeler stretching")},
          {scene::path(query, &ocean::WaterQuery::min_wavelength_m),
           {.key = "min_wavelength_m",
            .unit = "m",
            .low = 0.0,
            .high = ocean::longest_filter_m,
            .help = "leave out waves shorter than this, which do not move a longer hull",
            .example = "30"}},
          {scene::choice(scene::path(query, &ocean::WaterQuery::accuracy),
                         {"automatic", "exact", "maps", "frame-maps"}),
           {.key = "accuracy",
            .help = "exact: sum all waves for each point\nmaps: splines on fine maps, made once for each "
                    "time\nframe-maps: linear interpolation of the maps of a bake; short waves lose a "
                    "quarter of their slopes, and there is no acceleration\nautomatic: exact for up to 16 "
                    "points, else maps"}}};
}

void answer(ocean::Ocean& sea, std::optional<WakeHistory>& wakes, const ocean::WaterQuery& query,
            const TimeRange& times, PointSource& points, AnswerSink& sink, const GlobalOptions& options) {
  Progress progress(static_cast<int>(times.count), "times",
                    times.count > 1 ? options.verbosity : Verbosity::quiet);
  for (std::int64_t i = 0; i < times.count; ++i) {
    const double time_s = times.time_s(i);
    sea.at(time_s);
    if (wakes) wakes->at(time_s);
    points.rewind();
    for (auto block = points.next(); !block.empty(); block = points.next()) {
      options.cancel.throw_if_cancelled();
      const std::vector<ocean::WaterSample> samples = sea.sample(block, query);
      for (std::size_t point = 0; point < block.size(); ++point) {
        sink.add({time_s, block[point], samples[point]});
      }
      sink.flush();
    }
    progress.advance();
  }
  sink.finish();
}

nlohmann::ordered_json summary_json(const QueryArguments& arguments, const ocean::WaterQuery& query,
                                    const TimeRange& times, const AnswerSink& sink, const std::string& hash) {
  return {{"file", arguments.output_file},
          {"times", times.count},
          {"samples", sink.count()},
          {"depth_m", query.depth_m},
          {"min_wavelength_m", query.min_wavelength_m},
          {"largest_residual_m", shortest_decimals(sink.largest_residual_m())},
          {"error_rms_m", shortest_decimals(sink.error_rms_m())},
          {"scene_hash", hash}};
}

/// The moment that times of the sea count from: when the sun stands where the scene has it, else that of the
/// measured record, else the epoch of Unix, as no better one is known.
std::string time_origin(const scene::Scene& scene, const scene::Sea& sea) {
  std::optional<UtcTime> origin = scene.view.sun_time_utc;
  if (!origin && sea.measured) origin = parse_iso_time(sea.measured->time_utc);
  return iso_time(origin.value_or(from_unix_seconds(0))).value_or("");
}

void run(const QueryArguments& arguments, const GlobalOptions& options) {
  if (arguments.at.empty() == arguments.points_file.empty()) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("offing ocean query: expected --at or --points, found {}",
                            arguments.at.empty() ? "neither" : "both"),
                "write --at 12.5,-40 for one point, or --points FILE for many");
  }
  if (arguments.existing == Existing::replace && arguments.output_file.empty()) {
    throw Error(ErrorKind::bad_usage, "--force: expected -o, found none",
                "add -o FILE, or leave --force out");
  }
  const TimeRange times = read_times(arguments);
  const scene::Scene scene = arguments.parameters.read();
  const scene::Sea sea = scene::prepare_sea(scene);
  warn_of_water_left_out(scene, "answers", WakeUse::included);
  const NarrowedRange water{.flag = "--velocity-depth-m", .high = sea.spectrum.dispersion.depth_m};
  ocean::WaterQuery query = arguments.settings.read({}, water).query;
  if (arguments.is_exact) query.accuracy = ocean::WaterQuery::Accuracy::exact;
  if (arguments.writes_file()) {
    GivenInputs inputs = arguments.parameters.inputs(scene);
    inputs.names.push_back(arguments.points_file);
    require_new(arguments.output_file, arguments.existing, inputs);
  }
  const std::string hash =
      scene::scene_hash(scene, sea,
                        fmt::format("query depth {:.17g} from {:.17g} accuracy {}", query.depth_m,
                                    query.min_wavelength_m, static_cast<int>(query.accuracy)),
                        scene.ocean.wakes.empty() ? scene::shapes_sea : scene::shapes_sea_and_wakes);
  PointSource points(arguments, times);
  AnswerSink sink(arguments, times,
                  {.points = arguments.writes_netcdf() ? points.count() : 0,
                   .time_origin = time_origin(scene, sea),
                   .depth_m = query.depth_m,
                   .min_wavelength_m = query.min_wavelength_m,
                   .scene_hash = hash});
  const ocl::Device device = ocl::Device::open(choose_one_device(options.device));
  ocean::Ocean ocean(device, sea.spectrum, sea.parameters);
  std::optional<WakeHistory> wakes = WakeHistory::of(device, scene, sea);
  if (wakes) ocean.set_wakes(wakes->maps());
  answer(ocean, wakes, query, times, points, sink, options);
  if (sink.missed() > 0) {
    spdlog::warn(
        "{} of {} samples miss their point by more than {:g} m, under crests that fold: see residual_m",
        sink.missed(), sink.count(), query.tolerance_m);
  }
  if (!arguments.writes_file()) {
    return;
  }
  if (arguments.json) {
    fmt::print("{}\n", summary_json(arguments, query, times, sink, hash).dump(2));
  } else {
    print_summary("{} sample{} written: {}\n", sink.count(), sink.count() == 1 ? "" : "s",
                  arguments.output_file);
  }
}

}  // namespace

void add_query_command(CLI::App& ocean, GlobalOptions& options) {
  using enum scene::ParameterGroup;
  const auto arguments = std::make_shared<QueryArguments>();
  CLI::App* command =
      ocean.add_subcommand("query", "compute height, normal, velocity, pressure and acceleration at points");
  constexpr const char* group = "Query";
  const auto add = [&](const char* names, std::string& target, const char* placeholder, const char* help) {
    return command->add_option(names, target, help)->type_name(placeholder)->group(group);
  };
  add("--at", arguments->at, "X,Z", "one point, in m: X east and Z south of the origin");
  add("--points", arguments->points_file, "FILE",
      "many points: CSV file with columns x_m and z_m, or without a header two numbers per line");
  arguments->settings.add_to(*command, {{&QuerySettings::time_s, time_facts("time of the samples")}}, group);
  add("--times", arguments->times, "A:B:DT", "several times, in s: A, A + DT, ... up to B")
      ->excludes(command->get_option("--time"));
  arguments->settings.add_to(*command, flow_rows(), group);
  command->add_flag("--exact", arguments->is_exact, "the same as --accuracy exact")
      ->excludes(command->get_option("--accuracy"))
      ->group(group);
  add("-o,--output", arguments->output_file, "FILE",
      "file to write, complete or not at all: NetCDF with CF names (.nc), a JSON array (.json), else CSV\n"
      "(default: -, CSV to standard output)");
  add_force_flag(*command, arguments->existing)->group(group);
  command
      ->add_flag("--json", arguments->json,
                 "print the results as JSON: an object for one point and time, else an array\nwith -o, "
                 "print a summary instead")
      ->group(group);
  arguments->parameters.add_to(*command, {world, sea, grid});
  add_global_options(*command, options, DeviceUse::one);
  command->footer(R"(
A sample is where the moving surface meets the vertical through a point. residual_m is how far it misses the
vertical: at most 0.0001 m, except under crests that fold. error_rms_m is the expected error of the height, a
root mean square, without folding crests. Axes are x east, y up, z south. Velocity and acceleration are those
of linear theory. Pressure is relative to the air, for sea water of 1025 kg/m^3. Rings of raindrops change
height, normal and pressure. Wakes change the vertical velocity too; bodies that make them are simulated from
time 0 on. Samples are sorted by time, then in the order of the points.

Examples:
  offing ocean query scenes/storm.toml --at 120,-35 --time 12.5 --velocity-depth-m 3
  offing ocean query scenes/storm.toml --points probes.csv --times 0:600:0.1 -o probes_out.csv
  offing ocean query scenes/storm.toml --points probes.csv --times 0:600:0.1 -o probes_out.nc
  offing ocean query --wind-speed-mps 15 --at 0,0 --times 0:60:0.5 --min-wavelength-m 40 --json)");
  command->callback([arguments, &options] { run(*arguments, options); });
}

}  // namespace offing::cli
