#include "host/cli/common/parameter_options.h"

#include <algorithm>

#include <CLI/Option.hpp>

#include "host/command_line/general_flags.h"
#include "host/command_line/installed_scenes.h"
#include "host/command_line/setting_options.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/file/scene_files.h"
#include "host/scene/schema/parameter_table.h"

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
    case ParameterGroup::swell:
      return "Swell";
    case ParameterGroup::raindrop:
      return "Raindrop";
    case ParameterGroup::wake:
    case ParameterGroup::wake_hull:
      return "Wakes";
    case ParameterGroup::foam:
      return "Foam";
    case ParameterGroup::camera:
      return "Camera";
    case ParameterGroup::bookmark:
      return "Bookmarks";
    case ParameterGroup::sun:
      return "Sun";
    case ParameterGroup::sky:
      return "Sky";
    case ParameterGroup::render:
      return "Picture";
    case ParameterGroup::terrain:
      return "Ground";
    case ParameterGroup::height_map:
      return "Height map";
    case ParameterGroup::walk:
      return "Walk";
    case ParameterGroup::light:
      return "Lights";
    case ParameterGroup::mesh:
      return "Meshes";
    case ParameterGroup::highlight:
      return "Highlights";
    case ParameterGroup::body:
      return "Floating bodies";
    case ParameterGroup::clouds:
    case ParameterGroup::cloud_layer:
    case ParameterGroup::cloud:
    case ParameterGroup::cloud_ball:
    case ParameterGroup::cloud_level:
    case ParameterGroup::particle_edit:
      return "Clouds";
  }
  return "";
}

bool is_list(const Parameter& parameter) {
  return parameter.max_count > 1;
}

bool is_direction(const Parameter& parameter) {
  return parameter.unit == "deg";
}

double number_in(const scene::WrittenValue& written) {
  const auto* whole = std::get_if<std::int64_t>(&written.value);
  return whole ? static_cast<double>(*whole) : std::get<double>(written.value);
}

}  // namespace

void ParameterOptions::add_to(CLI::App& command, std::initializer_list<ParameterGroup> groups) {
  command.add_option("SCENE", scene_file_, "scene file (.toml); flags override its values")
      ->transform(find_scene)
      ->type_name("");
  add_trust_flag(command, trust_);
  command.add_flag_callback(
      "--compass", [this] { directions_ = DirectionStyle::from_bearing; },
      "use compass directions: where wind and waves come from, clockwise from north\n(default, and always in "
      "scene files: where they go, from +x (east) toward +z (south))");
  for (const Parameter& parameter : scene::parameter_table()) {
    if (parameter.flag.empty() || std::find(groups.begin(), groups.end(), parameter.group) == groups.end()) {
      continue;
    }
    Flag& flag = flags_.emplace_back();
    flag.parameter = &parameter;
    CLI::Option* option = command.add_option(std::string(parameter.flag), flag.values,
                                             option_help(parameter, scene::value_text({}, parameter)));
    option->type_name(option_placeholder(parameter))->group(title(parameter.group));
    flag.bound.emplace(*option, parameter);
    if (is_list(parameter)) {
      option->delimiter(',')->allow_extra_args(false);
    } else {
      option->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    }
  }
}

scene::Scene ParameterOptions::read() const {
  scene::Scene scene;
  if (!scene_file_.empty()) scene = scene::load_scene(scene_file_, trust_);
  scene.trust = trust_;
  for (const Flag& flag : flags_) {
    read_flag(scene, flag);
  }
  return scene;
}

GivenInputs ParameterOptions::inputs(const scene::Scene& scene) const {
  GivenInputs inputs{scene::files_of(scene), trust_};
  inputs.names.push_back(scene_file_);
  return inputs;
}

void ParameterOptions::read_flag(scene::Scene& scene, const Flag& flag) const {
  const Parameter& parameter = *flag.parameter;
  if (!flag.values.empty()) {
    scene::clear_list(scene, parameter);
  }
  const scene::Place place{.subject = std::string(parameter.flag),
                           .assignment = std::string(parameter.flag) + ' '};
  for (const std::string& text : flag.values) {
    scene::WrittenValue written = scene::read_flag_value(parameter, text);
    scene::store(scene, parameter, written, place);
    if (is_direction(parameter) && directions_ == DirectionStyle::from_bearing) {
      // Checked as it was written; now as the scene has it.
      written.value = travel_deg(number_in(written));
      scene::store(scene, parameter, written, place);
    }
  }
}

}  // namespace offing::cli
