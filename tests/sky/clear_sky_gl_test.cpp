// The radiance function in OpenGL against itself in OpenCL.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <span>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/sky/clear_sky.h"
#include "host/sky/sun_position.h"
#include "tests/sky/gl_image.h"

namespace offing::sky {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

// Directions as those of kernels/sky/sky_map.cl, row 0 up.
constexpr const char* fragment_head = R"(
layout(std140) uniform Sky { SkyParams sky; };
uniform sampler2D view_table;
uniform sampler2D depth_table;
out vec4 light;
)";
constexpr const char* map_main = R"(
const float pi = 3.14159265;
void main() {
  float azimuth = 2.0 * pi * gl_FragCoord.x / 256.0;
  float zenith_angle = pi * gl_FragCoord.y / 128.0;
  vec3 direction =
      vec3(sin(zenith_angle) * sin(azimuth), cos(zenith_angle), -sin(zenith_angle) * cos(azimuth));
  light = vec4(sky_radiance(sky, view_table, direction), 1.0);
}
)";
// A window of 1.2 sun diameters about the sun, 10 degrees above the south: column and row move the direction.
constexpr const char* sun_main = R"(
void main() {
  vec2 offset = (gl_FragCoord.xy / vec2(256.0, 128.0) - 0.5) * 0.0112;
  vec3 direction = normalize(vec3(sky.sun_direction_x + offset.x, sky.sun_direction_y + offset.y,
                                  sky.sun_direction_z));
  light = vec4(sky_sun_disc(sky, depth_table, direction), 1.0);
}
)";

class ClearSkyGlTest : public testing::Test {
 protected:
  static constexpr int columns = 256, rows = 128;

  void SetUp() override {
    try {
      picture_ = std::make_unique<test::GlImage>(columns, rows);
    } catch (const std::runtime_error& error) {
      GTEST_SKIP() << "no OpenGL here: " << error.what();
    }
    RecordProperty("renderer", picture_->renderer());
  }

  std::vector<Texel> painted(const char* main_source) const {
    return picture_->paint("#version 330 core\n" + clear_sky_glsl() + fragment_head + main_source, "Sky",
                           std::as_bytes(std::span(&sky_.params(), 1)),
                           {{"view_table", SKY_VIEW_COLUMNS, sky_.view_table().read()},
                            {"depth_table", SKY_DEPTH_COLUMNS, sky_.depth_table().read()}});
  }

  ocl::Device device_ = ocl::Device::open();
  ClearSky sky_{device_, Atmosphere{}};
  std::unique_ptr<test::GlImage> picture_;
};

// Fails if GLSL reads the tables or the parameters otherwise than OpenCL C, or does not compile. Angles are
// good to 1e-6 in both (sky_acos()). The fastest that light changes with an angle is at the aureole: the
// aerosol phase function (g = 0.8) by a factor of e in 0.1 rad; twice 1e-6 / 0.1 is 2e-5 of the light. GLSL
// states no accuracy for sin(): 1e-5 there is 1e-4 more. Measured 1.1e-5 (llvmpipe). Gate 2e-4. No row of the
// map touches the horizon, where the light jumps.
TEST_F(ClearSkyGlTest, PaintsTheMapOfOpenCl) {
  for (const double elevation_deg : {60.0, 10.0, 0.0, -5.0}) {
    sky_.at({.sun_direction = direction_of(200.0 * degree, elevation_deg * degree)}, 15.0);
    ocl::Buffer<Texel> map(device_, columns * rows, "map");
    sky_.fill_map(columns, rows, map);
    const std::vector<Texel> expected = map.read(), found = painted(map_main);
    double worst = 0.0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const auto light = [](const Texel& t) { return luminance({t[0], t[1], t[2]}); };
      ASSERT_TRUE(std::isfinite(found[i][0]));
      for (std::size_t c = 0; c < 3; ++c) {
        worst =
            std::max(worst, std::abs(found[i][c] - static_cast<double>(expected[i][c])) / light(expected[i]));
      }
    }
    RecordProperty("worst_1e6_at_" + std::to_string(static_cast<int>(elevation_deg)),
                   static_cast<int>(worst * 1e6));
    EXPECT_LT(worst, 2e-4) << elevation_deg;
  }
}

// Fails if the sun's disc differs in size, place or colour: its light adds up to the sun's illuminance.
TEST_F(ClearSkyGlTest, PaintsTheSun) {
  sky_.at({.sun_direction = direction_of(180.0 * degree, 10.0 * degree)});
  const std::vector<Texel> found = painted(sun_main);
  const auto& sun = sky_.params();
  std::vector<std::array<double, 3>> directions;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const double x = sun.sun_direction_x + ((column + 0.5) / columns - 0.5) * 0.0112;
      const double y = sun.sun_direction_y + ((row + 0.5) / rows - 0.5) * 0.0112;
      const double length = std::hypot(x, y, sun.sun_direction_z);
      directions.push_back({x / length, y / length, sun.sun_direction_z / length});
    }
  }
  const std::vector<Rgb> expected = sky_.read_light(directions).sun_kcdpm2;
  double difference = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    difference += std::abs(found[i][1] - expected[i][1]);
    sum += expected[i][1];
  }
  ASSERT_GT(sum, 0.0);
  // Single precision places the rim within 6e-8 of 9.3e-3: 1e-5 of the light.
  RecordProperty("difference_1e6", static_cast<int>(difference / sum * 1e6));
  EXPECT_LT(difference / sum, 1e-3);
}

}  // namespace
}  // namespace offing::sky
