// `offing ocean spectrum`: measured spectra as text, pictures and files.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <CLI/Option.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/base/error.h"
#include "host/base/progress.h"
#include "host/base/wave_spectrum.h"
#include "host/cli/common/direction_text.h"
#include "host/cli/ocean/ocean_commands.h"
#include "host/cli/pictures/spectrum_plot.h"
#include "host/command_line/general_flags.h"
#include "host/command_line/new_output.h"
#include "host/command_line/setting_options.h"
#include "host/io/file_extension.h"
#include "host/io/spectra/read_spectra.h"
#include "host/io/spectra/write_ww3_spectra.h"
#include "host/ocean/spectrum/sea_spectrum.h"
#include "host/ocean/spectrum/spectrum_parameters.h"

namespace offing::cli {
namespace {

/// Mean direction of travel at one frequency, from the first circular moment of its spreading.
std::optional<double> row_direction_rad(const WaveSpectrum& record, std::size_t row) {
  if (!record.is_directional() || record.energy[row] <= 0.0) {
    return std::nullopt;
  }
  const std::size_t count = record.directions_rad.size();
  double cosine = 0.0;
  double sine = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    cosine += record.spreading[row * count + i] * std::cos(record.directions_rad[i]);
    sine += record.spreading[row * count + i] * std::sin(record.directions_rad[i]);
  }
  return std::atan2(sine, cosine);
}

/// A record as text: its figures, and a line a frequency with energy, mean direction and a bar. At most 80
/// columns.
std::string spectrum_text(const WaveSpectrum& record, const ocean::SeaState& state, DirectionStyle style) {
  constexpr double bar_width = 40.0;
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "{}{}{}\n", record.station.empty() ? "" : record.station + "  ", record.time_utc,
                 record.depth_m ? fmt::format("  depth {:.4g} m", *record.depth_m) : "");
  fmt::format_to(out, "Hs {:.3f} m  peak period {:.2f} s  Tz {:.2f} s  Tm01 {:.2f} s  Tp of E^4 {:.2f} s\n",
                 state.hs_m, state.peak_period_s, state.tm02_s, state.tm01_s, state.tp_s);
  if (record.is_directional() && state.m0_m2 > 0.0) {
    fmt::format_to(out, "mean direction {:.1f}, peak direction {:.1f} {}; spread {:.1f} deg\n",
                   direction_deg(state.mean_direction_rad, style),
                   direction_deg(state.peak_direction_rad, style), direction_unit(style),
                   state.spread_rad * degrees_per_radian);
  }
  fmt::format_to(out, "\n{:>8}  {:>10}  {:>11}\n", "Hz", "m^2/Hz", direction_unit(style));
  const double largest = *std::max_element(record.energy.begin(), record.energy.end());
  for (std::size_t i = 0; i < record.frequencies_hz.size(); ++i) {
    const auto direction_rad = row_direction_rad(record, i);
    const double share = largest > 0.0 ? record.energy[i] / largest : 0.0;
    fmt::format_to(out, "{:>8.4f}  {:>10.4g}  {:>11}  {}\n", record.frequencies_hz[i], record.energy[i],
                   direction_rad ? fmt::format("{:.0f}", direction_deg(*direction_rad, style)) : "-",
                   std::string(static_cast<std::size_t>(std::lround(bar_width * share)), '#'));
  }
  return fmt::to_string(text);
}

struct SpectrumSettings {
  int record = -1;  ///< below 0: all
};

struct SpectrumArguments {
  std::string file;
  SettingOptions<SpectrumSettings> settings;
  std::string plot;
  std::string export_file;
  bool json = false;
  Existing existing = Existing::keep;
  DirectionStyle directions = DirectionStyle::travel;
  Trust trust = Trust::trusted;
};

/// The sea state of a record, in deep water unless the file says otherwise; all 0 for a record without
/// energy.
ocean::SeaState state_of(const WaveSpectrum& record) {
  if (variance_m2(record) <= 0.0) {
    return {};
  }
  ocean::Dispersion dispersion;
  if (record.depth_m) {
    dispersion.depth_m = *record.depth_m;
  }
  if (record.is_directional()) {
    return ocean::integrate_sea_state(ocean::from_measured(record, {}, dispersion));
  }
  // Heights and periods are the same whatever the directions. These are summed once a record, where a model's
  // spreading would be evaluated thousands of times.
  WaveSpectrum isotropic = record;
  isotropic.directions_rad = {0.0, 2.0 * std::numbers::pi / 3.0, 4.0 * std::numbers::pi / 3.0};
  isotropic.spreading.assign(3 * record.frequencies_hz.size(), 0.5 / std::numbers::pi);
  return ocean::integrate_sea_state(ocean::from_measured(isotropic, {}, dispersion));
}

