#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/base/argument.h"
#include "host/base/error.h"
#include "host/base/log.h"
#include "host/cli/bodies/bodies_commands.h"
#include "host/cli/bodies/linear_body.h"
#include "host/cli/bodies/response_plot.h"
#include "host/cli/ocean/query_settings.h"
#include "host/command_line/general_flags.h"
#include "host/command_line/installed_scenes.h"
#include "host/command_line/new_output.h"
#include "host/command_line/print_results.h"
#include "host/io/atomic_file.h"
#include "host/io/file_extension.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/file/scene_files.h"

namespace offing::cli {
namespace {

using Json = nlohmann::ordered_json;
constexpr double turn = 2.0 * std::numbers::pi, degree = turn / 360.0;
constexpr std::size_t most_values = 2000;

struct RaoArguments {
  std::string scene, periods = "4:20:0.25", directions = "180,90,0", output, plot, body;
  bool json = false;
  Existing existing = Existing::keep;
  Trust trust = Trust::trusted;
};

/// "A:B:D", or numbers with commas between them, within [low, high].
std::vector<double> read_values(std::string_view flag, std::string_view text, double low, double high,
                                std::string_view example) {
  const auto bad = [&] {
    return bad_argument(flag,
                        fmt::format("A:B:DT or up to {} numbers with commas between them, from {:g} to {:g}",
                                    most_values, low, high),
                        text, example);
  };
  std::vector<double> numbers;
  const bool is_range = text.find(':') != std::string_view::npos;
  if (is_range) {
    const TimeRange range = read_time_range(flag, text, example);
    if (range.count > static_cast<std::int64_t>(most_values)) throw bad();
    for (std::int64_t i = 0; i < range.count; ++i) numbers.push_back(range.time_s(i));
  }
  const char *at = text.data(), *const end = at + text.size();
  while (!is_range) {
    const auto [after, error] = std::from_chars(at, end, numbers.emplace_back());
    if (error != std::errc{} || !std::isfinite(numbers.back()) || numbers.size() > most_values) throw bad();
    at = after;
    if (at == end) break;
    if (*at++ != ',') throw bad();
  }
  for (const double number : numbers) {
    if (number < low || number > high) throw bad();
  }
  return numbers;
}

struct BodyResponses {
  const LinearBody* body;
  std::vector<ResponseCurve> curves;  ///< [direction]
};

std::string csv_of(const std::vector<BodyResponses>& all, const std::vector<double>& periods_s,
                   const std::vector<double>& directions_deg) {
  std::string text = "body,direction_deg,period_s";
  for (std::size_t i = 0; i < hull_motions; ++i)
    text += fmt::format(",{0}_{1},{0}_lead_deg", motion_names[i], i < 3 ? "mpm" : "degpm");
  text += '\n';
  for (const BodyResponses& responses : all) {
    std::string name = one_line(responses.body->body.name);
    std::ranges::replace(name, ',', ' ');
    for (std::size_t d = 0; d < directions_deg.size(); ++d) {
      for (std::size_t k = 0; k < periods_s.size(); ++k) {
        const Response& response = responses.curves[d].responses[k];
        text += fmt::format("{},{:.6g},{:.6g}", name, directions_deg[d], periods_s[k]);
        for (std::size_t i = 0; i < hull_motions; ++i) {
          text += fmt::format(",{:.6g},{:.2f}", response.amplitude[i] / (i < 3 ? 1.0 : degree),
                              response.lead_rad[i] / degree);
        }
        text += '\n';
      }
    }
  }
  return text;
}

Json json_of(const std::vector<BodyResponses>& all, const std::vector<double>& periods_s,
             const std::vector<double>& directions_deg) {
  Json list = Json::array();
  for (const BodyResponses& responses : all) {
    Json waves = Json::array();
    for (std::size_t d = 0; d < directions_deg.size(); ++d) {
      for (std::size_t k = 0; k < periods_s.size(); ++k) {
        const Response& response = responses.curves[d].responses[k];
        Json wave = {{"direction_deg", directions_deg[d]}, {"period_s", periods_s[k]}};
        for (std::size_t i = 0; i < hull_motions; ++i) {
          wave[fmt::format("{}_{}", motion_names[i], i < 3 ? "mpm" : "degpm")] =
              response.amplitude[i] / (i < 3 ? 1.0 : degree);
          wave[fmt::format("{}_lead_deg", motion_names[i])] = response.lead_rad[i] / degree;
        }
        waves.push_back(std::move(wave));
      }
    }
    list.push_back(
        {{"name", responses.body->body.name}, {"source", responses.body->data->source}, {"waves", waves}});
  }
  return {{"bodies", list}};
}

void warn_of_range(const LinearBody& body, const std::vector<double>& periods_s) {
  const double longest = turn / body.data->frequencies_radps.front();
  const double shortest = turn / body.data->frequencies_radps.back();
  const auto [low, high] = std::ranges::minmax_element(periods_s);
  if (*low < shortest * 0.999 || *high > longest * 1.001) {
    spdlog::warn("{}: its hydrodynamic data reach from {:.3g} to {:.3g} s; other periods take the nearest",
                 one_line(body.body.name), shortest, longest);
  }
}

void run(const RaoArguments& arguments) {
  const std::vector<double> periods_s = read_values("--periods", arguments.periods, 0.1, 1000.0, "4:20:0.5");
  const std::vector<double> directions_deg =
      read_values("--directions", arguments.directions, -360.0, 360.0, "180,90");
  const scene::Scene scene = scene::load_scene(arguments.scene, arguments.trust);
  GivenInputs inputs{scene::files_of(scene), arguments.trust};
  inputs.names.push_back(arguments.scene);
  const std::string file = is_standard_output(arguments.output) ? "" : arguments.output;
  require_new(file, arguments.existing, inputs);
  if (!arguments.plot.empty()) require_extension(arguments.plot, {".png"});
  require_new(arguments.plot, arguments.existing, inputs);
  require_distinct({{"--output", file}, {"--plot", arguments.plot}});

  const std::vector<LinearBody> bodies = linear_bodies(scene);
  std::vector<BodyResponses> all;
  for (const LinearBody& body : bodies) {
    if (!arguments.body.empty() && body.body.name != arguments.body) continue;
    warn_of_range(body, periods_s);
    BodyResponses responses{&body, {}};
    for (const double direction : directions_deg) {
      ResponseCurve curve{fmt::format("{:g}\u00b0", direction), {}};
      for (const double period : periods_s)
        curve.responses.push_back(response_of(body, turn / period, direction * degree));
      responses.curves.push_back(std::move(curve));
    }
    all.push_back(std::move(responses));
  }
  if (all.empty()) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("--body: expected the name of a [[body]], got \"{}\"", one_line(arguments.body)),
                fmt::format("the first one is \"{}\"", one_line(bodies.front().body.name)));
  }
  if (!arguments.plot.empty()) {
    const BodyResponses& first = all.front();
    write_png(
        arguments.plot,
        draw_response_plot(fmt::format("{}: motions per metre of wave amplitude", first.body->body.name),
                           periods_s, first.curves),
        arguments.existing);
  }
  const std::string csv = csv_of(all, periods_s, directions_deg);
  if (!file.empty()) write_file_atomically(file, csv, arguments.existing);
  if (arguments.json) {
    print_json(json_of(all, periods_s, directions_deg));
  } else if (file.empty()) {
    fmt::print("{}", csv);
  } else {
    print_summary("{}: {} waves of {} bod{}\n", one_line(file), periods_s.size() * directions_deg.size(),
                  all.size(), all.size() == 1 ? "y" : "ies");
  }
}

}  // namespace

