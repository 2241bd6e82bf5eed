#include "present/window/key_bindings.h"

#include <array>

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace offing::present {

std::span<const KeyBinding> key_bindings() {
  using enum ViewAction;
  static constexpr std::array<KeyBinding, 47> bindings{{
      {GLFW_KEY_H, "H", toggle_help, "this help"},
      {GLFW_KEY_TAB, "Tab", toggle_panels, "panels"},
      {GLFW_KEY_SPACE, "Space", toggle_pause, "play, or pause"},
      {GLFW_KEY_PERIOD, ".", step_forward, "one frame forward, and pause"},
      {GLFW_KEY_COMMA, ",", step_back, "one frame back, and pause"},
      {GLFW_KEY_RIGHT, "Right", step_forward, "one frame forward, and pause"},
      {GLFW_KEY_LEFT, "Left", step_back, "one frame back, and pause"},
      {GLFW_KEY_HOME, "Home", first_frame, "to the first frame of the scene"},
      {GLFW_KEY_END, "End", last_frame, "to the last frame of the scene"},
      {GLFW_KEY_UP, "Up", next_key, "to the next keyframe"},
      {GLFW_KEY_DOWN, "Down", previous_key, "to the previous keyframe"},
      {GLFW_KEY_L, "L", toggle_loop, "repeat the frames of the scene"},
      {GLFW_KEY_LEFT_BRACKET, "[", slower, "halve the speed of time"},
      {GLFW_KEY_RIGHT_BRACKET, "]", faster, "double the speed of time"},
      {GLFW_KEY_BACKSPACE, "Backspace", real_time, "real time"},
      {GLFW_KEY_G, "G", toggle_wireframe, "wireframe of the grid"},
      {GLFW_KEY_V, "V", next_debug_view, "next debug view"},
      {GLFW_KEY_N, "N", next_mesh_show, "next view of meshes: curvatures, directions, projectors ..."},
      {GLFW_KEY_F, "F", toggle_walk, "on foot, or flying again"},
      {GLFW_KEY_M, "M", toggle_map, "map of the ground; click on it to go there"},
      {GLFW_KEY_T, "T", toggle_steps, "steps that rays take to the ground"},
      {GLFW_KEY_P, "P", pick_ray, "nodes that the ray under the mouse passes; none if it points at the sky"},
      {GLFW_KEY_F12, "F12", take_screenshot, "save a picture without panels in the folder where you started"},
      {GLFW_KEY_R, "Ctrl R", record, "record pictures or a video of the scene", GLFW_MOD_CONTROL},
      {GLFW_KEY_F5, "F5", reload, "read kernels and shaders again"},
      {GLFW_KEY_F11, "F11", toggle_fullscreen, "full screen"},
      {GLFW_KEY_K, "K", set_keyframes, "set keyframes of the picked highlight at this time"},
      {GLFW_KEY_O, "O", next_cloud_pick,
       "choose what clicks on clouds pick: balls, clouds, particles, nothing"},
      {GLFW_KEY_B, "B", place_ball, "switch clicks between placing balls of clouds and picking"},
      {GLFW_KEY_C, "C", place_cloud, "switch clicks between placing clouds and picking"},
      {GLFW_KEY_J, "J", duplicate_picked, "copy what is selected, beside it"},
      {GLFW_KEY_D, "Ctrl D", duplicate_picked, "copy what is selected, beside it", GLFW_MOD_CONTROL},
      {GLFW_KEY_DELETE, "Delete", remove_picked, "delete what is selected"},
      {GLFW_KEY_Z, "Ctrl Z", undo, "undo the last edit", GLFW_MOD_CONTROL},
      {GLFW_KEY_Z, "Ctrl Shift Z", redo, "redo it", GLFW_MOD_CONTROL | GLFW_MOD_SHIFT},
      {GLFW_KEY_Y, "Ctrl Y", redo, "redo it", GLFW_MOD_CONTROL},
      {GLFW_KEY_X, "X", look_at_selected, "look at the whole selection"},
      {GLFW_KEY_0, "0", reset_camera, "back to the camera of the scene"},
      {GLFW_KEY_1, "1 ... 9", go_to_bookmark, "go to that bookmark of the scene", 0, 9},
      {GLFW_KEY_1, "Ctrl 1 ... 9", set_bookmark, "set that bookmark, or a new one, to this view",
       GLFW_MOD_CONTROL, 9},
      {GLFW_KEY_F, "Ctrl F", search, "search all values by their names", GLFW_MOD_CONTROL},
      {GLFW_KEY_N, "Ctrl N", new_scene, "begin a new scene", GLFW_MOD_CONTROL},
      {GLFW_KEY_O, "Ctrl O", open_file, "open a scene, or add a mesh, a map, a spectrum or a cloud",
       GLFW_MOD_CONTROL},
      {GLFW_KEY_S, "Ctrl S", save, "save the scene", GLFW_MOD_CONTROL},
      {GLFW_KEY_S, "Ctrl Shift S", save_as, "save the scene under another name",
       GLFW_MOD_CONTROL | GLFW_MOD_SHIFT},
      {GLFW_KEY_ESCAPE, "Esc", deselect, "close lists and dialogs; else deselect"},
      {GLFW_KEY_Q, "Ctrl Q", quit, "quit; asks first if there are unsaved edits or a recording runs",
       GLFW_MOD_CONTROL},
  }};
  return bindings;
}

std::optional<KeyPress> press_of(int key, int modifiers) {
  const int held = modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_SHIFT);
  std::optional<KeyPress> press;
  for (const KeyBinding& binding : key_bindings()) {
    const int number = key - binding.key + 1;
    if (number < 1 || number > binding.keys) continue;
    if (binding.modifiers == held && held != 0) return KeyPress{binding.action, number};
    if (binding.modifiers == 0 && (held & GLFW_MOD_CONTROL) == 0) press = {binding.action, number};
  }
  return press;
}

std::span<const CameraControl> camera_controls() {
  static constexpr std::array<CameraControl, 12> controls{{
      {"W S", "forward, back"},
      {"A D", "left, right"},
      {"E Q", "up, down"},
      {"Shift, Alt", "five times faster (on foot: running), slower"},
      {"Mouse drag", "look around"},
      {"Wheel", "change the speed"},
      {"Click",
       "select a mesh, a light, a cloud or, after O, a part of one; handles move, turn and resize it"},
      {"Click again", "on the selected mesh: pick the highlight there"},
      {"Shift click", "add a part of a cloud to what is picked"},
      {"Shift drag", "pick the parts of clouds in a box"},
      {"Ctrl", "while you drag a handle: snap to steps, turns to 15 degrees"},
      {"Middle click", "go to that point of the ground"},
  }};
  return controls;
}

}  // namespace offing::present
