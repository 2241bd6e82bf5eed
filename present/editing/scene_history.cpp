#include "present/editing/scene_history.h"

#include <utility>

namespace offing::present {
namespace {

constexpr std::size_t most_steps = 100;

}  // namespace

void SceneHistory::note(scene::Scene scene) {
  before_.push_back(std::exchange(now_, std::move(scene)));
  if (before_.size() > most_steps) before_.pop_front();
  after_.clear();
}

void SceneHistory::take_back() {
  if (before_.empty()) return;
  now_ = std::move(before_.back());
  before_.pop_back();
}

std::optional<scene::Scene> SceneHistory::undo() {
  if (before_.empty()) return {};
  after_.push_back(std::exchange(now_, std::move(before_.back())));
  before_.pop_back();
  return now_;
}

std::optional<scene::Scene> SceneHistory::redo() {
  if (after_.empty()) return {};
  before_.push_back(std::exchange(now_, std::move(after_.back())));
  after_.pop_back();
  return now_;
}

}  // namespace offing::present
