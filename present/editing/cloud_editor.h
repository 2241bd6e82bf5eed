#pragma once

#include <optional>
#include <span>

#include "present/editing/cloud_picker.h"
#include "present/editing/objects/object_handles.h"
#include "present/panels/panels.h"
#include "present/window/window_input.h"

namespace offing::present {

/// Picks balls, clouds and particles with the mouse, places new ones, and changes them by handles that are
/// drawn over the picture. All edits go into the scene of the state; the world shows them once the scene is
/// applied.
class CloudEditor {
 public:
  /// Takes in what the left button did. A press on a handle holds it until the button is let go; a click
  /// elsewhere picks, with Shift beside what is picked; a drag with Shift picks what is in its box. Says how
  /// far an edit has come. Throws Error(bad_usage) for what cannot be done.
  /// Events of a hand on a handle or at a box are taken out.
  Edit turn(ViewState& state, const world::WorldClouds* view, const Screen& screen,
            std::vector<PointerEvent>& events, const PointerNow& pointer);
  /// Whether a handle or a box is held: the mouse does not move the camera then.
  bool holds() const { return grab_ || (pressed_ && is_boxing()); }
  /// The box that is drawn, if one is.
  std::optional<ClipBox> box(glm::dvec2 pointer) const;

  /// Lets go of what is held: another edit has begun, or taken one back.
  void let_go();

  // What keys do. Throw as turn() does.

  Edit remove(ViewState& state);
  Edit duplicate(ViewState& state, const world::WorldClouds* view);

 private:
  /// What a hand found when it took hold.
  struct Grab {
    ObjectHandle handle;
    Sphere sphere;
    glm::dvec2 from{0.0};  // in clip coordinates
    scene::Scene before;
    PickedParticles particles;
    glm::dvec2 at{0.0};  // that the scene has been pulled to
    bool has_pulled = false;
  };
  struct Press {
    glm::dvec2 clip{0.0};
    bool is_beside = false;
  };

  bool is_boxing() const { return pressed_->is_beside; }
  void press(ViewState& state, const ShownClouds& shown, const Screen& screen, const PointerEvent& event);
  Edit release(ViewState& state, const ShownClouds& shown, const Screen& screen, const PointerEvent& event,
               double step_m);
  Edit pull(ViewState& state, const Screen& screen, glm::dvec2 clip, double step_m);

  std::optional<Grab> grab_;
  std::optional<Press> pressed_;
};

/// What has the handles: the last part that is picked, or the particles; nothing where nothing is.
std::optional<Sphere> held_sphere(const ViewState& state, const ShownClouds& shown);

/// Those of what is picked: particles have no rim.
HandleSet cloud_handles(const ViewState& state);

/// Takes out of what is picked what the scene does not have any more.
void forget_lost_picks(ViewState& state);

}  // namespace offing::present
