#include "present/editing/scene_editing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "host/scene/schema/scene_elements.h"
#include "present/editing/cloud_overlay.h"
#include "present/editing/objects/pushed_value.h"
#include "present/editing/objects/selection.h"
#include "present/output/camera_path.h"

namespace offing::present {

namespace {

/// Of the still sea at a place; beyond the map it is deep.
double depth_m(LiveSea& sea, const scene::Scene& scene, glm::dvec2 place_m) {
  const std::optional<double> ground_m =
      sea.terrain() != nullptr ? sea.terrain()->surface_m(place_m.x, place_m.y) : std::nullopt;
  return ground_m ? scene.sea_level_m() - *ground_m : std::numeric_limits<double>::infinity();
}

glm::dvec2 place_of(const scene::BodyScene& body) {
  return {body.x_m, body.z_m};
}

/// Whether an edit may have changed where water is.
bool have_other_ground(const scene::Scene& before, const scene::Scene& after) {
  return !after.bodies.empty() &&
         (before.terrain.is_given != after.terrain.is_given || before.sea_level_m() != after.sea_level_m() ||
          scene::differ_in(scene::Affects::heights | scene::Affects::cover, before, after));
}

/// Bodies that start where the ground is above the still sea.
std::vector<std::size_t> bodies_on_land(LiveSea& sea, const scene::Scene& scene) {
  std::vector<std::size_t> bodies;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (depth_m(sea, scene, place_of(scene.bodies[i])) < 0.0) bodies.push_back(i);
  }
  return bodies;
}

/// The nearest place, in steps of a tenth, where a body of this size has water below and around it, and no
/// other body beside it.
std::optional<glm::dvec2> nearest_water_m(LiveSea& sea, const scene::Scene& scene, std::size_t body,
                                          double size_m) {
  constexpr int directions = 48, points = 8;
  constexpr double farthest_m = 20e3, growth = 1.1, least_depth = 0.15;  // of its size
  const auto beside = [](glm::dvec2 place_m, double away_m, int number, int count) {
    const double angle_rad = 2.0 * std::numbers::pi * number / count;
    return place_m + away_m * glm::dvec2(std::cos(angle_rad), std::sin(angle_rad));
  };
  const auto is_free = [&](glm::dvec2 place_m) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      if (i != body && glm::distance(place_of(scene.bodies[i]), place_m) < 2.0 * size_m) return false;
    }
    for (int i = 0; i < points; ++i) {
      for (const double away_m : {0.0, size_m}) {
        if (depth_m(sea, scene, beside(place_m, away_m, i, points)) < least_depth * size_m) return false;
      }
    }
    return true;
  };
  for (double away_m = size_m; away_m < farthest_m; away_m *= growth) {
    for (int i = 0; i < directions; ++i) {
      const glm::dvec2 place_m = beside(place_of(scene.bodies[body]), away_m, i, directions);
      if (is_free(place_m)) return place_m;
    }
  }
  return {};
}

/// Moves a body that an edit has put on land to water, unless mooring lines hold it. Returns the news of it.
std::string move_body_to_water(LiveSea& sea, scene::Scene& scene, std::size_t body) {
  const std::string name = label_of(scene, {ObjectKind::body, body});
  const std::optional<std::size_t> hull = hull_of_body(scene, body);
  const bool is_known = scene.bodies[body].moorings.empty() && hull && *hull < sea.meshes().size();
  const std::optional<glm::dvec2> place_m =
      is_known ? nearest_water_m(sea, scene, body, sea.meshes()[*hull].surface().diagonal_m()) : std::nullopt;
  if (!place_m) return fmt::format("on land now: {}; move it to water, or move the terrain", name);
  const glm::dvec2 way_m = *place_m - place_of(scene.bodies[body]);
  push_value(scene, "body.x_m", {body, 0}, std::round(way_m.x));
  push_value(scene, "body.z_m", {body, 0}, std::round(way_m.y));
  return fmt::format("{} would be on land: moved {:.0f} m to the nearest water", name, glm::length(way_m));
}

}  // namespace

void SceneEditing::begin_anew(SceneHistory history) {
  highlights_ = {};
  clouds_ = {};
  objects_ = {};
  history_ = std::move(history);
  is_last_noted_ = true;
  ++edits_;
}

