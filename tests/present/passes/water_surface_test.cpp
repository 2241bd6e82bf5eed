// The shape of the water that OpenGL draws, against the composed sea that OpenCL computes.
#include "present/passes/water/water_surface.h"

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/ocean/spectrum/spectrum_parameters.h"
#include "host/sky/sun_position.h"

namespace offing::present {
namespace {

constexpr double time_s = 12.0;
constexpr int side_px = 96;

// A wind sea on 90 m, two swells and a fresh ring, all far from the origin.
world::WorldParameters hybrid_sea() {
  world::WorldParameters parameters;
  ocean::SpectrumParameters spectrum;
  spectrum.wind_speed_mps = 8.0;
  spectrum.fetch_m = 30e3;
  parameters.spectrum = ocean::make_sea_spectrum(spectrum);
  parameters.ocean.size = 64;
  const std::array lengths_m{90.0};
  parameters.ocean.cascades = ocean::cascades_from_patches(lengths_m, parameters.ocean.size);
  const ocean::Dispersion& water = parameters.spectrum.dispersion;
  parameters.ocean.gerstner_waves = {
      .waves = {make_swell({.amplitude_m = 0.7, .wavelength_m = 60.0, .direction_rad = 0.4}, water),
                make_swell({.amplitude_m = 0.3, .wavelength_m = 23.0, .direction_rad = -1.1}, water)},
      .raindrops = {
          {.x_m = 60e3 + 2.0, .z_m = -80e3 + 1.0, .time_s = 11.0, .amplitude_m = 0.4, .wavelength_m = 4.0}}};
  return parameters;
}

// A picture of it from 20 m above, straight down.
class WaterSurfaceTest : public testing::Test {
 protected:
  struct Stage {
    GlContext context = GlContext::headless();
    ocl::Device device = ocl::Device::open();
    world::World world{device, hybrid_sea()};
    Transfer transfer{context, device, std::nullopt};
    WaterMaps maps;
    WaterSurface surface{context.capabilities(), {.columns = 128, .rows = 128}};
  };

  void SetUp() override {
    try {
      stage_ = std::make_unique<Stage>();
    } catch (const Error& error) {
      GTEST_SKIP() << "no OpenGL here: " << error.what();
    }
    stage_->world.at(time_s, camera_.eye_m.y);
    stage_->maps.prepare(stage_->world, stage_->transfer);
  }

  std::unique_ptr<Stage> stage_;
  Camera camera_{.eye_m = {60e3, 20.0, -80e3},
                 .pitch_rad = -0.5 * std::numbers::pi,
                 .width_px = side_px,
                 .height_px = side_px};
};

// Fails if cascades, Gerstner waves or rings are drawn elsewhere than they are, have other phases, or are
// lost: at each pixel, the place on the surface that its ray meets is where the composed sea moves the
// pixel's label. Cells are 0.3 m wide; within one, a line is off by curvature / 8 times its square, 0.3 m^-1
// for the ring: 3 mm. Maps are bilinear in both, but OpenGL's filter has 8 bits of place: of 1.4 m between
// texels and slopes of 0.3, 2 mm. Gate 1 cm.
TEST_F(WaterSurfaceTest, IsTheComposedSea) {
  ASSERT_TRUE(stage_->surface.draw(stage_->world, stage_->maps, camera_, Fill::solid));
  const std::vector<float> places = stage_->surface.target().read(0);
  const std::vector<float> facets = stage_->surface.target().read(1);
  double worst_m = 0.0, highest_m = 0.0;
  for (int row = 2; row < side_px; row += 7) {
    for (int column = 2; column < side_px; column += 7) {
      const auto pixel = 4 * static_cast<std::size_t>(row * side_px + column);
      ASSERT_GT(facets[pixel + 2], 0.0f) << "a hole";
      const glm::dvec3 ray = glm::normalize(
          ray_direction(camera_, {(2.0 * column + 1.0) / side_px - 1.0, (2.0 * row + 1.0) / side_px - 1.0}));
      const glm::dvec3 found = ray * static_cast<double>(facets[pixel + 2]);
      const ocean::ComposedFields sea =
          stage_->world.ocean().read_composed({.origin_x_m = camera_.eye_m.x + places[pixel],
                                               .origin_z_m = camera_.eye_m.z + places[pixel + 1],
                                               .spacing_x_m = 0.1,
                                               .spacing_z_m = 0.1,
                                               .columns = 1,
                                               .rows = 1});
      const glm::dvec3 expected(places[pixel] + sea.displacement_x[0],
                                sea.displacement_y[0] - camera_.eye_m.y,
                                places[pixel + 1] + sea.displacement_z[0]);
      worst_m = std::max(worst_m, glm::distance(found, expected));
      highest_m = std::max(highest_m, std::abs(static_cast<double>(sea.displacement_y[0])));
    }
  }
  RecordProperty("worst_mm", static_cast<int>(1e3 * worst_m));
  EXPECT_LT(worst_m, 0.01);
  EXPECT_GT(highest_m, 0.5) << "there is nothing to compare";
}

// Fails if pixels above the horizon are taken for water, or what was drawn before stays.
TEST_F(WaterSurfaceTest, LeavesTheSkyFree) {
  ASSERT_TRUE(stage_->surface.draw(stage_->world, stage_->maps, camera_, Fill::solid));
  camera_.pitch_rad = 0.0;
  ASSERT_TRUE(stage_->surface.draw(stage_->world, stage_->maps, camera_, Fill::solid));
  const std::vector<float> facets = stage_->surface.target().read(1);
  EXPECT_EQ(facets[4 * (side_px - 1) * side_px + 2], 0.0f);
  EXPECT_GT(facets[2], 0.0f);
}

}  // namespace
}  // namespace offing::present
