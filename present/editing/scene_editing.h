#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "present/editing/cloud_editor.h"
#include "present/editing/highlight_editor.h"
#include "present/editing/objects/new_objects.h"
#include "present/editing/objects/object_edit.h"
#include "present/editing/objects/object_editor.h"
#include "present/editing/scene_history.h"
#include "present/panels/panels.h"
#include "present/passes/live_sea.h"
#include "present/window/window_input.h"

namespace offing::present {

/// Edits of a window's scene: what handles do to it, what any edit means for the world, undo, and clouds that
/// are made in the background. Faults go into the state's message; the scene is then the last good one.
class SceneEditing {
 public:
  SceneEditing(LiveSea& sea, ViewState& state) : sea_(sea), state_(state), history_(state.scene) {}

  /// The state's scene is another file's, with edits of its own.
  void begin_anew(SceneHistory history);
  /// Of the state's scene, which is its last edit.
  SceneHistory history() const;
  /// Takes in what the mouse did beside panels. True while it holds something: then it does not move the
  /// camera.
  bool turn(const Screen& screen, const std::vector<PointerEvent>& events, const PointerNow& pointer);
  /// Shows clouds and lakes that have been made since the last frame.
  void take_made();
  /// An edit that `change` makes of a scene and says something of, which the message then shows, or its
  /// fault.
  void make(const std::function<std::string(scene::Scene&)>& change);
  /// What an edit of the state's scene means for the world and for undo. Handles are let go of.
  void finish(Edit edit);
  /// The scene of the last edit that stands.
  const scene::Scene& last_edit() const { return history_.now(); }
  /// Counts edits that are done, taken back or redone.
  std::uint64_t edits() const { return edits_; }
  bool can_undo() const { return history_.can_undo(); }
  bool can_redo() const { return history_.can_redo(); }
  /// What undo() would take back, and redo() would do again; empty: nothing.
  std::string undo_words() const { return history_.undo_words(); }
  std::string redo_words() const { return history_.redo_words(); }
  void undo();
  void redo();
  void set_keyframes() { finish(highlights_.set_keys(state_, sea_.meshes())); }
  /// Deselects everything and puts the tool away; false if nothing was selected and there was no tool. What
  /// the mouse holds stays selected.
  bool deselect();
  void next_cloud_pick();
  /// Takes the tool, or lays it down.
  void toggle_tool(CloudTool tool);
  /// Where the selected object or part of a cloud is, and how large.
  std::optional<Sphere> selected_place(const Screen& screen) const;
  /// Deletes and copies what is selected: of clouds what is picked, else the object. Copies go beside it, as
  /// the screen shows it.
  void remove_picked();
  void duplicate_picked(const Screen& screen);
  /// Adds or renames an object, or removes a body from its meshes. A new object is selected.
  void do_to_object(const ObjectEdit& edit, const Screen& screen);

  /// Draws handles behind the panels.
  void draw(const Screen& screen, glm::dvec2 pointer);

 private:
  void apply(Edit edit);
  bool edit_sea(Edit edit);
  void move_to_water();
  /// Shows the scene of the edit before or after, if there is one, and `news` as the message.
  void go_back(std::optional<scene::Scene> scene, const std::string& news);
  /// The scene is another one from here on; its camera stays the user's.
  void take_scene(scene::Scene scene);
  /// That of an edit before or after. Nothing stays selected whose list gets longer or shorter: its number
  /// may be another one's.
  void take_other_edit(scene::Scene scene);
  void take_out(const Message& fault, const UnmadePart::Asked& is_it);
  void take_out_below(const SceneHistory::Edit& edit);
  Sphere middle_of_terrain() const;
  void work(const std::function<Edit()>& change);
  /// Adds what `change` adds to a scene, and selects it.
  void add(const std::function<AddedObject(scene::Scene&)>& change);
  /// Nothing is selected then: the next of its list would have its number.
  void remove(const SceneObject& object);

  LiveSea& sea_;
  ViewState& state_;
  HighlightEditor highlights_;
  CloudEditor clouds_;
  ObjectEditor objects_;
  SceneHistory history_;
  bool is_last_noted_ = true;             // of what was begun last
  std::vector<std::size_t> ashore_ = {};  // bodies that were on land before it
  std::uint64_t edits_ = 0;
};

}  // namespace offing::present
