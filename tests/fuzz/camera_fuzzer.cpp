// What people write for --camera and --size, and the other lists and ranges of numbers on command lines: one
// a line.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string_view>

#include "host/base/argument.h"
#include "host/cli/terrain/terrain_camera.h"
#include "tests/fuzz/expect.h"

namespace {

using offing::Camera;
using offing::fuzz::check_reading;
using offing::fuzz::expect;

constexpr double highest_m = 900.0;

/// Ground of 1 km that rises to the east.
const offing::cli::CameraTerrain terrain{
    .extent = {.width_m = 1000.0, .depth_m = 1000.0, .highest_m = highest_m},
    .under = [](double x_m, double) {
      return offing::terrain::TerrainPoint{0.9 * x_m, {-0.67, 0.74, 0.0}};
    }};

void expect_camera(std::string_view text) {
  const Camera camera = offing::cli::read_terrain_camera(text, terrain);
  for (int axis = 0; axis < 3; ++axis) expect(std::isfinite(camera.eye_m[axis]));
  expect(std::abs(camera.yaw_rad) <= std::numbers::pi &&
         std::abs(camera.pitch_rad) <= std::numbers::pi / 2.0);
}

void expect_size(std::string_view text) {
  Camera camera;
  offing::cli::read_image_size(text, camera);
  expect(camera.width_px >= 1 && camera.width_px <= 16384 && camera.height_px >= 1 &&
         camera.height_px <= 16384);
}

void expect_frames(std::string_view text) {
  const offing::FrameRange frames = offing::read_frame_range("--frames", text);
  expect(frames.first >= 0 && frames.first <= frames.last && frames.last <= 9999999);
}

void expect_share(std::string_view text) {
  const offing::Share share = offing::read_share("--share", text);
  expect(share.index >= 0 && share.index < share.count);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  for (const auto check : {expect_camera, expect_size, expect_frames, expect_share}) {
    const std::size_t end = rest.find('\n');
    check_reading([&] { check(rest.substr(0, end)); });
    if (end == std::string_view::npos) break;
    rest.remove_prefix(end + 1);
  }
  return 0;
}
