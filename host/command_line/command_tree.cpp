#include "host/command_line/command_tree.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <variant>

#include <CLI/Option.hpp>
#include <fmt/format.h>

#include "host/command_line/help_format.h"
#include "host/command_line/option_rows.h"
#include "host/scene/file/version.h"
#include "host/scene/schema/checked_value.h"

namespace offing {
namespace {

// What stands for the value of options without a row.
constexpr std::array<std::string_view, 5> file_names{"FILE", "OUT", "OUT.ply", "SCENE", "NAMES"};
constexpr std::array<std::string_view, 3> folder_names{"DIR", "FOLDER", "STORE"};

bool is_positional(const CLI::Option& option) {
  return !option.nonpositional();
}

std::string placeholder_of(const CLI::Option& option) {
  if (option.get_items_expected_max() == 0) return {};
  return is_positional(option) ? option.get_name(true) : option.get_type_name();
}

/// What a shell can offer for the value.
std::string_view value_kind(const CLI::Option& option, const scene::Parameter* row) {
  const std::string placeholder = placeholder_of(option);
  if (placeholder.empty()) return "none";
  if (row != nullptr) {
    if (row->rule == scene::ParameterRule::file_name) return "file";
    if (std::holds_alternative<scene::ChoiceStorage>(row->storage)) return "choice";
    return scene::is_text(*row) ? "text" : "number";
  }
  if (std::ranges::find(file_names, placeholder) != file_names.end()) return "file";
  if (std::ranges::find(folder_names, placeholder) != folder_names.end()) return "folder";
  return "text";
}

/// The default that the help ends with.
std::string default_in(std::string_view help, const scene::Parameter& row) {
  const std::string before = fmt::format("{}; default ", scene::expected_text(row));
  const std::size_t at = help.rfind(before);
  return std::string(at == std::string_view::npos ? "" : help.substr(at + before.size()));
}

nlohmann::ordered_json option_json(const CLI::Option& option) {
  const scene::Parameter* row = row_of(option);
  nlohmann::ordered_json json;
  json["names"] = nlohmann::json::array();
  for (const std::string& name : option.get_snames()) json["names"].push_back('-' + name);
  for (const std::string& name : option.get_lnames()) json["names"].push_back("--" + name);
  json["placeholder"] = placeholder_of(option);
  json["value"] = value_kind(option, row);
  json["is_required"] = option.get_required();
  json["group"] = group_title(option.get_group());
  json["help"] = row ? std::string(row->help) : option.get_description();
  if (row == nullptr) return json;
  json["expected"] = scene::expected_text(*row);
  json["default"] = default_in(option.get_description(), *row);
  if (const auto* choice = std::get_if<scene::ChoiceStorage>(&row->storage)) {
    json["choices"] = choice->names;
  } else if (!scene::is_text(*row)) {
    json["unit"] = row->unit;
    json["low"] = row->low;
    json["high"] = row->high;
    json["max_count"] = row->max_count;
  }
  return json;
}

void add_command(nlohmann::ordered_json& commands, const CLI::App& command, const std::string& name) {
  nlohmann::ordered_json json{{"name", name},
                              {"other_names", command.get_aliases()},
                              {"help", command.get_description()},
                              {"footer", command.get_footer()},
                              {"positionals", nlohmann::json::array()},
                              {"options", nlohmann::json::array()}};
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_group().empty()) continue;  // hidden
    json[is_positional(*option) ? "positionals" : "options"].push_back(option_json(*option));
  }
  commands.push_back(std::move(json));
  for (const CLI::App* inner : command.get_subcommands({})) {
    add_command(commands, *inner, name + ' ' + inner->get_name());
  }
}

}  // namespace

nlohmann::ordered_json command_tree(const CLI::App& app) {
  nlohmann::ordered_json tree{
      {"program", app.get_name()}, {"version", scene::version()}, {"commands", nlohmann::json::array()}};
  add_command(tree["commands"], app, app.get_name());
  return tree;
}

}  // namespace offing
