#include "host/command_line/setting_options.h"

#include <algorithm>
#include <utility>

#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <fmt/format.h>

#include "host/base/parameter_check.h"
#include "host/scene/schema/checked_value.h"
#include "host/scene/schema/parameter_table.h"

namespace offing {

namespace {

/// "--step-m" of "step_m".
std::string flag_of(std::string_view key) {
  std::string flag = fmt::format("--{}", key);
  std::ranges::replace(flag, '_', '-');
  return flag;
}

}  // namespace

std::string option_help(const scene::Parameter& row, std::string_view usual) {
  return fmt::format("{}\n{}; default {}", row.help, scene::expected_text(row), usual);
}

const char* option_placeholder(const scene::Parameter& row) {
  if (row.rule == scene::ParameterRule::file_name) return "FILE";
  if (scene::is_text(row)) return "NAME";
  return row.max_count > 1 ? "X,..." : "X";
}

scene::Parameter like_scene(std::string_view key, std::string_view flag) {
  const scene::Parameter& row = *scene::find_parameter(key);
  return {.key = key,
          .flag = flag,
          .unit = row.unit,
          .low = row.low,
          .high = row.high,
          .help = row.help,
          .example = row.example,
          .absent = row.absent,
          .scale = row.scale,
          .rule = row.rule};
}

scene::Parameter like_scene(std::string_view key, std::string_view flag, std::string_view help) {
  scene::Parameter facts = like_scene(key, flag);
  facts.help = help;
  return facts;
}

scene::Parameter over_scene(std::string_view key, std::string_view flag) {
  scene::Parameter facts = like_scene(key, flag);
  facts.absent = "the scene's";
  return facts;
}

scene::Parameter time_facts(std::string_view help, std::string_view absent) {
  return {.key = "time",
          .unit = "s",
          .low = -largest_time_s,
          .high = largest_time_s,
          .help = help,
          .example = "12.5",
          .absent = absent};
}

std::vector<std::string_view> names_in_scene(std::string_view key) {
  return std::get<scene::ChoiceStorage>(scene::find_parameter(key)->storage).names;
}

bool SettingFlags::is_given(std::string_view flag) const {
  return std::ranges::any_of(flags_,
                             [&](const Flag& known) { return known.name == flag && !known.option->empty(); });
}

bool SettingFlags::are_given() const {
  return std::ranges::any_of(flags_, [](const Flag& flag) { return !flag.option->empty(); });
}

CLI::Option* SettingFlags::add(CLI::App& command, const char* group, scene::Parameter row,
                               std::string usual) {
  Flag& flag = flags_.emplace_back();
  flag.row = std::move(row);
  flag.flags = flag.row.flag.empty() ? flag_of(flag.row.key) : std::string(flag.row.flag);
  flag.name = flag.flags.substr(0, flag.flags.find(','));  // others are other names of the same
  const std::string help = option_help(flag.row, flag.row.absent.empty() ? usual : flag.row.absent);
  if (flag.row.example.empty()) {
    flag.example = std::move(usual);
    flag.row.example = flag.example;
  }
  CLI::Option* option = command.add_option(flag.flags, flag.text, help);
  flag.option = option->type_name(option_placeholder(flag.row))->group(group);
  flag.bound.emplace(*option, flag.row);
  return option;
}

void SettingFlags::read_into(void* settings, const std::optional<NarrowedRange>& narrowed) const {
  for (const Flag& flag : flags_) {
    if (flag.option->empty() || (!flag.text.empty() && flag.text == flag.row.absent)) continue;
    scene::Parameter row = flag.row;
    if (narrowed && narrowed->flag == flag.name) {
      row.low = std::max(row.low, narrowed->low);
      row.high = std::min(row.high, narrowed->high);
    }
    scene::store_in(settings, row, scene::read_flag_value(row, flag.text),
                    {.subject = flag.name, .assignment = flag.name + ' '});
  }
}

}  // namespace offing
