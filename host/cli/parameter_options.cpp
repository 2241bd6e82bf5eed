#include "host/cli/parameter_options.h"

#include <algorithm>

#include <CLI/Option.hpp>
#include <fmt/format.h>

#include "host/scene/parameter_table.h"
#include "host/scene/scene_file.h"

namespace offing::cli {

namespace {

using scene::Parameter;
using scene::ParameterGroup;

const char* title(ParameterGroup group) {
  switch (group) {
    case ParameterGroup::world:
      return "World";
    case ParameterGroup::time:
      return "Time";
    case ParameterGroup::wind:
      return "Wind";
    case ParameterGroup::sea:
      return "Sea";
    case ParameterGroup::grid:
      return "Grid";
    case ParameterGroup::foam:
      return "Foam";
  }
  return "";
}

bool is_list(const Parameter& parameter) {
  return parameter.max_count > 1;
}

/// "wind speed ...; a number in m/s within [0.1, 60] (default 10)".
std::string description(const Parameter& parameter) {
  return fmt::format("{}: {} (default {})", parameter.help, scene::expected_text(parameter),
                     scene::value_text({}, parameter));
}

std::string placeholder(const Parameter& parameter) {
  const std::size_t dot = parameter.key.rfind('.');
  std::string name(parameter.key.substr(dot + 1));
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
  return name;
}

}  // namespace

void ParameterOptions::add_to(CLI::App& command, std::initializer_list<ParameterGroup> groups) {
  command.add_option("SCENE", scene_file_, "scene file (.toml); flags override what it says")->type_name("");
  for (const Parameter& parameter : scene::parameter_table()) {
    if (parameter.flag.empty() || std::find(groups.begin(), groups.end(), parameter.group) == groups.end()) {
      continue;
    }
    Flag& flag = flags_.emplace_back(Flag{&parameter, {}});
    CLI::Option* option =
        command.add_option(std::string(parameter.flag), flag.values, description(parameter));
    option->type_name(placeholder(parameter))->group(title(parameter.group));
    if (is_list(parameter)) {
      option->delimiter(',')->allow_extra_args(false);
    } else {
      option->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    }
  }
}

scene::OceanScene ParameterOptions::read() const {
  scene::OceanScene scene = scene_file_.empty() ? scene::OceanScene{} : scene::load_scene(scene_file_);
  for (const Flag& flag : flags_) {
    const Parameter& parameter = *flag.parameter;
    if (!flag.values.empty()) {
      scene::clear_list(scene, parameter);
    }
    const scene::Place place{.subject = std::string(parameter.flag),
                             .assignment = std::string(parameter.flag) + ' '};
    for (const std::string& text : flag.values) {
      scene::store(scene, parameter, scene::read_flag_value(parameter, text), place);
    }
  }
  return scene;
}

}  // namespace offing::cli
