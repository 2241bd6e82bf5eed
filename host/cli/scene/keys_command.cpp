// `offing scene keys`: every value that a scene may have.
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fnmatch.h>
#include <nlohmann/json.hpp>

#include "host/base/error.h"
#include "host/cli/scene/json_schema.h"
#include "host/cli/scene/scene_commands.h"
#include "host/command_line/print_results.h"
#include "host/command_line/setting_options.h"
#include "host/scene/file/nearest_name.h"
#include "host/scene/schema/key_tables.h"
#include "host/scene/schema/parameter_table.h"

namespace offing::cli {

namespace {

using nlohmann::ordered_json;
using scene::Parameter;
using scene::ParameterMotion;

enum class KeysFormat { text, markdown, json };

struct KeysSettings {
  KeysFormat format = KeysFormat::text;
};

std::vector<scene::Row<KeysSettings>> keys_rows() {
  return {{scene::choice(&KeysSettings::format, {"text", "markdown", "json"}),
           {.key = "format", .help = "how to print the keys"}}};
}

struct KeysArguments {
  std::string pattern;
  SettingOptions<KeysSettings> settings;
};

/// Throws Error(bad_usage) for a pattern that fits no key.
std::vector<Parameter> rows_that_fit(const std::string& pattern) {
  std::vector<Parameter> rows;
  std::vector<std::string_view> names;
  for (const Parameter& row : scene::parameter_table()) {
    names.push_back(row.key);
    names.push_back(scene::name_of(row.key));
    if (fnmatch(fmt::format("*{}*", pattern).c_str(), std::string(row.key).c_str(), 0) == 0)
      rows.push_back(row);
  }
  if (!rows.empty()) return scene::by_section(rows);
  const std::string_view near = scene::nearest_name(pattern, names);
  throw Error(ErrorKind::bad_usage,
              fmt::format("PATTERN: expected a part of a key, got \"{}\"", printable(pattern)),
              near.empty() ? "`offing scene keys` lists all keys" : fmt::format("did you mean {}?", near));
}

void print_text(const std::vector<Parameter>& rows) {
  const scene::Section* section = nullptr;
  for (const Parameter& row : rows) {
    if (row.section != section) {
      fmt::print("{}{}\n", section ? "\n" : "", header_of(row));
      section = row.section;
    }
    fmt::print("{}\n    {}\n    {}", row.key, row.help, expected_text(row));
    if (const std::string usual = default_text(row); !usual.empty()) fmt::print("; default {}", usual);
    if (row.motion != ParameterMotion::constant) fmt::print("; {}", motion_text(row));
    if (!row.flag.empty()) fmt::print("; {}", row.flag);
    fmt::print("\n");
  }
}

ordered_json json_of(const Parameter& row) {
  const auto* choice = std::get_if<scene::ChoiceStorage>(&row.storage);
  ordered_json json = {{"key", row.key}, {"section", header_of(row)}, {"value", expected_text(row)}};
  json["unit"] = row.unit;
  if (row.low < row.high) {
    json["low"] = number_json(row.low);
    json["high"] = number_json(row.high);
  }
  if (choice) json["choices"] = choice->names;
  json["default"] = default_json(row);
  json["default_text"] = default_text(row);
  json["keyframes"] = row.motion != ParameterMotion::constant;
  json["most_elements"] = row.max_count;
  if (!row.flag.empty()) json["flag"] = row.flag;
  if (!row.alias.empty()) json["earlier_key"] = row.alias;
  if (!row.instead_of.empty()) json["instead_of"] = row.instead_of;
  json["help"] = row.help;
  return json;
}

void run(const KeysArguments& arguments) {
  const std::vector<Parameter> rows = rows_that_fit(arguments.pattern);
  switch (arguments.settings.read().format) {
    case KeysFormat::text:
      print_text(rows);
      break;
    case KeysFormat::markdown:
      fmt::print("{}", scene::key_page(rows));
      break;
    case KeysFormat::json: {
      ordered_json list = ordered_json::array();
      for (const Parameter& row : rows) list.push_back(json_of(row));
      print_json(list);
      break;
    }
  }
}

}  // namespace

void add_keys_command(CLI::App& scene, GlobalOptions& options) {
  const auto arguments = std::make_shared<KeysArguments>();
  CLI::App* command =
      scene.add_subcommand("keys", "list scene keys with type, unit, range, default, keyframes and flag");
  command
      ->add_option("PATTERN", arguments->pattern,
                   "part of the names of the keys to list; * stands for any text, ? for any character")
      ->type_name("");
  arguments->settings.add_to(*command, keys_rows());
  add_global_options(*command, options, DeviceUse::none);
  command->footer(R"(
Examples:
  offing scene keys ocean.swell
  offing scene keys 'camera.*_deg'
  offing scene keys --format json)");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace offing::cli
