#include "present/editing/scene_history.h"

#include <cstddef>
#include <utility>

#include "host/scene/schema/scene_elements.h"
#include "present/editing/edit_words.h"

namespace offing::present {
namespace {

constexpr std::size_t most_steps = 100;

}  // namespace

void SceneHistory::note(scene::Scene scene) {
  std::string words = edit_words(now_, scene);
  before_.push_back({std::exchange(now_, std::move(scene)), std::move(words)});
  if (before_.size() > most_steps) before_.pop_front();
  after_.clear();
}

std::optional<SceneHistory::Edit> SceneHistory::take_out(
    const std::function<bool(const scene::Scene&, const scene::Scene&)>& is_it) {
  const auto after = [this](std::size_t step) -> scene::Scene& {
    return step + 1 < before_.size() ? before_[step + 1].scene : now_;
  };
  for (std::size_t step = before_.size(); step-- > 0;) {
    if (!is_it(before_[step].scene, after(step))) continue;
    Edit edit{before_[step].scene, after(step)};
    after(step) = edit.before;
    for (std::size_t later = step + 1; later < before_.size(); ++later)
      scene::take_out_edit(edit.before, edit.after, after(later));
    for (Step& undone : after_) scene::take_out_edit(edit.before, edit.after, undone.scene);
    before_.erase(before_.begin() + static_cast<std::ptrdiff_t>(step));
    return edit;
  }
  return {};
}

std::optional<scene::Scene> SceneHistory::undo() {
  if (before_.empty()) return {};
  Step& step = before_.back();
  after_.push_back({std::exchange(now_, std::move(step.scene)), std::move(step.words)});
  before_.pop_back();
  return now_;
}

std::optional<scene::Scene> SceneHistory::redo() {
  if (after_.empty()) return {};
  Step& step = after_.back();
  before_.push_back({std::exchange(now_, std::move(step.scene)), std::move(step.words)});
  after_.pop_back();
  return now_;
}

}  // namespace offing::present
