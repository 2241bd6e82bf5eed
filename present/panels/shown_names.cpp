#include "present/panels/shown_names.h"

#include <string>
#include <variant>

#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/scene_elements.h"

namespace offing::present {

void for_shown_names(const ViewState& state, const SceneList& scenes,
                     const std::function<void(std::string_view)>& tell) {
  tell(state.message.text);
  if (state.renaming) tell(state.renaming->text);
  tell(scenes.folder().string());
  for (const ListedScene& scene : scenes.beside()) tell(scene.name);
  for (const scene::Parameter& row : scene::parameter_table()) {
    const auto* name = std::get_if<scene::ValueAt<std::string>>(&row.storage);
    if (name == nullptr) continue;
    for (const scene::ElementIndex element : scene::elements_of(state.scene, *row.section)) {
      tell(name->in(scene::struct_at(&state.scene, *row.section, element)));
    }
  }
}

}  // namespace offing::present
