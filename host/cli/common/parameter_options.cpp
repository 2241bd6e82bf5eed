#include "host/cli/common/parameter_options.h"

#include <algorithm>

#include <CLI/Option.hpp>
#include <fmt/format.h>

#include "host/base/error.h"
#include "host/command_line/general_flags.h"
#include "host/command_line/installed_scenes.h"
#include "host/command_line/setting_options.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/file/scene_files.h"
#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/presets.h"
#include "host/scene/schema/scene_elements.h"

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
    case ParameterGroup::material:
      return "Materials";
    case ParameterGroup::canopy:
      return "Woods";
    case ParameterGroup::walk:
      return "Walk";
    case ParameterGroup::lake:
      return "Lakes";
    case ParameterGroup::light:
      return "Lights";
    case ParameterGroup::mesh:
      return "Meshes";
    case ParameterGroup::highlight:
      return "Highlights";
    case ParameterGroup::body:
    case ParameterGroup::mooring:
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
  return parameter.key.ends_with("direction_deg");
}

/// Whether of these two rows one counts in the other's stead.
bool exclude_each_other(const Parameter& a, const Parameter& b) {
  return a.instead_of == b.key || b.instead_of == a.key;
}

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  return text.substr(0, text.find_last_not_of(' ') + 1);
}

/// The row of a key of [[ocean.swell]].
const Parameter& swell_row(std::string_view name) {
  constexpr std::string_view section = "ocean.swell";
  if (const Parameter* row = scene::find_parameter(fmt::format("{}.{}", section, name))) return *row;
  std::string known;
  for (const Parameter& row : scene::parameter_table()) {
    if (scene::section_of(row.key) == section)
      known += fmt::format("{}{}", known.empty() ? "" : ", ", scene::name_of(row.key));
  }
  throw Error(ErrorKind::bad_usage,
              fmt::format("--swell: expected a key of [[{}]], got \"{}\"", section, name),
              "known keys: " + known);
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
  if (std::find(groups.begin(), groups.end(), ParameterGroup::sea) != groups.end()) add_sea_options(command);
}

void ParameterOptions::add_sea_options(CLI::App& command) {
  command
      .add_option("--preset", preset_,
                  "set wind and wave height of a Beaufort force, beaufort-1 to beaufort-12; overrides the "
                  "scene, but not other flags")
      ->type_name("NAME")
      ->group(title(ParameterGroup::sea));
  command
      .add_option("--swell", swells_,
                  "add a swell, by keys of [[ocean.swell]]: irregular with hs_m, else one wave; repeat it "
                  "for several: --swell hs_m=1.5,tp_s=14,direction_deg=60,spread_deg=10")
      ->type_name("KEY=VALUE,...")
      ->group(title(ParameterGroup::sea))
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

scene::Scene ParameterOptions::read() const {
  scene::Scene scene;
  if (!scene_file_.empty()) scene = scene::load_scene(scene_file_, trust_);
  scene.trust = trust_;
  if (!preset_.empty()) scene::apply(scene::find_preset(preset_, "--preset"), scene);
  for (const Flag& flag : flags_) {
    if (!flag.values.empty()) take_out_others(scene, flag);
  }
  for (const Flag& flag : flags_) read_flag(scene, flag);
  for (const std::string& swell : swells_) read_swell(scene, swell);
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
  for (const std::string& text : flag.values) store_flag(scene, parameter, text, place);
}

void ParameterOptions::store_flag(scene::Scene& scene, const Parameter& parameter, const std::string& text,
                                  const scene::Place& place) const {
  scene::WrittenValue written = scene::read_flag_value(parameter, text);
  scene::store(scene, parameter, written, place);
  if (is_direction(parameter) && directions_ == DirectionStyle::from_bearing) {
    // Checked as it was written; now as the scene has it.
    written.value = travel_deg(number_in(written));
    scene::store(scene, parameter, written, place);
  }
}

void ParameterOptions::take_out_others(scene::Scene& scene, const Flag& flag) const {
  for (const Flag& other : flags_) {
    const Parameter& row = *other.parameter;
    if (&other == &flag || !exclude_each_other(*flag.parameter, row)) continue;
    if (!other.values.empty()) {
      throw Error(ErrorKind::bad_usage,
                  fmt::format("{}: expected either {} or {}, found both", flag.parameter->flag,
                              flag.parameter->flag, row.flag),
                  "remove one of them");
    }
    scene::clear_value(scene, row);
  }
}

void ParameterOptions::read_swell(scene::Scene& scene, const std::string& text) const {
  scene::append_element(scene, swell_row("hs_m"), {.subject = "--swell"});
  std::vector<const Parameter*> given;
  for (std::string_view rest = text; !rest.empty();) {
    const std::string_view part = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(part.size() + 1, rest.size()));
    const std::size_t equals = part.find('=');
    if (equals == std::string_view::npos) {
      throw Error(ErrorKind::bad_usage, fmt::format("--swell: expected KEY=VALUE, got \"{}\"", part),
                  "write --swell hs_m=1.5,tp_s=14,direction_deg=60");
    }
    const Parameter& row = swell_row(trimmed(part.substr(0, equals)));
    for (const Parameter* other : given) {
      if (other != &row && !exclude_each_other(*other, row)) continue;
      const std::string_view name = scene::name_of(row.key), other_name = scene::name_of(other->key);
      throw Error(ErrorKind::bad_usage,
                  other == &row
                      ? fmt::format("--swell: expected {} once, found it twice", name)
                      : fmt::format("--swell: expected either {} or {}, found both", other_name, name),
                  "remove one of them");
    }
    given.push_back(&row);
    store_flag(scene, row, std::string(trimmed(part.substr(equals + 1))),
               {.subject = fmt::format("--swell: {}", scene::name_of(row.key)),
                .assignment = fmt::format("{}=", scene::name_of(row.key))});
  }
}

}  // namespace offing::cli
