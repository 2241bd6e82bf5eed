#include "present/window/view_actions.h"

#include <cstddef>

namespace offing::present {
namespace {

/// The one behind `now` in a list of all values of an enumeration that counts from 0, or the first.
template <class Values, class Value>
Value next_of(const Values& values, Value now) {
  return values[(static_cast<std::size_t>(now) + 1) % values.size()];
}

}  // namespace

bool change_view(ViewAction action, ViewState& state) {
  SceneClock& clock = state.clock;
  const double frame_s = 1.0 / state.scene.time.frames_per_second;
  switch (action) {
    case ViewAction::toggle_help:
      state.shows_help = !state.shows_help;
      return true;
    case ViewAction::toggle_panels:
      state.shows_panels = !state.shows_panels;
      return true;
    case ViewAction::search:
      state.shows_panels = state.begins_search = true;
      return true;
    case ViewAction::toggle_pause:
      clock.toggle_pause();
      return true;
    case ViewAction::step_forward:
      clock.step(frame_s);
      return true;
    case ViewAction::step_back:
      clock.step(-frame_s);
      return true;
    case ViewAction::first_frame:
      clock.set_time(state.scene.time.start_s);
      return true;
    case ViewAction::last_frame:
      clock.set_time(last_frame_s(state.scene.time));
      return true;
    case ViewAction::next_key:
      clock.set_time(key_after(state.scene.tracks, clock.time_s()).value_or(clock.time_s()));
      return true;
    case ViewAction::previous_key:
      clock.set_time(key_before(state.scene.tracks, clock.time_s()).value_or(clock.time_s()));
      return true;
    case ViewAction::toggle_loop:
      state.timeline.loops = !state.timeline.loops;
      return true;
    case ViewAction::slower:
      clock.set_scale(0.5 * clock.scale());
      return true;
    case ViewAction::faster:
      clock.set_scale(2.0 * clock.scale());
      return true;
    case ViewAction::real_time:
      clock.set_scale(1.0);
      return true;
    case ViewAction::toggle_wireframe:
      state.fill = state.fill == Fill::solid ? Fill::wireframe : Fill::solid;
      return true;
    case ViewAction::next_debug_view:
      state.debug = next_of(all_water_shows, state.debug);
      return true;
    case ViewAction::next_mesh_show:
      state.meshes = next_of(all_mesh_shows, state.meshes);
      return true;
    case ViewAction::toggle_steps:
      state.terrain = state.terrain == TerrainShow::light ? TerrainShow::steps : TerrainShow::light;
      return true;
    case ViewAction::toggle_map:
      state.shows_map = !state.shows_map;
      return true;
    default:
      return false;
  }
}

bool change_edits(ViewAction action, SceneEditing& editing, const Screen& screen) {
  switch (action) {
    case ViewAction::set_keyframes:
      editing.set_keyframes();
      return true;
    case ViewAction::next_cloud_pick:
      editing.next_cloud_pick();
      return true;
    case ViewAction::place_ball:
      editing.toggle_tool(CloudTool::place_ball);
      return true;
    case ViewAction::place_cloud:
      editing.toggle_tool(CloudTool::place_cloud);
      return true;
    case ViewAction::duplicate_picked:
      editing.duplicate_picked(screen);
      return true;
    case ViewAction::remove_picked:
      editing.remove_picked();
      return true;
    default:
      return false;
  }
}

}  // namespace offing::present
