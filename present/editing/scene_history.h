#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "host/scene/model/scene.h"

namespace offing::present {

/// Scenes before and after edits, for undo and redo: a hundred steps back.
class SceneHistory {
 public:
  struct Edit {
    scene::Scene before, after;
  };

  explicit SceneHistory(scene::Scene scene) : now_(std::move(scene)) {}

  /// An edit has ended with this scene: what was undone before is gone.
  void note(scene::Scene scene);
  /// The last edit for which this is true of the scenes before and after it was none: nothing is left of it,
  /// not even to redo, while edits after it stay. Returns it, or nothing if there is none.
  std::optional<Edit> take_out(const std::function<bool(const scene::Scene&, const scene::Scene&)>& is_it);
  /// The scene of the last edit that stands.
  const scene::Scene& now() const { return now_; }
  bool can_undo() const { return !before_.empty(); }
  bool can_redo() const { return !after_.empty(); }
  /// What undo() would take back, and redo() would do again (edit_words.h); empty: nothing.
  std::string undo_words() const { return can_undo() ? before_.back().words : ""; }
  std::string redo_words() const { return can_redo() ? after_.back().words : ""; }
  /// The scene before the last edit that still stands; nothing if there is none.
  std::optional<scene::Scene> undo();
  /// That of the last undo() taken back; nothing if there is none.
  std::optional<scene::Scene> redo();

 private:
  struct Step {
    scene::Scene scene;
    std::string words;  // of the edit that left this scene (before_) or led to it (after_)
  };

  scene::Scene now_;
  std::deque<Step> before_;
  std::vector<Step> after_;
};

}  // namespace offing::present
