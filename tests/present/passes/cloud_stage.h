#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <numeric>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>

#include "host/sky/sun_position.h"
#include "kernels/shared/random.h"
#include "present/passes/clouds/cloud_pass.h"
#include "present/passes/frame.h"
#include "tests/present/gl_test.h"

namespace offing::test {

/// Heaps of particles over a world's sea, lit by how deep they lie in them: clouds without a model of clouds
/// or of their light, for those who draw.
class CloudStage : public GlTest {
 protected:
  static constexpr double exposure = 0.045;

  void SetUp() override {
    GlTest::SetUp();
    if (IsSkipped()) return;
    device_ = std::make_unique<ocl::Device>(ocl::Device::open());
    pass_ = std::make_unique<present::CloudPass>();
    sky_ = std::make_unique<present::SkyPass>();
    transfer_ = std::make_unique<present::Transfer>(*context_, *device_);
  }
  void TearDown() override {
    transfer_.reset();
    sky_.reset();
    pass_.reset();
    frame_.reset();
    world_.reset();
    GlTest::TearDown();
  }

  void open(world::WorldParameters parameters) {
    constexpr double degree = std::numbers::pi / 180.0;
    parameters.sun.sun_direction = sky::direction_of(230.0 * degree, 40.0 * degree);
    world_ = std::make_unique<world::World>(*device_, parameters);
    if (!frame_) {
      frame_ = std::make_unique<present::Frame>(
          *context_, *device_, present::FrameSettings{.water = {.cells = {64, 64}, .taps = 1}});
    }
  }

  glm::dvec3 sun() const {
    const auto& [x, y, z] = world_->parameters().sun.sun_direction;
    return {x, y, z};
  }

  void add(const CloudParticle& particle, const CloudSprite& sprite) {
    particles_.push_back(particle);
    sprites_.push_back(sprite);
  }

  /// A single ball around a place of the world.
  void add_ball(const glm::dvec3& middle_m, double radius_m, const glm::vec3& kcdpm2,
                float optical_depth = 60.0f) {
    const glm::dvec3 at_m = middle_m - origin_m_;
    add({.x = static_cast<float>(at_m.x),
         .y = static_cast<float>(at_m.y),
         .z = static_cast<float>(at_m.z),
         .radius = static_cast<float>(radius_m),
         .optical_mass = 1.0f,
         .red = 1.0f,
         .green = 1.0f,
         .blue = 1.0f,
         .texture = 0,
         .cloud = 0,
         .id = static_cast<unsigned>(particles_.size()),
         .turn = 0.0f},
        {.red = kcdpm2.r, .green = kcdpm2.g, .blue = kcdpm2.b, .optical_depth = optical_depth});
  }
  void remove_clouds() {
    particles_.clear();
    sprites_.clear();
  }

