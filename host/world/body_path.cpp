#include "host/world/body_path.h"

#include <algorithm>
#include <cmath>
#include <exception>

namespace offing::world {
namespace {

// Rows that are on their way at a time, so that a long way does not fill the queue.
constexpr std::size_t most_ahead = 64;

}  // namespace

BodyPath::~BodyPath() {
  // The device may still write to rows.
  try {
    if (!rows_.empty()) fetched_row(rows_.size() - 1);
  } catch (const std::exception&) {
    // Whoever asks for poses hears of it.
  }
}

void BodyPath::begin(double time_s, double step_s, const std::vector<bodies::BodyPose>& starts) {
  if (!rows_.empty()) fetched_row(rows_.size() - 1);
  rows_.clear();
  Row& first = rows_.emplace_back();
  for (const bodies::BodyPose& start : starts) first.states.push_back(bodies::device_state(start));
  fetched_ = 1;
  begin_s_ = time_s;
  step_s_ = step_s;
}

void BodyPath::add(const ocl::Buffer<BodyState>& states) {
  if (rows_.size() >= fetched_ + most_ahead) fetched_row(fetched_);
  Row& row = rows_.emplace_back();
  row.states.resize(states.size());
  row.fetched = states.begin_read(row.states.data());
}

const BodyPath::Row& BodyPath::fetched_row(std::size_t row) const {
  // One queue in order: with a row those before it have come.
  if (row >= fetched_) {
    rows_[row].fetched.wait();
    fetched_ = row + 1;
  }
  return rows_[row];
}

bodies::BodyPose BodyPath::at(std::size_t body, double time_s) const {
  const double place = std::clamp((time_s - begin_s_) / step_s_, 0.0, static_cast<double>(rows_.size() - 1));
  const auto before = static_cast<std::size_t>(place);
  const double share = place - static_cast<double>(before);
  const bodies::BodyPose from = bodies::pose_of(fetched_row(before).states[body]);
  if (share == 0.0) return from;
  return bodies::pose_between(from, bodies::pose_of(fetched_row(before + 1).states[body]), share);
}

}  // namespace offing::world
