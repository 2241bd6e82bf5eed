#include "present/editing/scene_history.h"

#include <utility>

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

void SceneHistory::take_back() {
  if (before_.empty()) return;
  now_ = std::move(before_.back().scene);
  before_.pop_back();
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
