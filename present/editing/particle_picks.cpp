#include "present/editing/particle_picks.h"

#include <algorithm>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "host/base/error.h"
#include "host/clouds/particles/particle_motion.h"
#include "host/scene/schema/parameter_table.h"

namespace offing::present {
namespace {

/// The edit of what is picked in a cloud, which is made at first use.
clouds::ParticleEdit& edit_of(scene::Scene& scene, PickedParticles::InCloud& picked) {
  std::vector<clouds::ParticleEdit>& edits = scene.clouds[picked.cloud].edits;
  if (!picked.edit) {
    const std::size_t most = scene::find_parameter("cloud.particle_edit.fate")->max_count;
    if (edits.size() >= most) {
      throw Error(ErrorKind::bad_usage, fmt::format("[[cloud.particle_edit]]: expected at most {}", most),
                  "remove some first");
    }
    picked.edit = edits.size();
    edits.push_back({.selection = picked.selection});
  }
  return edits[*picked.edit];
}

}  // namespace

ClipBox box_between(glm::dvec2 a, glm::dvec2 b) {
  return {glm::min(a, b), glm::max(a, b)};
}

glm::dvec3 PickedParticles::middle_m() const {
  glm::dvec3 sum_m(0.0);
  for (const glm::dvec3& place_m : places_m) sum_m += place_m;
  return sum_m / static_cast<double>(std::max<std::size_t>(places_m.size(), 1)) + push_m;
}

std::vector<CloudParticle> shown_particles(const world::WorldClouds& view, std::size_t cloud) {
  const world::CloudSkyParameters& sky = view.parameters();
  if (cloud >= sky.particles.size() || !sky.particles[cloud]) return {};
  return clouds::edited_particles(*sky.particles[cloud], sky.clouds[cloud].edits);
}

PickedParticles particles_in(const scene::Scene& scene, const world::WorldClouds& view, const Camera& camera,
                             const ClipBox& box, double time_s) {
  if (camera.roll_rad != 0.0) {
    throw Error(ErrorKind::bad_usage, "particles: expected a camera without a roll",
                "set camera.roll_deg = 0");
  }
  const glm::dvec2 extent = half_extent(camera);
  PickedParticles picked;
  const std::size_t count = std::min(scene.clouds.size(), view.parameters().clouds.size());
  for (std::size_t cloud = 0; cloud < count; ++cloud) {
    const glm::dvec3 origin_m = clouds::cloud_origin_m(view.parameters().clouds[cloud], time_s);
    clouds::ParticleSelection selection{.eye_m = camera.eye_m - origin_m,
                                        .yaw_rad = camera.yaw_rad,
                                        .pitch_rad = camera.pitch_rad,
                                        .low = box.low * extent,
                                        .high = box.high * extent};
    const std::size_t before = picked.places_m.size();
    for (const CloudParticle& particle :
         clouds::selected_particles(shown_particles(view, cloud), selection)) {
      picked.places_m.push_back(origin_m + glm::dvec3(particle.x, particle.y, particle.z));
    }
    if (picked.places_m.size() == before) continue;
    selection.eye_m /= scene.clouds[cloud].scale;
    picked.clouds.push_back({cloud, selection});
  }
  return picked;
}

void push_particles(scene::Scene& scene, PickedParticles& picked, const glm::dvec3& way_m) {
  for (PickedParticles::InCloud& in_cloud : picked.clouds) {
    edit_of(scene, in_cloud).push_m += way_m / scene.clouds[in_cloud.cloud].scale;
  }
  picked.push_m += way_m;
}

void colour_particles(scene::Scene& scene, PickedParticles& picked, const glm::dvec3& albedo) {
  for (PickedParticles::InCloud& in_cloud : picked.clouds) edit_of(scene, in_cloud).albedo = albedo;
}

void remove_particles(scene::Scene& scene, PickedParticles& picked) {
  for (PickedParticles::InCloud& in_cloud : picked.clouds) {
    edit_of(scene, in_cloud).fate = clouds::ParticleFate::removed;
  }
  picked = {};
}

}  // namespace offing::present
