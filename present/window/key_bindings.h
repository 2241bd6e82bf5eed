#pragma once

#include <optional>
#include <span>

namespace offing::present {

/// What a key does once, when it goes down. Keys that move the camera while they are held are in WindowInput.
enum class ViewAction {
  toggle_help,
  toggle_panels,
  toggle_pause,
  step_forward,
  step_back,
  first_frame,
  last_frame,
  next_key,
  previous_key,
  toggle_loop,
  slower,
  faster,
  real_time,
  toggle_wireframe,
  next_debug_view,
  next_mesh_show,
  toggle_walk,
  toggle_steps,
  toggle_map,
  pick_ray,
  take_screenshot,
  record,
  reload,
  toggle_fullscreen,
  reset_camera,
  look_at_selected,
  set_keyframes,
  next_cloud_pick,
  place_ball,
  place_cloud,
  duplicate_picked,
  remove_picked,
  undo,
  redo,
  go_to_bookmark,
  set_bookmark,
  search,
  new_scene,
  open_file,
  save,
  save_as,
  deselect,
  quit,
};

struct KeyBinding {
  int key;           ///< of GLFW
  const char* name;  ///< as printed on the key
  ViewAction action;
  const char* help;
  int modifiers =
      0;         ///< of GLFW, that are held with it; 0: none, or Shift where no other binding asks for it
  int keys = 1;  ///< so many keys from this one on: numbers of the action, from 1
};

/// What is asked for by a key that has gone down.
struct KeyPress {
  ViewAction action;
  int number = 1;  ///< of KeyBinding::keys
};

/// Nothing for a key that does nothing.
std::optional<KeyPress> press_of(int key, int modifiers);

/// Every key that does something once: the one place that says which, for the window and its help.
std::span<const KeyBinding> key_bindings();

/// Keys and mouse that move the camera, for the help.
struct CameraControl {
  const char* name;
  const char* help;
};
std::span<const CameraControl> camera_controls();

}  // namespace offing::present
