#pragma once

#include <cstddef>
#include <deque>
#include <vector>

#include "host/bodies/body_pose.h"
#include "host/ocl/buffer.h"
#include "host/ocl/event.h"
#include "kernels/shared/bodies.h"

namespace offing::world {

/// Where floating bodies have been since their start, in host memory: what a device has computed is fetched
/// without waiting for it. Poses between are interpolated.
class BodyPath {
 public:
  BodyPath() = default;
  BodyPath(const BodyPath&) = delete;
  BodyPath& operator=(const BodyPath&) = delete;
  ~BodyPath();

  /// Begins anew with these poses, further ones being `step_s` apart.
  void begin(double time_s, double step_s, const std::vector<bodies::BodyPose>& starts);
  /// Begins to fetch the states of the next step, [bodies].
  void add(const ocl::Buffer<BodyState>& states);

  double begin_s() const { return begin_s_; }
  double end_s() const { return begin_s_ + step_s_ * static_cast<double>(rows_.size() - 1); }
  /// Waits for the device where it has not come so far; the first pose before the start, the last one after
  /// the end.
  bodies::BodyPose at(std::size_t body, double time_s) const;

 private:
  struct Row {
    std::vector<BodyState> states;
    ocl::Event fetched;
  };
  const Row& fetched_row(std::size_t row) const;

  double begin_s_ = 0.0, step_s_ = 1.0;
  std::deque<Row> rows_;  // the device writes into them: they stay where they are
  mutable std::size_t fetched_ = 0;
};

}  // namespace offing::world
