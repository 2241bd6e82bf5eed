#include "present/panels/shown_names.h"

#include <string>
#include <variant>

#include "host/scene/schema/parameter_table.h"

namespace offing::present {

void for_shown_names(const ViewState& state, const SceneList& scenes,
                     const std::function<void(std::string_view)>& tell) {
  tell(state.message.text);
  tell(state.save_name);
  tell(scenes.folder().string());
  for (const ListedScene& scene : scenes.beside()) tell(scene.name);
  for (const scene::Parameter& row : scene::parameter_table()) {
    if (!std::holds_alternative<scene::ValueAt<std::string>>(row.storage)) continue;
    tell(scene::value_text(state.scene, row));
  }
}

}  // namespace offing::present
