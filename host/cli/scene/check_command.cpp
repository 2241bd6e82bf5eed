// `offing scene check`: all errors and warnings of scene files.
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/base/error.h"
#include "host/base/log.h"
#include "host/cli/scene/scene_commands.h"
#include "host/command_line/general_flags.h"
#include "host/command_line/print_results.h"
#include "host/scene/file/scene_check.h"
#include "host/scene/file/scene_reader.h"

namespace offing::cli {

namespace {

using nlohmann::ordered_json;
using scene::SceneMessage;
using scene::SceneReport;

struct CheckArguments {
  std::vector<std::string> files;
  Trust trust = Trust::trusted;
  bool json = false;
};

ordered_json json_of(const std::vector<SceneMessage>& messages) {
  ordered_json list = ordered_json::array();
  for (const SceneMessage& each : messages) {
    list.push_back({{"line", each.line},
                    {"column", each.column},
                    {"key", each.key},
                    {"message", each.message},
                    {"hint", each.hint}});
  }
  return list;
}

std::string counted(std::size_t count, const char* what) {
  if (count == 0) return fmt::format("no {}s", what);
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

void print_text(const std::string& file, const SceneReport& report) {
  for (const SceneMessage& each : report.errors) {
    fmt::print("error: {}\n", one_line(each.text));
    if (!each.hint.empty()) fmt::print("hint: {}\n", one_line(each.hint));
  }
  for (const SceneMessage& each : report.warnings) print_summary("warning: {}\n", one_line(each.text));
  // The reader stops there.
  const char* at_least = report.errors.size() >= scene::most_faults ? "at least " : "";
  print_summary("{}: {}{}, {}\n", one_line(file), at_least, counted(report.errors.size(), "error"),
                counted(report.warnings.size(), "warning"));
}

void run(const CheckArguments& arguments) {
  std::size_t wrong = 0;
  ordered_json list = ordered_json::array();
  for (const std::string& file : arguments.files) {
    const SceneReport report = scene::check_scene(file, arguments.trust);
    if (!report.errors.empty()) ++wrong;
    if (arguments.json) {
      list.push_back(
          {{"file", file}, {"errors", json_of(report.errors)}, {"warnings", json_of(report.warnings)}});
    } else {
      print_text(file, report);
    }
  }
  if (arguments.json) print_json(list);
  if (wrong == 0) return;
  throw Error(
      ErrorKind::bad_input,
      fmt::format("expected scenes without errors, found errors in {} of {}", wrong, arguments.files.size()),
      "fix the errors that are listed");
}

}  // namespace

void add_check_command(CLI::App& scene, GlobalOptions& options) {
  const auto arguments = std::make_shared<CheckArguments>();
  CLI::App* command = scene.add_subcommand("check", "list all errors and warnings of scene files");
  command->add_option("FILE", arguments->files, "scene files (TOML)")->required()->type_name("");
  command->add_flag("--json", arguments->json, "print a JSON array with one object per file");
  add_trust_flag(*command, arguments->trust);
  add_global_options(*command, options, DeviceUse::none);
  command->footer(R"(
This command uses no device. Of the files that a scene names, it checks the contents of spectra only.

Exit codes: 0 no file has errors, 2 some file has.

Examples:
  offing scene check harbour.toml
  offing scene check --json scenes/*.toml)");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace offing::cli
