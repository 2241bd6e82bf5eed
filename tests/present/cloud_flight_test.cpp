// A flight by, under, over and through clouds: nothing may pop.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "host/base/keyframes.h"
#include "host/scene/scene_file.h"
#include "host/scene/world_scene.h"
#include "tests/present/cloud_stage.h"

namespace offing::present {
namespace {

constexpr int width = 160, height = 90, block_px = 8;
constexpr int frames = 600;
constexpr double frames_per_second = 20.0;

/// Mean light of blocks of 8 x 8 pixels, in that of white, row-major.
using Blocks = std::vector<double>;

class CloudFlightTest : public test::CloudStage {
 protected:
  void SetUp() override {
    CloudStage::SetUp();
    if (IsSkipped()) return;
    const scene::OceanScene scene =
        scene::parse_scene("version = 1\n[wind]\nspeed_mps = 7\n[ocean]\nsize = 32\n", "a.toml", "");
    open(scene::prepare_world(scene, scene::Warnings::left_out));
    add_heap({0.0, 700.0, -1500.0}, 900.0, 500);
    add_heap({-500.0, 650.0, -2600.0}, 700.0, 500);
    add_heap({500.0, 700.0, -3400.0}, 1000.0, 500, 1);
    add_heap({-900.0, 900.0, -5200.0}, 1400.0, 500);
  }

  /// Toward the first heap, through it, over the second, under the third and into the last one.
  static Camera camera_at(double time_s) {
    const auto along = [&](std::vector<double> values) {
      KeyframeTrack track;
      for (std::size_t i = 0; i < values.size(); ++i)
        track.keys.push_back({6.0 * static_cast<double>(i), values[i]});
      return value_at(track, time_s);
    };
    return {.eye_m = {along({0, 0, -300, 200, 0, -800}), along({250, 800, 1150, 500, 800, 1200}),
                      along({0, -1300, -2400, -3500, -4200, -5300})},
            .yaw_rad = along({0.0, -0.1, 0.2, -0.3, -0.1, 0.0}),
            .pitch_rad = along({0.3, 0.0, -0.3, 0.3, 0.1, 0.0}),
            .roll_rad = along({0.0, 0.1, -0.2, 0.2, 0.0, 0.0}),
            .vertical_field_of_view_rad = 0.9,
            .width_px = width,
            .height_px = height};
  }

  Blocks blocks_at(double time_s) {
    const std::vector<float> pixels = light(camera_at(time_s));
    constexpr int columns = width / block_px, rows = height / block_px;
    Blocks blocks(static_cast<std::size_t>(columns) * rows);
    for (int row = 0; row < rows * block_px; ++row) {
      for (int column = 0; column < width; ++column) {
        const std::size_t i = 4 * static_cast<std::size_t>(row * width + column);
        const double luminance = 0.2126 * pixels[i] + 0.7152 * pixels[i + 1] + 0.0722 * pixels[i + 2];
        // Holes and dark seams would be far below any light here, numbers that are none fail too.
        EXPECT_GT(luminance, 0.1) << time_s << " s: " << column << ", " << row;
        blocks[static_cast<std::size_t>(row / block_px * columns + column / block_px)] +=
            exposure * luminance / (block_px * block_px);
      }
    }
    return blocks;
  }

  /// Of a block, in the 2^-11th part of a frame's time from begin_s on in which it changes most.
  double change_left(double begin_s, std::size_t block) {
    double end_s = begin_s + 1.0 / frames_per_second;
    double begin = blocks_at(begin_s)[block], end = blocks_at(end_s)[block];
    for (int halving = 0; halving < 11; ++halving) {
      const double middle_s = 0.5 * (begin_s + end_s), middle = blocks_at(middle_s)[block];
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
};

// Fails if clouds pop, flicker or leave seams as one flies among them: 600 frames. What the camera's motion
// explains goes to nothing with the time between two pictures, a pop does not: half of the way between two
// frames half of a change is explained by motion, and all of a pop. Of the 12 frames in which the blocks of 8
// x 8 pixels change most beyond that, the change is halved 11 times in time, each time to the half that
// changes more. Bound: what is left of motion alone, 2^-11 of a change of white, 0.0005, twice that where it
// is quicker than in the mean. Measured 0.0007, gate 0.002: half a step of 8 bits, in one block, fails.
TEST_F(CloudFlightTest, NothingPops) {
  struct Step {
    double excess;
    std::size_t block;
    double begin_s;
  };
  std::vector<Step> steps;
  Blocks begin = blocks_at(0.0);
  for (int frame = 0; frame < frames; ++frame) {
    const double begin_s = frame / frames_per_second;
    const Blocks middle = blocks_at(begin_s + 0.5 / frames_per_second);
    const Blocks end = blocks_at(begin_s + 1.0 / frames_per_second);
    Step step{0.0, 0, begin_s};
    for (std::size_t i = 0; i < end.size(); ++i) {
      const double larger = std::max(std::abs(middle[i] - begin[i]), std::abs(end[i] - middle[i]));
      const double excess = larger - 0.5 * std::abs(end[i] - begin[i]);
      if (excess > step.excess) step = {excess, i, begin_s};
    }
    steps.push_back(step);
    begin = end;
  }
  std::sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) { return a.excess > b.excess; });
  double worst_left = 0.0;
  for (std::size_t i = 0; i < 12; ++i)
    worst_left = std::max(worst_left, change_left(steps[i].begin_s, steps[i].block));
  RecordProperty("worst_excess_1e4", static_cast<int>(1e4 * steps[0].excess));
  RecordProperty("worst_left_1e5", static_cast<int>(1e5 * worst_left));
  EXPECT_LT(worst_left, 0.002);
}

}  // namespace
}  // namespace offing::present