/// A record of the file with what it comes to.
struct Listed {
  std::size_t index;
  const WaveSpectrum& record;
  ocean::SeaState state;
};

/// The chosen record, or all. Thousands take half a minute: tells how far it is, and stops when asked to.
std::vector<Listed> integrate(const std::vector<WaveSpectrum>& records, std::optional<std::size_t> chosen,
                              const GlobalOptions& options) {
  const std::size_t first = chosen.value_or(0), count = chosen ? 1 : records.size();
  constexpr std::size_t done_in_a_blink = 100;
  Progress progress(static_cast<int>(count), "records",
                    count <= done_in_a_blink ? Verbosity::quiet : options.verbosity);
  std::vector<Listed> listed;
  for (std::size_t i = first; i < first + count; ++i) {
    options.cancel.throw_if_cancelled();
    listed.push_back({i, records[i], state_of(records[i])});
    progress.advance();
  }
  return listed;
}

nlohmann::json to_json(const Listed& listed, DirectionStyle style) {
  const auto& [index, record, state] = listed;
  nlohmann::json json = {{"record", index},           {"time_utc", record.time_utc},
                         {"station", record.station}, {"directional", record.is_directional()},
                         {"hs_m", state.hs_m},        {"peak_period_s", state.peak_period_s},
                         {"tp_s", state.tp_s},        {"tm01_s", state.tm01_s},
                         {"tm02_s", state.tm02_s},    {"tz_s", state.tm02_s}};
  for (const char* name : {"mean_direction_deg", "peak_direction_deg", "spread_deg"}) json[name] = nullptr;
  if (record.is_directional()) {
    json["mean_direction_deg"] = direction_deg(state.mean_direction_rad, style);
    json["peak_direction_deg"] = direction_deg(state.peak_direction_rad, style);
    json["spread_deg"] = state.spread_rad * degrees_per_radian;
  }
  json["depth_m"] = record.depth_m ? nlohmann::json(*record.depth_m) : nlohmann::json();
  return json;
}

void print_list(const std::string& file, const std::vector<Listed>& records, DirectionStyle style) {
  const WaveSpectrum& first = records.front().record;
  fmt::print("{}: {} record{}, {} frequencies {:.4g} ... {:.4g} Hz{}\n", file, records.size(),
             records.size() == 1 ? "" : "s", first.frequencies_hz.size(), first.frequencies_hz.front(),
             first.frequencies_hz.back(), first.is_directional() ? ", directional" : ", without directions");
  fmt::print("{:>6}  {:<20}  {:>7}  {:>6}  {:>6}  {:>15}  {:>6}\n", "record", "time", "Hs m", "peak s",
             "Tz s", direction_unit(style), "spread");
  for (const auto& [index, record, state] : records) {
    const std::string direction = record.is_directional() && state.m0_m2 > 0.0
                                      ? fmt::format("{:.1f}", direction_deg(state.mean_direction_rad, style))
                                      : "-";
    const std::string spread = record.is_directional() && state.m0_m2 > 0.0
                                   ? fmt::format("{:.1f}", state.spread_rad * degrees_per_radian)
                                   : "-";
    fmt::print("{:>6}  {:<20}  {:>7.3f}  {:>6.2f}  {:>6.2f}  {:>15}  {:>6}\n", index, record.time_utc,
               state.hs_m, state.peak_period_s, state.tm02_s, direction, spread);
  }
}

scene::Parameter record_facts() {
  scene::Parameter facts = like_scene("ocean.record", "--record", "record to print and plot, counted from 0");
  facts.example = "0";
  facts.absent = "list all";
  return facts;
}

/// The record that --record names; none: list all.
std::optional<std::size_t> chosen_of(const SpectrumArguments& arguments, std::size_t count) {
  const NarrowedRange there{.flag = "--record", .high = static_cast<double>(count) - 1.0};
  const int record = arguments.settings.read({}, there).record;
  return record < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(record));
}

/// A plot shows one record: a file of many needs --record.
void require_one_record(const SpectrumArguments& arguments, std::optional<std::size_t> chosen,
                        std::size_t count) {
  if (arguments.plot.empty() || chosen || count == 1) return;
  throw Error(ErrorKind::bad_usage,
              fmt::format("--plot: expected --record to choose one of the {} records, found none", count),
              fmt::format("write --record N with N within [0, {}]", count - 1));
}