SceneHistory SceneEditing::history() const {
  SceneHistory history = history_;
  if (!is_last_noted_) history.note(state_.scene);
  return history;
}

bool SceneEditing::turn(const Screen& screen, const std::vector<PointerEvent>& events,
                        const PointerNow& pointer) {
  std::vector<PointerEvent> left = events;  // by the hand of one editor for the next one
  const CloudEditing& clouds = state_.clouds;
  const bool has_tool = clouds.tool != CloudTool::pick;
  // Of clouds as a whole and of all that is no cloud a click picks whichever it meets.
  const bool is_of_parts = clouds.pick == CloudPick::balls || clouds.pick == CloudPick::particles || has_tool;
  work([&] {
    Edit edit = Edit::none;
    if (clouds.pick != CloudPick::none || has_tool || clouds_.holds()) {
      edit = clouds_.turn(state_, sea_.clouds(), screen, left, pointer);
    } else {
      edit = highlights_.turn(state_, sea_.meshes(), screen, left, pointer.clip);
    }
    if (is_of_parts && !objects_.holds()) return edit;
    return std::max(edit, objects_.turn(state_, sea_, screen, left, pointer));
  });
  return clouds_.holds() || highlights_.holds() || objects_.holds();
}

std::optional<Sphere> SceneEditing::selected_place(const Screen& screen) const {
  const std::optional<Sphere> part =
      held_sphere(state_, {state_.scene, sea_.clouds(), state_.clock.time_s()});
  if (part) return part;
  const std::optional<SceneObject> object = selected_object(state_);
  if (object && object->kind == ObjectKind::terrain && sea_.terrain() != nullptr) return middle_of_terrain();
  const std::optional<HeldPlace> place = held_place(state_, sea_, screen);
  if (!place || place->aims) return {};
  return place->sphere;
}

/// The middle of the map, and so much around it that hills are seen.
Sphere SceneEditing::middle_of_terrain() const {
  constexpr double share = 0.25;  // of its shorter side
  const world::TerrainParameters& terrain = sea_.terrain()->parameters();
  const terrain::TerrainExtent extent = terrain.extent();
  const double x_m = terrain.origin_x_m + 0.5 * extent.width_m,
               z_m = terrain.origin_z_m + 0.5 * extent.depth_m;
  const double ground_m = sea_.terrain()->surface_m(x_m, z_m).value_or(0.0);
  return {{x_m, std::max(ground_m, state_.scene.sea_level_m()), z_m},
          share * std::min(extent.width_m, extent.depth_m)};
}

void SceneEditing::work(const std::function<Edit()>& change) {
  try {
    apply(change());
  } catch (const Error& error) {
    state_.message = fault_message(error);
  }
}

void SceneEditing::make(const std::function<std::string(scene::Scene&)>& change) {
  work([&] {
    scene::Scene edited = state_.scene;
    std::string news = change(edited);
    state_.scene = std::move(edited);
    finish(Edit::done);
    if (state_.message.is_fault) return Edit::none;
    if (!state_.message.text.empty()) news += '\n' + state_.message.text;
    state_.message = {.text = std::move(news)};
    return Edit::none;
  });
}

void SceneEditing::finish(Edit edit) {
  if (edit == Edit::none) return;
  clouds_.let_go();
  objects_.let_go();
  apply(edit);
}

void SceneEditing::apply(Edit edit) {
  if (edit == Edit::none) return;
  // Before the world shows what a hand has begun.
  if (is_last_noted_) ashore_ = bodies_on_land(sea_, history_.now());
  if (!edit_sea(edit)) return;
  is_last_noted_ = edit == Edit::done || edit == Edit::taken_back;
  if (edit != Edit::done) return;
  if (have_other_ground(history_.now(), state_.scene)) move_to_water();
  history_.note(state_.scene);
  ++edits_;
}

/// The ground and the bodies that it moves are one edit.
void SceneEditing::move_to_water() {
  std::string news;
  for (const std::size_t body : bodies_on_land(sea_, state_.scene)) {
    if (std::ranges::find(ashore_, body) != ashore_.end()) continue;
    if (!news.empty()) news += '\n';
    news += move_body_to_water(sea_, state_.scene, body);
  }
  if (news.empty() || !edit_sea(Edit::done)) return;
  state_.message.text = state_.message.text.empty() ? news : news + '\n' + state_.message.text;
}

