#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host/clouds/particles/particle_edit.h"
#include "host/scene/model/scene.h"
#include "host/world/world_clouds.h"
#include "present/editing/handle_geometry.h"

namespace offing::present {

/// A rectangle of the screen in clip coordinates.
struct ClipBox {
  glm::dvec2 low{-1.0}, high{1.0};
};
ClipBox box_between(glm::dvec2 a, glm::dvec2 b);

/// Particles of clouds that a box on the screen has selected.
struct PickedParticles {
  struct InCloud {
    std::size_t cloud = 0;
    clouds::ParticleSelection selection;   ///< as [[cloud.particle_edit]] has it
    std::optional<std::size_t> edit = {};  ///< that edits them, once there is one
  };
  std::vector<InCloud> clouds;
  std::vector<glm::dvec3> places_m;  ///< in the world, as they were selected
  glm::dvec3 push_m{0.0};            ///< since then

  bool empty() const { return places_m.empty(); }
  /// Their mean place now.
  glm::dvec3 middle_m() const;
};

/// The particles of a cloud of a scene in the world at a time: at rest in its axes, as edits have left them.
/// What is shown of clouds may be older than the scene: none for one that is not shown yet.
std::vector<CloudParticle> shown_particles(const world::WorldClouds& view, std::size_t cloud);

/// Those of all [[cloud]] that the box shows, shear and sway left aside. Throws Error(bad_usage) for a camera
/// with a roll.
PickedParticles particles_in(const scene::Scene& scene, const world::WorldClouds& view, const Camera& camera,
                             const ClipBox& box, double time_s);

// Edits of what is picked: all go into one [[cloud.particle_edit]] a cloud.

void push_particles(scene::Scene& scene, PickedParticles& picked, const glm::dvec3& way_m);
void colour_particles(scene::Scene& scene, PickedParticles& picked, const glm::dvec3& albedo);
void remove_particles(scene::Scene& scene, PickedParticles& picked);

}  // namespace offing::present