void add_bodies_rao_command(CLI::App& parent, GlobalOptions& options) {
  const auto arguments = std::make_shared<RaoArguments>();
  CLI::App* command = parent.add_subcommand("rao", "compute motions in regular waves by linear theory (RAO)");
  command->add_option("SCENE", arguments->scene, "scene file (TOML) with [[body]]")
      ->transform(find_scene)
      ->required();
  const auto add = [&](const char* names, std::string& target, const char* placeholder, const char* group,
                       const char* help) {
    command->add_option(names, target, help)->type_name(placeholder)->group(group);
  };
  add("--periods", arguments->periods, "A:B:DT", "Waves",
      "periods in s, as a range or with commas between them (default: 4:20:0.25)");
  add("--directions", arguments->directions, "X,...", "Waves",
      "directions in which waves travel, in degrees from the bow toward starboard: 180 is against the bow\n"
      "(default: 180,90,0)");
  add("--body", arguments->body, "NAME", "Waves", "only this body (default: all)");
  add("-o,--output", arguments->output, "FILE", "Output", "CSV file to write (default: -, standard output)");
  add("--plot", arguments->plot, "FILE", "Output",
      "PNG of the amplitudes of the first body against the period");
  add_force_flag(*command, arguments->existing);
  command->add_flag("--json", arguments->json, "print the results as JSON");
  add_trust_flag(*command, arguments->trust);
  add_global_options(*command, options, DeviceUse::none);
  command->footer(R"(
Amplitudes are of the mass centre, in m or degrees per metre of wave amplitude. Surge is forward, sway to
starboard, heave up; roll lowers the starboard side, pitch lifts the bow, yaw turns the bow to port. lead_deg
is the phase in degrees by which a motion is ahead of the wave's crest at the mass centre. There is no
forward speed, viscous drag or mooring.

Examples:
  offing bodies rao scenes/afloat.toml --periods 3:15:0.25 -o rao.csv --plot rao.png
  offing bodies rao ship.toml --periods 6,8,10 --directions 180 --json)");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace offing::cli
