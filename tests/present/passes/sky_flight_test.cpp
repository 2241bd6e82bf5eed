// The flight of scenes/sky.toml as offing-view records it: nothing may pop, and no seam may be seen.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "host/scene/file/scene_file.h"
#include "host/scene/prepare/world_scene.h"
#include "present/passes/frame.h"
#include "present/passes/sky/light_meter.h"
#include "present/view_options.h"
#include "tests/present/gl_test.h"
#include "tests/present/passes/flight_steps.h"

namespace offing::present {
namespace {

constexpr int width = 160, height = 90;
constexpr int frames = 600;

class SkyFlightTest : public test::GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (IsSkipped()) return;
    scene_ = scene::load_scene(std::filesystem::path(OFFING_SCENES) / "sky.toml");
    device_.emplace(ocl::Device::open());
    world_.emplace(*device_, scene::prepare_shown_world(scene_));
    frame_.emplace(*context_, *device_, frame_settings(Detail::low));
  }
  void TearDown() override {
    frame_.reset();
    world_.reset();
    GlTest::TearDown();
  }

  test::Blocks blocks_at(double time_s) {
    scene::ViewScene view = scene::show_at(*world_, scene_, time_s);
    view.camera.width_px = width;
    view.camera.height_px = height;
    const double exposure = light_meter_.exposure(*world_, view.camera, view.exposure_ev);
    frame_->draw(*world_, {.camera = view.camera, .exposure = exposure});
    const std::vector<float> pixels = frame_->light().read();
    look_for_seams(pixels, exposure);
    return test::blocks_of(pixels, {width, height}, exposure);
  }

  /// Counts how much darker pixels are than both of their neighbours, apart for each place in a tile.
  void look_for_seams(const std::vector<float>& pixels, double exposure) {
    const auto green = [&](int column, int row) {
      return exposure * pixels[4 * static_cast<std::size_t>(row * width + column) + 1];
    };
    for (int row = 1; row < height - 1; ++row) {
      for (int column = 1; column < width - 1; ++column) {
        const double here = green(column, row);
        darkest_ = std::isfinite(here) ? std::min(darkest_, here) : -1.0;
        const auto notch = [&](double before, double after) {
          return std::clamp(0.5 * (before + after) - here, -0.1, 0.1);
        };
        add(column % CLOUD_TILE_PX, 0, notch(green(column - 1, row), green(column + 1, row)));
        add(row % CLOUD_TILE_PX, 1, notch(green(column, row - 1), green(column, row + 1)));
      }
    }
  }
  void add(int place, int along, double notch) {
    Notches& of_place = notches_[static_cast<std::size_t>(along)][static_cast<std::size_t>(place)];
    of_place.sum += notch;
    of_place.count += 1.0;
  }

  struct Notches {
    double sum = 0.0, count = 0.0;
    double mean() const { return sum / count; }
  };

  /// By how much pixels at one place of a tile are darker than those beside them, more than at other places.
  double worst_seam() const {
    double worst = 0.0;
    for (const auto& along : notches_) {
      double mean = 0.0;
      for (const Notches& place : along) mean += place.mean() / CLOUD_TILE_PX;
      for (const Notches& place : along) worst = std::max(worst, place.mean() - mean);
    }
    return worst;
  }

  scene::Scene scene_;
  std::optional<ocl::Device> device_;
  std::optional<world::World> world_;
  std::optional<Frame> frame_;
  LightMeter light_meter_;
  double darkest_ = 1e9;                                         // of all pixels, in white
  std::array<std::array<Notches, CLOUD_TILE_PX>, 2> notches_{};  // along rows, along columns
};

// Fails if anything pops in the flight of the shipped sky, as its users record it: 600 frames along its keys,
// over the sea, below, through and between clouds. Bound: what is left of motion alone (flight_steps.h), of
// at most white, 0.0003 and some times that. Measured 0.0011, gate 0.002: half a step of 8 bits, in one
// block, fails. Numbers that are none and holes fail too: the darkest pixel has 0.085 of white, gate 0.05.
// Seams: places of a tile of clouds are darker than their neighbours by 0.0008 at most, as horizon and
// clouds lie; gate 0.0015: one of half a step of 8 bits along all tiles fails by itself.
// 290 s of the processor.
TEST_F(SkyFlightTest, NothingPopsAndNoSeamIsSeen) {
  const test::FlightSteps steps = test::flight_steps([this](double time_s) { return blocks_at(time_s); },
                                                     frames, frames / scene_.time.end_s);
  RecordProperty("worst_excess_1e4", static_cast<int>(1e4 * steps.worst_excess));
  RecordProperty("worst_left_1e5", static_cast<int>(1e5 * steps.worst_left));
  RecordProperty("darkest_1e4", static_cast<int>(1e4 * darkest_));
  RecordProperty("worst_seam_1e6", static_cast<int>(1e6 * worst_seam()));
  EXPECT_LT(steps.worst_left, 0.002);
  EXPECT_GT(darkest_, 0.05);
  EXPECT_LT(worst_seam(), 0.0015);
}

}  // namespace
}  // namespace offing::present
