#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "present/editing/mesh_picker.h"
#include "present/editing/objects/handle_overlay.h"
#include "present/editing/objects/object_edits.h"
#include "present/editing/objects/scene_objects.h"
#include "present/panels/panels.h"
#include "present/passes/live_sea.h"
#include "present/window/window_input.h"

namespace offing::present {

/// Selects meshes, lights, bookmarks and clouds with the mouse, and moves, turns and resizes meshes, bodies,
/// lights, layers of clouds, wake windows and bookmarks by handles that are drawn over the picture. All edits
/// go into the scene of the state; the world shows them once the scene is applied.
class ObjectEditor {
 public:
  /// Takes in what the left button did. A press on a handle holds it until the button is let go; a click
  /// selects what it meets first, or nothing, and on a mesh that is selected already picks the highlight
  /// there. Says how far an edit has come: where the world could not follow a hand, it has come nowhere until
  /// the hand lets go.
  Edit turn(ViewState& state, LiveSea& sea, const Screen& screen, const std::vector<PointerEvent>& events,
            const PointerNow& pointer);
  /// Whether a handle is held: the mouse does not move the camera then.
  bool holds() const { return grab_.has_value(); }
  /// Lets go of what is held: another edit has begun, or taken one back.
  void let_go();

  /// Draws lights, and the outline and the handles of what is selected, behind ImGui's windows.
  void draw(const ViewState& state, const LiveSea& sea, const Screen& screen);

 private:
  /// What a hand found when it took hold.
  struct Grab {
    ObjectHandle handle;
    Sphere sphere;
    std::variant<HeldMesh, HeldBody, SceneObject> held;  // or what has a place alone
    bool aims = false;                                   // a light of a direction
    highlights::RigidMotion world;                       // of a mesh
    glm::dvec2 from{0.0};                                // in clip coordinates
    scene::Scene before;
    glm::dvec2 at{0.0};  // that the scene has been pulled to
    ObjectPull pull = {};
    bool is_shown = false;  // the world has followed
  };
  struct Box {
    std::uint64_t revision;  // of the mesh that it is of
    glm::dvec3 low_m, high_m;
  };

  static void take_back(const Grab& grab, scene::Scene& scene);
  void press(ViewState& state, LiveSea& sea, const Screen& screen, glm::dvec2 clip);
  Edit release(ViewState& state, LiveSea& sea, const Screen& screen, const PointerEvent& event, bool snaps);
  Edit pull(ViewState& state, LiveSea& sea, const Screen& screen, glm::dvec2 clip, bool snaps);
  void select_at(ViewState& state, LiveSea& sea, const Screen& screen, glm::dvec2 clip);
  const Box& box_of(const world::WorldMesh& mesh);
  void draw_box(const OverlayPainter& painter, const LiveSea& sea, const Screen& screen, std::size_t mesh);

  MeshPicker picker_;
  std::optional<Grab> grab_;
  std::optional<glm::dvec2> pressed_;  // where, in clip coordinates, beside handles
  std::optional<Box> box_;             // of the mesh that was selected last
};

/// What has handles, where they are and which: the selected object, if it can be moved. Nothing where a
/// highlight of the mesh is picked, which has its own.
struct HeldPlace {
  Sphere sphere;
  HandleSet handles;
  bool aims = false;  ///< its only handle, `free`, is at the end of an arrow toward a light
};
std::optional<HeldPlace> held_place(const ViewState& state, const LiveSea& sea, const Screen& screen);

}  // namespace offing::present
