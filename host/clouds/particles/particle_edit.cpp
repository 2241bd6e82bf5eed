#include "host/clouds/particles/particle_edit.h"

#include <algorithm>
#include <iterator>

#include <glm/geometric.hpp>

#include "host/base/camera.h"

namespace offing::clouds {
namespace {

/// A selection with the axes of its eye.
class Window {
 public:
  explicit Window(const ParticleSelection& selection)
      : selection_(selection),
        axes_(basis({.yaw_rad = selection.yaw_rad, .pitch_rad = selection.pitch_rad})) {}

  bool shows(const CloudParticle& particle) const {
    const glm::dvec3 way_m = glm::dvec3(particle.x, particle.y, particle.z) - selection_.eye_m;
    const double depth_m = glm::dot(way_m, axes_.forward);
    if (depth_m <= 0.0) return false;
    const glm::dvec2 place = glm::dvec2(glm::dot(way_m, axes_.right), glm::dot(way_m, axes_.up)) / depth_m;
    return place.x >= selection_.low.x && place.x <= selection_.high.x && place.y >= selection_.low.y &&
           place.y <= selection_.high.y;
  }

 private:
  const ParticleSelection& selection_;
  CameraBasis axes_;
};

void change(const ParticleEdit& edit, CloudParticle& particle) {
  particle.x += static_cast<float>(edit.push_m.x);
  particle.y += static_cast<float>(edit.push_m.y);
  particle.z += static_cast<float>(edit.push_m.z);
  if (!edit.albedo) return;
  particle.red = static_cast<float>(edit.albedo->x);
  particle.green = static_cast<float>(edit.albedo->y);
  particle.blue = static_cast<float>(edit.albedo->z);
}

}  // namespace

std::vector<CloudParticle> selected_particles(std::span<const CloudParticle> particles,
                                              const ParticleSelection& selection) {
  const Window window(selection);
  std::vector<CloudParticle> selected;
  std::copy_if(particles.begin(), particles.end(), std::back_inserter(selected),
               [&](const CloudParticle& particle) { return window.shows(particle); });
  return selected;
}

std::vector<CloudParticle> edited_particles(std::span<const CloudParticle> at_rest,
                                            std::span<const ParticleEdit> edits) {
  std::vector<CloudParticle> particles(at_rest.begin(), at_rest.end());
  for (const ParticleEdit& edit : edits) {
    const Window window(edit.selection);
    if (edit.fate == ParticleFate::removed) {
      std::erase_if(particles, [&](const CloudParticle& particle) { return window.shows(particle); });
      continue;
    }
    for (CloudParticle& particle : particles) {
      if (window.shows(particle)) change(edit, particle);
    }
  }
  return particles;
}

}  // namespace offing::clouds
