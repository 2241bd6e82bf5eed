#pragma once

#include <optional>
#include <vector>

#include "host/world/world_mesh.h"
#include "present/editing/highlight_handles.h"
#include "present/editing/mesh_picker.h"
#include "present/panels/panels.h"
#include "present/window/window_input.h"

namespace offing::present {

/// Changes highlights by handles that are drawn over the picture. All edits go
/// into the scene of the state; the world shows them once the scene is applied.
class HighlightEditor {
 public:
  /// Takes in what the left button did. A press on a handle of the picked highlight holds it until the button
  /// is let go; these events are taken out. Time stops where a handle of what has keyframes is held. Says how
  /// far an edit has come.
  Edit turn(ViewState& state, const std::vector<world::WorldMesh>& meshes, const Screen& screen,
            std::vector<PointerEvent>& events, glm::dvec2 pointer);
  /// Whether a handle is held: the mouse does not move the camera then.
  bool holds() const { return grab_.has_value(); }

  /// Sets keyframes of the picked highlight's controls at the state's time, as it is shown.
  Edit set_keys(ViewState& state, const std::vector<world::WorldMesh>& meshes) const;

 private:
  /// What a hand found when it took hold.
  struct Grab {
    Handle handle;
    highlights::HighlightControls controls;
    highlights::Projector box;  // in the mesh's axes
    glm::dvec2 from_m;          // in the box's plane
  };

  void press(ViewState& state, const std::vector<world::WorldMesh>& meshes, const Screen& screen,
             glm::dvec2 clip);
  void pull(ViewState& state, const std::vector<world::WorldMesh>& meshes, const Screen& screen,
            glm::dvec2 clip);

  std::optional<Grab> grab_;
};

/// Draws the box and the handles of the picked highlight behind ImGui's windows.
void draw_highlight_handles(const HighlightName& picked, const std::vector<world::WorldMesh>& meshes,
                            const Screen& screen);

}  // namespace offing::present
