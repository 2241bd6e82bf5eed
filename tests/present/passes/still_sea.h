#pragma once

#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/scene/file/scene_file.h"
#include "host/scene/prepare/moving_view.h"
#include "host/scene/prepare/world_scene.h"
#include "present/passes/frame.h"
#include "present/passes/sky/light_meter.h"
#include "tests/present/gl_test.h"

namespace offing::test {

/// Pictures of scenes by small square cameras.
class StillSea : public GlTest {
 protected:
  static constexpr int side_px = 96;
  /// Waves of millimetres; the text of a scene from [wind] to [ocean].
  static constexpr const char* still_sea = "[wind]\nspeed_mps = 0.1\n[ocean]\nsize = 32\nfetch_m = 100\n";

  void SetUp() override {
    GlTest::SetUp();
    if (!IsSkipped()) device_ = std::make_unique<ocl::Device>(ocl::Device::open());
  }

  static Camera square_camera(const glm::dvec3& eye_m) {
    return {.eye_m = eye_m, .width_px = side_px, .height_px = side_px};
  }

  /// Light [height][width] of 4 floats, kcd/m2, row 0 at the bottom; WaterDetail::views_px as given.
  std::vector<float> light(const std::string& text, const Camera& camera, int views_px,
                           const present::Quality& quality = {}) {
    return light_of_last(text, {camera}, views_px, quality, present::SkyRefresh::whole);
  }

  /// Whether a world has the sea of its scene.
  enum class Sea { as_given, none };

  /// The same of a world with this ground, at a time.
  std::vector<float> light_on(const world::TerrainParameters& terrain, const std::string& text,
                              const Camera& camera, int views_px, Sea sea = Sea::as_given,
                              double time_s = 0.0) {
    const scene::Scene scene = scene::parse_scene("version = 1\n" + text, "a.toml", "");
    world::WorldParameters parameters = scene::prepare_world(scene, scene::Warnings::left_out);
    parameters.terrain = terrain;
    if (sea == Sea::none) parameters.has_sea = false;
    world::World world(*device_, parameters);
    present::Frame frame(*context_, *device_, {.water = {{64, 64}, 1, views_px}, .transfer = {}});
    world.at(time_s, camera.eye_m.y);
    frame.draw(world, {.camera = camera, .exposure = 0.1, .debug = shown_});
    return frame.light().read();
  }

  /// What a light meter makes of such a world, in stops.
  double metered_stops(const std::optional<world::TerrainParameters>& terrain, const std::string& text,
                       const Camera& camera, Sea sea = Sea::as_given) {
    const scene::Scene scene = scene::parse_scene("version = 1\n" + text, "a.toml", "");
    world::WorldParameters parameters = scene::prepare_world(scene, scene::Warnings::left_out);
    parameters.terrain = terrain;
    if (sea == Sea::none) parameters.has_sea = false;
    world::World world(*device_, parameters);
    scene::set_view(world, scene::view_at(scene, 0.0));
    world.at(0.0, camera.eye_m.y);
    return std::log2(present::LightMeter().exposure(world, camera, 0.0));
  }

  /// The same of the last of several pictures in a row.
  std::vector<float> light_of_last(const std::string& text, const std::vector<Camera>& cameras, int views_px,
                                   const present::Quality& quality, present::SkyRefresh sky) {
    const scene::Scene scene = scene::parse_scene("version = 1\n" + text, "a.toml", "");
    world::World world(*device_, scene::prepare_world(scene, scene::Warnings::left_out));
    present::Frame frame(*context_, *device_, {.water = {{64, 64}, 1, views_px}, .transfer = {}});
    for (const Camera& camera : cameras) {
      world.at(0.0, camera.eye_m.y);
      frame.draw(world, {.camera = camera, .exposure = 0.1, .debug = shown_, .sky = sky, .quality = quality});
    }
    return frame.light().read();
  }

  /// What pictures of the water show.
  present::WaterShow shown_ = present::WaterShow::none;

  static const float* pixel(const std::vector<float>& light, int column, int row) {
    return &light[static_cast<std::size_t>(4 * (row * side_px + column))];
  }

 private:
  std::unique_ptr<ocl::Device> device_;
};

}  // namespace offing::test