bool SceneEditing::edit_sea(Edit edit) {
  try {
    sea_.begin_edit(state_.scene, edit == Edit::going_on ? Haste::let_finish : Haste::interrupt);
    state_.pick.reset();  // the ground may be another one
    if (edit != Edit::refused) state_.message = {.text = sea_.warning()};
    return true;
  } catch (const Error& error) {
    state_.message = fault_message(error);
    // So that letting go of a slider there is not an edit that is done, which would clear the message.
    if (edit == Edit::going_on) state_.edit.fault = state_.message.text;
    take_scene(sea_.wanted());
    return false;
  }
}

void SceneEditing::take_scene(scene::Scene scene) {
  objects_.let_go();
  clouds_.let_go();  // of what it held there may be nothing any more
  // The camera stays on its path or off it, whichever it is; keyframes of the path may be edited.
  if (!has_camera_path(state_.scene) || !has_camera_path(scene)) take_camera_path(state_.scene, scene);
  state_.timeline.let_go();
  scene.view.camera = state_.scene.view.camera;
  state_.scene = std::move(scene);
  ++edits_;
  forget_lost_picks(state_);
}

void SceneEditing::take_other_edit(scene::Scene scene) {
  const std::optional<SceneObject> selected = selected_object(state_);
  if (selected && count_of(state_.scene, selected->kind) != count_of(scene, selected->kind))
    deselect_objects(state_);
  take_scene(std::move(scene));
}

void SceneEditing::take_made() {
  try {
    sea_.take_made();
  } catch (const UnmadePart& fault) {
    take_out(fault_message(fault), [&](const scene::Scene& before, const scene::Scene& after) {
      return fault.is_asked(before, after);
    });
  } catch (const Error& error) {
    take_out(fault_message(error), [](const auto&, const auto&) { return true; });
  }
}

/// Takes out the last edit for which `is_it` is true of the scenes before and after it; without one the last.
/// What came after it may still have to be made, as it was given up for the one that failed.
void SceneEditing::take_out(const Message& fault, const UnmadePart::Asked& is_it) {
  const bool is_held = !is_last_noted_;
  const bool is_of_held = is_held && is_it(history_.now(), state_.scene);
  auto edit = is_of_held ? std::nullopt : history_.take_out(is_it);
  if (is_held && edit) {
    take_out_below(*edit);
  } else {
    if (!is_held && !edit) history_.take_out([](const auto&, const auto&) { return true; });
    // As where the world refuses a value at once: a slider that is held is not to clear the message.
    if (is_held) state_.edit.fault = fault.text;
    is_last_noted_ = true;
    take_other_edit(history_.now());
    edit_sea(Edit::refused);
  }
  state_.message = fault;
}

/// Takes an edit out of the scene that a hand is changing.
void SceneEditing::take_out_below(const SceneHistory::Edit& edit) {
  const std::optional<SceneObject> selected = selected_object(state_);
  const std::size_t count = selected ? count_of(state_.scene, selected->kind) : 0;
  scene::take_out_edit(edit.before, edit.after, state_.scene);
  if (selected && count != count_of(state_.scene, selected->kind)) deselect_objects(state_);
  forget_lost_picks(state_);
  ++edits_;
  edit_sea(Edit::going_on);
}

void SceneEditing::go_back(std::optional<scene::Scene> scene, const std::string& news) {
  if (!scene) {
    state_.message = {.text = news};
    return;
  }
  take_other_edit(std::move(*scene));
  state_.clouds.particles = {};
  is_last_noted_ = true;
  if (!edit_sea(Edit::done)) return;
  state_.message.text = state_.message.text.empty() ? news : news + '\n' + state_.message.text;
}

void SceneEditing::undo() {
  const std::string words = undo_words();
  go_back(history_.undo(), words.empty() ? "there is nothing to undo" : "undone: " + words);
}

void SceneEditing::redo() {
  const std::string words = redo_words();
  go_back(history_.redo(), words.empty() ? "there is nothing to redo" : "redone: " + words);
}

bool SceneEditing::deselect() {
  if (highlights_.holds() || clouds_.holds() || objects_.holds()) return true;
  CloudEditing& clouds = state_.clouds;
  const bool has_tool = state_.pick || clouds.tool != CloudTool::pick;
  state_.pick.reset();
  clouds.tool = CloudTool::pick;
  return deselect_objects(state_) || has_tool;
}