void run(const SpectrumArguments& arguments, const GlobalOptions& options) {
  if (!arguments.plot.empty()) require_extension(arguments.plot, {".png"});
  const std::vector<WaveSpectrum> records = read_spectra(arguments.file, arguments.trust);
  const std::optional<std::size_t> chosen = chosen_of(arguments, records.size());
  require_one_record(arguments, chosen, records.size());
  require_distinct({{"--plot", arguments.plot}, {"--export-spectrum", arguments.export_file}});
  for (const std::string* output : {&arguments.plot, &arguments.export_file}) {
    if (output == &arguments.export_file && is_standard_output(*output)) continue;  // text
    require_new(*output, arguments.existing, {{arguments.file}, arguments.trust});
  }
  if (!arguments.plot.empty()) {
    const WaveSpectrum& drawn = records[chosen.value_or(0)];
    write_spectrum_plot(arguments.plot, drawn, state_of(drawn), arguments.directions, arguments.existing);
  }
  if (!arguments.export_file.empty()) {
    const std::span<const WaveSpectrum> all(records);
    const std::span<const WaveSpectrum> exported = chosen ? all.subspan(*chosen, 1) : all;
    if (is_standard_output(arguments.export_file)) {
      fmt::print("{}", ww3_text(arguments.file, exported));
      return;
    }
    write_ww3_spectra(arguments.export_file, exported, arguments.existing);
  }

  const std::vector<Listed> listed = integrate(records, chosen, options);
  if (arguments.json) {
    nlohmann::json json = {{"file", arguments.file}, {"records", nlohmann::json::array()}};
    for (const Listed& one : listed) {
      json["records"].push_back(to_json(one, arguments.directions));
    }
    if (chosen) {
      json["records"][0]["frequencies_hz"] = records[*chosen].frequencies_hz;
      json["records"][0]["energy_m2_per_hz"] = records[*chosen].energy;
    }
    fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
    return;
  }
  if (chosen) {
    fmt::print("{}", spectrum_text(listed.front().record, listed.front().state, arguments.directions));
  } else {
    print_list(arguments.file, listed, arguments.directions);
  }
}

}  // namespace

void add_spectrum_command(CLI::App& ocean, GlobalOptions& options) {
  const auto arguments = std::make_shared<SpectrumArguments>();
  CLI::App* command = ocean.add_subcommand("spectrum", "list, plot and convert measured wave spectra");
  command
      ->add_option("FILE", arguments->file,
                   "measured spectra: NDBC, WAVEWATCH III, SWAN, Datawell, TRIAXYS, Octopus, Spotter or "
                   "NetCDF")
      ->required()
      ->type_name("");
  arguments->settings.add_to(*command, {{&SpectrumSettings::record, record_facts()}});
  command
      ->add_option("--plot", arguments->plot,
                   "write a plot (.png): energy against frequency, and as a polar diagram")
      ->type_name("FILE");
  command
      ->add_option("--export-spectrum", arguments->export_file,
                   "write the record, or all records, as WAVEWATCH III text (.spec); -: standard output, "
                   "without other text")
      ->type_name("FILE");
  add_force_flag(*command, arguments->existing);
  command->add_flag("--json", arguments->json, "print the results as JSON");
  command->add_flag_callback(
      "--compass", [arguments] { arguments->directions = DirectionStyle::from_bearing; },
      "print compass directions: where waves come from, clockwise from north (default: where they go, from "
      "east toward south); does not change written files");
  add_trust_flag(*command, arguments->trust);
  add_global_options(*command, options, DeviceUse::none);
  command->footer(R"(
m_n is the integral of f^n E(f) over the frequencies of the file. Hs is 4 sqrt(m0), Tm01 is m0 / m1, and
Tz (tz_s, tm02_s) is sqrt(m0 / m2). The peak period is 1 / f where E is largest. Tp of E^4 (tp_s) is the
integral of E^4 over that of f E^4, which is steadier where the peak is broad. The mean direction is that of
the mean vector of all energy. The spread is sqrt(2 (1 - r)), r the length of that vector. The peak direction
is that of the waves at the peak period.

Examples:
  offing ocean spectrum 41010.data_spec
  offing ocean spectrum 41010.data_spec --record 0 --plot sea.png)");
  command->callback([arguments, &options] { run(*arguments, options); });
}

}  // namespace offing::cli
