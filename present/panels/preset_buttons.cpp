#include "present/panels/preset_buttons.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>
#include <imgui.h>

#include "host/scene/schema/presets.h"
#include "present/panels/panel_layout.h"
#include "present/panels/sun_dial.h"

namespace offing::present {

Edit draw_presets(scene::Scene& scene, scene::ParameterGroup group, scene::ElementIndex element) {
  if (group == scene::ParameterGroup::sun) return draw_sun_presets(scene);
  Edit edit = Edit::none;
  const auto is_of_group = [&](const scene::Preset& preset) { return preset.group == group; };
  if (std::ranges::none_of(scene::presets(), is_of_group)) return edit;
  ImGui::TextUnformatted(group == scene::ParameterGroup::sea ? "Beaufort" : "like");
  for (const scene::Preset& preset : scene::presets()) {
    if (!is_of_group(preset)) continue;
    const std::string label(preset.name.substr(preset.name.rfind('-') + 1));
    stay_in_line(label.c_str());
    if (ImGui::SmallButton(fmt::format("{}##{}", label, preset.name).c_str())) {
      scene::apply(preset, scene, element);
      edit = Edit::done;
    }
    explain_item(preset.label);
  }
  return edit;
}

}  // namespace offing::present