void SceneEditing::next_cloud_pick() {
  const auto next = (static_cast<std::size_t>(state_.clouds.pick) + 1) % cloud_pick_names.size();
  state_.clouds.pick = static_cast<CloudPick>(next);
  state_.clouds.forget_picks();
  state_.message = {.text = std::string("clicks on clouds pick ") + cloud_pick_names[next]};
}

void SceneEditing::toggle_tool(CloudTool tool) {
  CloudEditing& clouds = state_.clouds;
  clouds.tool = clouds.tool == tool ? CloudTool::pick : tool;
  switch (clouds.tool) {
    case CloudTool::pick:
      state_.message = {.text = "clicks pick again"};
      break;
    case CloudTool::place_ball:
      state_.message = {.text = "clicks place balls, at the height of what is picked"};
      break;
    case CloudTool::place_cloud:
      state_.message = {.text = "clicks place clouds, at the height of what is picked or of their genus"};
      break;
  }
}

void SceneEditing::remove_picked() {
  const std::optional<SceneObject> object = selected_object(state_);
  if (state_.picked) {
    state_.message = fault_message(
        Error(ErrorKind::bad_usage, "a highlight cannot be deleted",
              "click on the mesh beside it to select the mesh, or remove it in the panel Highlights"));
  } else if (object && object->kind != ObjectKind::cloud) {
    remove(*object);
  } else {
    work([&] { return clouds_.remove(state_); });
  }
}

void SceneEditing::duplicate_picked(const Screen& screen) {
  const std::optional<SceneObject> object = selected_object(state_);
  // The editor of clouds says what there is to say where nothing is selected.
  if (!object || object->kind == ObjectKind::cloud)
    return work([&] { return clouds_.duplicate(state_, sea_.clouds()); });
  add([&](scene::Scene& scene) {
    const SceneObject copy = duplicate_object(scene, *object, way_beside(sea_, *object, screen));
    const auto wakes = [&](const SceneObject& of) {
      const std::optional<std::size_t> body =
          of.kind == ObjectKind::body ? std::optional(of.index) : body_of_part(scene, of);
      if (of.kind == ObjectKind::wake || !body) return std::ptrdiff_t{0};
      return std::ranges::count(parts_of_body(scene, *body), ObjectKind::wake, &SceneObject::kind);
    };
    std::string news = fmt::format("added {}", label_of(scene, copy));
    if (wakes(copy) < wakes(*object)) news += no_room_for_wake;
    return AddedObject{copy, news};
  });
}

void SceneEditing::add(const std::function<AddedObject(scene::Scene&)>& change) {
  AddedObject added;
  make([&](scene::Scene& scene) {
    added = change(scene);
    return added.news;
  });
  if (!state_.message.is_fault) select_object(state_, added.object);
}

void SceneEditing::remove(const SceneObject& object) {
  make([&](scene::Scene& scene) {
    std::string news = fmt::format("deleted {}", label_of(scene, object));
    remove_object(scene, object);
    return news;
  });
  if (!state_.message.is_fault) deselect_objects(state_);
}

void SceneEditing::do_to_object(const ObjectEdit& edit, const Screen& screen) {
  if (edit.kind == ObjectEdit::Kind::add)
    return add([&](scene::Scene& scene) { return add_object(scene, edit.added, new_place(sea_, screen)); });
  if (edit.kind == ObjectEdit::Kind::stop_floating) {
    make([&](scene::Scene& scene) {
      stop_floating(scene, edit.object.index);
      return std::string("its meshes stay where it started");
    });
    if (!state_.message.is_fault) deselect_objects(state_);
    return;
  }
  make([&](scene::Scene& scene) {
    rename_object(scene, edit.object, edit.name);
    return std::string();
  });
}

void SceneEditing::draw(const Screen& screen, glm::dvec2 pointer) {
  objects_.draw(state_, sea_, screen);
  if (state_.picked) draw_highlight_handles(*state_.picked, sea_.meshes(), screen);
  draw_cloud_overlay(state_, sea_.clouds(), screen, clouds_.box(pointer));
}

}  // namespace offing::present
