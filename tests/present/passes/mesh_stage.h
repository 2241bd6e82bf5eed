#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/mesh_shapes/shape.h"
#include "host/sky/sun_position.h"
#include "present/passes/frame.h"
#include "tests/present/gl_test.h"

namespace offing::test {

/// Where meshes stand before a camera, in the light of a sun from the right above, with neither sea nor
/// ground.
class MeshStage : public GlTest {
 protected:
  static constexpr int width = 200, height = 160;
  static constexpr double exposure = 0.05;
  static constexpr glm::dvec3 place_m{30.0, 3.0, -40.0};

  void SetUp() override {
    GlTest::SetUp();
    if (!IsSkipped()) device_ = std::make_unique<ocl::Device>(ocl::Device::open());
  }
  void TearDown() override {
    frame_.reset();
    world_.reset();
    GlTest::TearDown();
  }

  static world::MeshParameters mesh_of(const mesh_shapes::Shape& shape) {
    world::MeshParameters parameters;
    parameters.name = "shape";
    parameters.mesh = std::make_shared<TriangleMesh>(shape.mesh);
    if (shape.truth) parameters.curvatures = std::make_shared<VertexCurvatures>(*shape.truth);
    parameters.motion = [](double) { return highlights::RigidMotion{.translation_m = place_m}; };
    parameters.has_highlights = false;
    return parameters;
  }

  static world::WorldParameters world_of(const world::MeshParameters& mesh) {
    constexpr double degree = std::numbers::pi / 180.0;
    world::WorldParameters parameters;
    parameters.has_sea = false;
    parameters.sun.sun_direction = sky::direction_of(150.0 * degree, 35.0 * degree);
    parameters.meshes = {mesh};
    return parameters;
  }

  void open(const world::MeshParameters& mesh) { open(world_of(mesh)); }
  void open(const world::WorldParameters& parameters) {
    world_ = std::make_unique<world::World>(*device_, parameters);
    if (!frame_) {
      frame_ = std::make_unique<present::Frame>(
          *context_, *device_,
          present::FrameSettings{.water = {.cells = {64, 64}, .taps = 1, .views_px = 0}});
    }
  }

  /// Straight at the mesh, from 4 m.
  static Camera camera() {
    return {.eye_m = place_m + glm::dvec3(0.0, 0.0, 4.0),
            .vertical_field_of_view_rad = 0.65,
            .width_px = width,
            .height_px = height};
  }

  present::FrameRequest request() const {
    return {.camera = camera(), .exposure = exposure, .lighting_at = [this](double) {
              return world_->lighting(camera().eye_m);
            }};
  }

  /// Scene-linear light [height][width] of 4 floats, row 0 at the bottom.
  std::vector<float> light(double time_s = 0.0) { return light(request(), time_s); }
  std::vector<float> light(const present::FrameRequest& asked, double time_s = 0.0) {
    world_->at(time_s, asked.camera.eye_m.y);
    frame_->draw(*world_, asked);
    return frame_->light().read();
  }

  static glm::dvec3 ray_of(int column, int row) {
    return glm::normalize(
        ray_direction(camera(), {(2.0 * column + 1.0) / width - 1.0, (2.0 * row + 1.0) / height - 1.0}));
  }

  /// Where a place of the world is in the picture, pixels from its lower left corner.
  static glm::dvec2 pixel_of(const glm::dvec3& at_m) {
    const CameraBasis axes = basis(camera());
    const glm::dvec3 way = at_m - camera().eye_m;
    const glm::dvec2 clip = glm::dvec2(glm::dot(way, axes.right), glm::dot(way, axes.up)) /
                            glm::dot(way, axes.forward) / half_extent(camera());
    return (0.5 + 0.5 * clip) * glm::dvec2(width, height);
  }

  std::unique_ptr<ocl::Device> device_;
  std::unique_ptr<world::World> world_;
  std::unique_ptr<present::Frame> frame_;
};

}  // namespace offing::test
