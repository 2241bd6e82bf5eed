// Edits of particles by hand: what a box on a screen selects, and what is left after the cloud is made again.
#include "host/clouds/particles/particle_edit.h"

#include <cmath>
#include <random>
#include <vector>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/camera.h"
#include "host/clouds/particles/cloud_model.h"
#include "host/clouds/shape/genera.h"

namespace offing::clouds {
namespace {

CloudParticle at(const glm::dvec3& place_m, std::uint32_t id) {
  return {.x = static_cast<float>(place_m.x),
          .y = static_cast<float>(place_m.y),
          .z = static_cast<float>(place_m.z),
          .radius = 10.0f,
          .optical_mass = 5.0f,
          .red = 0.9f,
          .green = 0.9f,
          .blue = 0.9f,
          .texture = 0,
          .cloud = 0,
          .id = id,
          .turn = 0.0f};
}

/// 1,000 particles in a cube of 400 m.
std::vector<CloudParticle> scattered() {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> along(-200.0, 200.0);
  std::vector<CloudParticle> particles;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    particles.push_back(at({along(random), along(random), along(random)}, i));
  }
  return particles;
}

ParticleSelection selection() {
  return {.eye_m = {50.0, 20.0, 700.0},
          .yaw_rad = 0.1,
          .pitch_rad = -0.05,
          .low = {-0.2, -0.1},
          .high = {0.05, 0.15}};
}

/// What a picture of a camera shows within the rectangle, by its matrices.
bool is_seen(const ParticleSelection& selection, const CloudParticle& particle) {
  const Camera camera{.eye_m = selection.eye_m,
                      .yaw_rad = selection.yaw_rad,
                      .pitch_rad = selection.pitch_rad,
                      .vertical_field_of_view_rad = 2.0 * std::atan(1.0),
                      .width_px = 100,
                      .height_px = 100};
  const glm::dvec4 clip = projection(camera, 0.1) * view_rotation(camera) *
                          glm::dvec4(glm::dvec3(particle.x, particle.y, particle.z) - selection.eye_m, 1.0);
  const glm::dvec2 place = glm::dvec2(clip) / clip.w;
  return clip.w > 0.0 && place.x >= selection.low.x && place.x <= selection.high.x &&
         place.y >= selection.low.y && place.y <= selection.high.y;
}

// Of a field of view of 90 degrees clip coordinates are slopes. Fails if the eye's axes or the rectangle's
// sides are mixed up: some particles would be on the other side of one.
TEST(ParticleEdit, SelectsWhatTheEyeSees) {
  const std::vector<CloudParticle> particles = scattered();
  const std::vector<CloudParticle> selected = selected_particles(particles, selection());
  std::vector<std::uint32_t> expected, found;
  for (const CloudParticle& particle : particles) {
    if (is_seen(selection(), particle)) expected.push_back(particle.id);
  }
  for (const CloudParticle& particle : selected) found.push_back(particle.id);
  EXPECT_GT(expected.size(), 50u);
  EXPECT_EQ(found, expected);
}

TEST(ParticleEdit, NothingBehindTheEye) {
  ParticleSelection behind = selection();
  behind.yaw_rad += 3.14159265358979;
  EXPECT_TRUE(selected_particles(scattered(), behind).empty());
}

// Fails if an edit changes what it does not select, the order or the ids, or a later one selects by places
// from before the earlier ones.
TEST(ParticleEdit, EditsFollowOneAnother) {
  const std::vector<CloudParticle> particles = scattered();
  const std::size_t count = selected_particles(particles, selection()).size();
  ParticleEdit push{.selection = selection(), .push_m = {0.0, 2000.0, 0.0}};
  push.albedo = glm::dvec3(1.0, 0.5, 0.25);
  const ParticleEdit removal{.selection = selection(), .fate = ParticleFate::removed};

  const std::vector<CloudParticle> pushed = edited_particles(particles, std::vector{push});
  ASSERT_EQ(pushed.size(), particles.size());
  std::size_t moved = 0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    EXPECT_EQ(pushed[i].id, particles[i].id);
    const bool is_moved = pushed[i].y != particles[i].y;
    moved += is_moved ? 1 : 0;
    EXPECT_EQ(pushed[i].green, is_moved ? 0.5f : 0.9f);
    EXPECT_EQ(pushed[i].x, particles[i].x);
  }
  EXPECT_EQ(moved, count);
  // They have left the box: nothing is there to remove.
  EXPECT_EQ(edited_particles(particles, std::vector{push, removal}).size(), particles.size());
  EXPECT_EQ(edited_particles(particles, std::vector{removal, push}).size(), particles.size() - count);
}

// Fails if a cloud that is made of another seed loses its edits, or one without particles left cannot be
// shown.
TEST(ParticleEdit, LieOverWhatIsMadeAnew) {
  const ocl::Device device = ocl::Device::open();
  const ParticleEdit removal{
      .selection = {.eye_m = {0.0, 0.0, 5000.0}, .low = {-1.0, -1.0}, .high = {0.0, 1.0}},
      .fate = ParticleFate::removed};
  for (const std::uint64_t seed : {1u, 2u}) {
    CloudParameters cloud = preset(Genus::cumulus, seed);
    cloud.motion = {};  // whose eddies sway particles at any time
    const std::uint32_t whole = CloudModel(device, cloud).count();
    cloud.edits = {removal};
    CloudModel model(device, cloud);
    EXPECT_LT(model.count(), whole);
    EXPECT_GT(model.count(), 0u);
    model.at(0.0);
    std::vector<CloudParticle> left = model.particles().read();
    left.resize(model.count());
    for (const CloudParticle& particle : left) EXPECT_GT(particle.x, 0.0f);
    cloud.edits.push_back({.selection = {.eye_m = {0.0, 0.0, 5000.0}}, .fate = ParticleFate::removed});
    EXPECT_EQ(CloudModel(device, cloud).count(), 0u);
  }
}

}  // namespace
}  // namespace offing::clouds
