#include "tests/present/passes/flight_steps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace offing::test {
namespace {

constexpr int block_px = 8;
constexpr std::size_t worst_frames = 8;
constexpr int halvings = 12;

struct Step {
  double excess = 0.0;
  std::size_t block = 0;
  double begin_s = 0.0;
};

/// Of a block, in the part of two frames' time in which it changes most.
double change_left(const std::function<Blocks(double)>& blocks_at, const Step& step, double length_s) {
  double begin_s = step.begin_s, end_s = begin_s + length_s;
  double begin = blocks_at(begin_s)[step.block], end = blocks_at(end_s)[step.block];
  for (int halving = 0; halving < halvings; ++halving) {
    const double middle_s = 0.5 * (begin_s + end_s), middle = blocks_at(middle_s)[step.block];
    if (std::abs(middle - begin) > std::abs(end - middle)) {
      end_s = middle_s;
      end = middle;
    } else {
      begin_s = middle_s;
      begin = middle;
    }
  }
  return std::abs(end - begin);
}

}  // namespace

Blocks blocks_of(const std::vector<float>& pixels, ImageShape shape, double exposure) {
  const int columns = shape.width / block_px, rows = shape.height / block_px;
  Blocks blocks(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  for (int row = 0; row < rows * block_px; ++row) {
    for (int column = 0; column < columns * block_px; ++column) {
      const std::size_t i = 4 * static_cast<std::size_t>(row * shape.width + column);
      const double luminance = 0.2126 * pixels[i] + 0.7152 * pixels[i + 1] + 0.0722 * pixels[i + 2];
      blocks[static_cast<std::size_t>(row / block_px * columns + column / block_px)] +=
          std::min(exposure * luminance, 1.0) / (block_px * block_px);
    }
  }
  return blocks;
}

FlightSteps flight_steps(const std::function<Blocks(double time_s)>& blocks_at, int frames,
                         double frames_per_second) {
  const double frame_s = 1.0 / frames_per_second;
  std::vector<Step> steps;
  Blocks begin = blocks_at(0.0), middle = blocks_at(frame_s);
  for (int frame = 2; frame < frames; ++frame) {
    const Blocks end = blocks_at(frame * frame_s);
    Step step{.begin_s = (frame - 2) * frame_s};
    for (std::size_t i = 0; i < end.size(); ++i) {
      const double larger = std::max(std::abs(middle[i] - begin[i]), std::abs(end[i] - middle[i]));
      const double excess = larger - 0.5 * std::abs(end[i] - begin[i]);
      if (excess > step.excess) step = {excess, i, step.begin_s};
    }
    steps.push_back(step);
    begin = std::move(middle);
    middle = end;
  }
  std::sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) { return a.excess > b.excess; });
  FlightSteps result{.worst_excess = steps.front().excess};
  steps.resize(std::min(steps.size(), worst_frames));
  for (const Step& step : steps)
    result.worst_left = std::max(result.worst_left, change_left(blocks_at, step, 2.0 * frame_s));
  return result;
}

}  // namespace offing::test