  /// A heap with a flat base around this place of the world.
  void add_heap(const glm::dvec3& base_m, double size_m, int count, unsigned set = 0) {
    const auto seed = static_cast<std::uint32_t>(particles_.size());
    const auto random = [&](int n, int m, std::size_t word) {
      return static_cast<double>(
          uniform_open01(philox_block(seed, 1, OFFING_STREAM_SHAPES, n, m, 0).v[word]));
    };
    std::vector<glm::dvec4> lumps;
    for (int i = 0; i < 14; ++i) {
      const double turn = 2.0 * std::numbers::pi * random(i, 0, 0), out = std::sqrt(random(i, 0, 1));
      const double radius = size_m * (0.14 + 0.16 * random(i, 0, 2) * (1.0 - 0.7 * out));
      lumps.emplace_back(0.55 * size_m * out * std::cos(turn),
                         0.4 * radius + 0.25 * size_m * (1.0 - out) * random(i, 0, 3),
                         0.4 * size_m * out * std::sin(turn), radius);
    }
    const auto depth_in_heap = [&](const glm::dvec3& place) {
      double deepest = -1e9;
      for (const glm::dvec4& lump : lumps)
        deepest = std::max(deepest, lump.w - glm::length(place - glm::dvec3(lump)));
      return deepest;
    };
    for (int i = 0; i < count; ++i) {
      const glm::dvec4& lump = lumps[static_cast<std::size_t>(14.0 * random(i, 1, 0))];
      const double height = 2.0 * random(i, 1, 1) - 1.0, turn = 2.0 * std::numbers::pi * random(i, 1, 2);
      const double level = std::sqrt(1.0 - height * height);
      glm::dvec3 place =
          glm::dvec3(lump) + 0.85 * lump.w * std::cbrt(random(i, 1, 3)) *
                                 glm::dvec3(level * std::cos(turn), height, level * std::sin(turn));
      if (place.y < 0.0) place.y *= 0.1;
      double shade_m = 0.0;
      for (int step = 1; step < 40; ++step) {
        if (depth_in_heap(place + 0.015 * size_m * step * sun()) > 0.0) shade_m += 0.015 * size_m;
      }
      const double direct =
          1.1 * std::exp(-shade_m / (0.13 * size_m)) + 0.3 * std::exp(-shade_m / (0.6 * size_m));
      const double light = 20.0 * (0.28 + 0.35 * std::clamp(2.0 * place.y / size_m, 0.0, 1.0) + direct);
      const glm::dvec3 at_m = base_m + place - origin_m_;
      const double radius = size_m * (0.035 + 0.05 * random(i, 2, 0)) * std::cbrt(1000.0 / count);
      add({.x = static_cast<float>(at_m.x),
           .y = static_cast<float>(at_m.y),
           .z = static_cast<float>(at_m.z),
           .radius = static_cast<float>(radius),
           .optical_mass = 1.0f,
           .red = 1.0f,
           .green = 1.0f,
           .blue = 1.0f,
           .texture = 16 * set + static_cast<unsigned>(16.0 * random(i, 2, 1)),
           .cloud = 0,
           .id = static_cast<unsigned>(particles_.size()),
           .turn = static_cast<float>(2.0 * std::numbers::pi * random(i, 2, 2))},
          {.red = static_cast<float>(light),
           .green = static_cast<float>(light),
           .blue = static_cast<float>(1.02 * light),
           .optical_depth = 2.5f});
    }
  }

  present::FrameRequest request(const Camera& camera) const {
    return {.camera = camera, .exposure = exposure};
  }

  /// The scene without clouds, into the frame's light.
  void draw_scene(const Camera& camera) {
    world_->at(0.0, camera.eye_m.y);
    frame_->draw(*world_, request(camera));
    sky_->prepare(world_->sky());
  }

  /// What is drawn of the particles, on the device.
  struct Heaps {
    ocl::Buffer<CloudParticle> particles;
    ocl::Buffer<CloudSprite> sprites;
    ocl::Buffer<std::uint32_t> order;
  };
  Heaps heaps_from(const glm::dvec3& eye_m) const {
    std::vector<std::uint32_t> order(particles_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::vector<double> distance;
    for (const CloudParticle& p : particles_) {
      distance.push_back(glm::length(glm::dvec3(p.x, p.y, p.z) + origin_m_ - eye_m));
    }
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return distance[a] > distance[b]; });
    return {.particles = {*device_, particles_, "particles"},
            .sprites = {*device_, sprites_, "sprites"},
            .order = {*device_, order, "order"}};
  }
  clouds::DrawnParticles drawn(const Heaps& heaps) const {
    return {.particles = heaps.particles,
            .sprites = heaps.sprites,
            .order = heaps.order,
            .count = static_cast<std::uint32_t>(particles_.size()),
            .origin_m = origin_m_,
            .sun_direction = sun()};
  }

  /// Clouds over it.
  void draw_clouds(const Camera& camera) {
    const Heaps heaps = heaps_from(camera.eye_m);
    pass_->prepare(*device_, drawn(heaps), camera, frame_->light(), *transfer_);
    frame_->light().bind();
    pass_->draw(camera, world_->parameters().atmosphere, sky_->environment());
  }

  std::vector<float> light(const Camera& camera) {
    draw_scene(camera);
    draw_clouds(camera);
    return frame_->light().read();
  }

  const glm::dvec3 origin_m_{2048.0, 1024.0, -3072.0};
  std::unique_ptr<ocl::Device> device_;
  std::unique_ptr<world::World> world_;
  std::unique_ptr<present::Frame> frame_;
  std::unique_ptr<present::CloudPass> pass_;
  std::unique_ptr<present::SkyPass> sky_;
  std::unique_ptr<present::Transfer> transfer_;
  std::vector<CloudParticle> particles_;
  std::vector<CloudSprite> sprites_;
};

}  // namespace offing::test
