// A sea that is edited while it is shown, without a window.
#include "present/passes/live_sea.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/ocean/surface/foam_onset.h"
#include "host/scene/file/scene_file.h"
#include "tests/ocl/log_capture.h"
#include "tests/present/gl_test.h"

namespace offing::present {
namespace {

class LiveSeaTest : public test::GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (IsSkipped()) return;
    open("[ocean]\nsize = 32\n");
  }
  void open(const std::string& sections) {
    scene_ = scene::parse_scene("version = 1\n" + sections, "a.toml", "");
    sea_.reset();
    sea_ = std::make_unique<LiveSea>(
        *context_,
        LiveSeaSettings{.device = "", .frame = {.water = {.cells = {32, 32}, .taps = 1}, .transfer = {}}},
        scene_);
  }
  void TearDown() override {
    sea_.reset();
    GlTest::TearDown();
  }

  std::vector<unsigned char> picture() {
    sea_->draw({.time_s = 3.0,
                .camera = {.eye_m = {0.0, 5.0, 0.0}, .pitch_rad = -0.3, .width_px = 64, .height_px = 48}});
    return sea_->frame().screen().read_bytes();
  }

  scene::Scene scene_;
  std::unique_ptr<LiveSea> sea_;
};

// Fails if an edit that is refused leaves a part of it behind: a sun whose clock runs beyond its calendar,
// a spectrum that cannot be read.
TEST_F(LiveSeaTest, RefusedEditsChangeNothing) {
  const std::vector<unsigned char> before = picture();
  for (const char* part :
       {"[sun]\ntime_utc = 2100-12-31T23:59:59Z\ntime_scale = 1\n[time]\nstart_s = 100\nend_s = 101\n",
        "[ocean]\nspectrum_file = \"nowhere.data_spec\"\n"}) {
    scene::Scene edited = scene::parse_scene(std::string("version = 1\n") + part, "b.toml", "");
    edited.ocean.parameters.size = 32;
    edited.wind.wind_speed_mps = 20.0;
    edited.view.atmosphere.aerosol_optical_depth = 0.9;
    EXPECT_THROW(sea_->edit(edited), Error) << part;
    EXPECT_EQ(sea_->scene().wind.wind_speed_mps, scene_.wind.wind_speed_mps);
    EXPECT_TRUE(picture() == before) << part;
  }
  scene::Scene edited = scene_;
  edited.wind.wind_speed_mps = 20.0;
  sea_->edit(edited);
  EXPECT_FALSE(picture() == before) << "an edit that is taken cannot be seen";
}

// Fails if an edit that is refused, before or after the sea has changed, sends bodies elsewhere than where
// edits before it had put them.
TEST_F(LiveSeaTest, RefusedEditsLeaveBodiesWhereTheyAre) {
  open(
      "[ocean]\nsize = 32\ncascade_count = 1\n[[mesh]]\nname = \"hull\"\nshape = \"ship\"\nsize_m = 24\n"
      "[[body]]\nmesh = \"hull\"\nspeed_mps = 5\ndraught_m = 1.5\n");
  picture();
  scene::Scene edited = scene_;
  edited.bodies[0].z_m = 40.0;  // it starts anew at this time
  sea_->edit(edited);
  picture();
  const auto place_m = [&](double time_s) { return sea_->bodies()->pose(0, time_s).mass_centre_m; };
  const glm::dvec3 before_m = place_m(3.0);
  EXPECT_NEAR(before_m.x, 0.0, 1.0);
  for (const bool has_other_sea : {false, true}) {
    scene::Scene refused = edited;
    if (has_other_sea) refused.wind.wind_speed_mps = 20.0;
    scene::MeshScene& mesh = refused.meshes.emplace_back();
    mesh.name = "none";
    mesh.file = "nowhere.obj";
    EXPECT_THROW(sea_->edit(refused), Error);
    picture();
    EXPECT_EQ(place_m(3.0), before_m);
  }
}

// Fails if waves that are too steep are not told of, or again and again while a slider moves.
TEST_F(LiveSeaTest, WarnsOnceOfSteepWaves) {
  EXPECT_EQ(sea_->warning(), "");
  const test::LogCapture log;
  scene::Scene edited = scene_;
  for (const double amplitude_m : {2.0, 2.1, 2.2}) {
    edited.ocean.swells = {{.amplitude_m = amplitude_m, .wavelength_m = 8.0}};
    edited.wind.wind_speed_mps += 0.1;
    sea_->edit(edited);
    EXPECT_NE(sea_->warning().find("the swells have a choppiness of "), std::string::npos);
  }
  std::size_t count = 0;
  for (std::size_t at = 0; (at = log.text().find("have a choppiness of", at)) != std::string::npos; ++at) {
    ++count;
  }
  EXPECT_EQ(count, 1u) << log.text();
  edited.ocean.swells.clear();
  sea_->edit(edited);
  EXPECT_EQ(sea_->warning(), "");
}

// Fails if the foam that the wind makes is not told, or told where the scene says how much there is.
TEST_F(LiveSeaTest, KnowsTheFoamOfTheWind) {
  scene::Scene edited = scene_;
  for (const double wind_mps : {8.0, 20.0}) {
    edited.wind.wind_speed_mps = wind_mps;
    sea_->edit(edited);
    const auto computed = sea_->computed_values();
    ASSERT_TRUE(computed.contains("ocean.foam.fraction"));
    EXPECT_NEAR(computed.at("ocean.foam.fraction"), ocean::whitecap_fraction(wind_mps), 1e-12);
  }
  edited.ocean.parameters.foam.onset_jacobian = 0.5;
  sea_->edit(edited);
  EXPECT_TRUE(sea_->computed_values().empty());
}

// Fails if the height is not that of the water that is shown there.
TEST_F(LiveSeaTest, KnowsTheWaterBelowAPoint) {
  scene::Scene edited = scene_;
  edited.ocean.swells = {{.amplitude_m = 3.0, .wavelength_m = 900.0}};
  edited.wind.wind_speed_mps = 0.5;
  sea_->edit(edited);
  picture();
  double lowest_m = 0.0, highest_m = 0.0;
  for (int i = 0; i < 30; ++i) {
    const double height_m = sea_->surface_height_m(30.0 * i, 0.0);
    lowest_m = std::min(lowest_m, height_m);
    highest_m = std::max(highest_m, height_m);
  }
  EXPECT_NEAR(lowest_m, -3.0, 0.3);
  EXPECT_NEAR(highest_m, 3.0, 0.3);
}

}  // namespace
}  // namespace offing::present
