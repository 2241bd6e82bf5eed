// Shadows of clouds in pictures of the sea.
#include "present/passes/clouds/cloud_shadows.h"

#include <gtest/gtest.h>

#include "host/clouds/shape/genera.h"
#include "host/ocean/spectrum/spectrum_parameters.h"
#include "tests/present/passes/cloud_stage.h"

namespace offing::test {
namespace {

class CloudShadowsTest : public CloudStage {
 protected:
  /// Mean light of the sea in front of the eye, of whose picture clouds take no part.
  double sea_light(bool throws_shadows, const glm::dvec3& cloud_m) {
    world::WorldParameters parameters = sea();
    clouds::CloudParameters cloud = clouds::preset(clouds::Genus::cumulus);
    cloud.position_m = cloud_m;
    cloud.motion = {};
    parameters.clouds =
        world::CloudSkyParameters{.clouds = {cloud}, .particles = {}, .throws_shadows = throws_shadows};
    open(parameters);
    Camera camera;
    camera.eye_m = {0.0, 40.0, 0.0};
    camera.pitch_rad = -0.9;
    camera.vertical_field_of_view_rad = 0.6;
    camera.width_px = 64;
    camera.height_px = 36;
    world_->at(0.0, camera.eye_m.y);
    frame_->draw(*world_, request(camera));
    const std::vector<float> pixels = frame_->light().read();
    double sum = 0.0;
    for (std::size_t i = 0; i < pixels.size(); i += 4) sum += pixels[i + 1];
    return sum / static_cast<double>(pixels.size() / 4);
  }

  static world::WorldParameters sea() {
    ocean::SpectrumParameters spectrum;
    spectrum.wind_speed_mps = 8.0;
    spectrum.fetch_m = 30e3;
    world::WorldParameters parameters;
    parameters.spectrum = ocean::make_sea_spectrum(spectrum);
    parameters.ocean.size = 64;
    const std::array lengths{90.0};
    parameters.ocean.cascades = ocean::cascades_from_patches(lengths, parameters.ocean.size);
    return parameters;
  }
};

// Fails if the sea in a cloud's shadow is as bright as beside it, or if a cloud elsewhere darkens it. The
// sun's glitter and light from below are gone, the mirrored sky stays.
TEST_F(CloudShadowsTest, DarkenTheSeaBelow) {
  constexpr double altitude_m = 1000.0;
  open(sea());
  const glm::dvec3 toward_sun = sun();
  const glm::dvec3 above = altitude_m / toward_sun.y * toward_sun;
  const double open_sea = sea_light(false, above);
  EXPECT_LT(sea_light(true, above), 0.9 * open_sea);
  EXPECT_NEAR(sea_light(true, above + glm::dvec3(6000.0, 0.0, 6000.0)) / open_sea, 1.0, 1e-3);
}

}  // namespace
}  // namespace offing::test
