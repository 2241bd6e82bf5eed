#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "host/base/camera.h"
#include "host/clouds/light/cloud_shadow_map.h"
#include "host/clouds/light/resolved_clouds.h"
#include "host/clouds/shape/cloud_parameters.h"
#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "host/world/light_lag.h"
#include "kernels/shared/clouds.h"

namespace offing::world {

/// All clouds of a sky.
struct CloudSkyParameters {
  std::vector<clouds::CloudParameters> clouds;
  /// Of each cloud, or of the first of them: particles at rest, in its axes, in place of those that its
  /// parameters give (files, edits by hand); nullptr: none. Equal that are the same object.
  std::vector<std::shared_ptr<const std::vector<CloudParticle>>> particles = {};
  clouds::LightModel light_model = clouds::LightModel::calibrated;
  bool throws_shadows = true;  ///< on ground, sea and meshes
  /// The light on clouds that move is that of the last multiple of this time, carried along with them; 0: of
  /// any time itself. A sun that moves is followed at once, but for LightLag::cloud_light_frames.
  double light_step_s = 0.5;

  bool operator==(const CloudSkyParameters&) const = default;
};

/// The clouds of a world on a device: particles of all of them in one array, what light they send to an eye
/// and the order in which they are drawn.
///
/// Particles are relative to sky_origin_m(), a place near the clouds, so that floats hold them to 1e-3
/// m within 8 km of it. A particle's `cloud` is the index of its cloud in the parameters.
class WorldClouds {
 public:
  /// Throws what CloudModel and ParticleLight throw, Error(bad_usage) for a sky without clouds.
  WorldClouds(const ocl::Device& device, const CloudSkyParameters& parameters);
  WorldClouds(WorldClouds&&) noexcept;
  WorldClouds& operator=(WorldClouds&&) noexcept;
  ~WorldClouds();

  const CloudSkyParameters& parameters() const;
  /// Puts other clouds in their place; those whose parameters stay are kept as they are. Takes effect with
  /// the next at(), light() and see(). One that throws has changed nothing.
  void set(const CloudSkyParameters& parameters);

  /// From now on each cloud has half of its particles, so many times over, 0 to
  /// clouds::most_particle_halvings (clouds::thinned_particles()), which are made when first asked for. Takes
  /// effect with the next at(), light() and see(). Throws what ocl::Buffer throws, Error(bad_usage) for
  /// another number, and has changed nothing then.
  void set_particle_halvings(int halvings);
  /// Takes effect with the next at(), light() and see().
  void set_light_lag(const LightLag& lag);
  /// Enqueues the clouds as they are at a time, whatever was asked before.
  void at(double time_s);
  /// Enqueues the light that reaches the particles of the last at(), or those of the step of light before it,
  /// one illumination a cloud; nothing where neither they nor the light have changed. With
  /// LightLag::cloud_light_frames above 1, clouds keep the light before until the new one is whole:
  /// illumination(), see() and cast_shadow() are of that one. Throws Error(bad_usage) for another number.
  void light(std::span<const clouds::CloudIllumination> of_clouds);
  /// The same on all clouds.
  void light(const clouds::CloudIllumination& of_all);
  /// Enqueues what is seen of the particles of the last light() from a camera's eye; nothing before one, and
  /// where this was the last eye and nothing else has changed.
  void see(const Camera& camera);
  /// The same for the mirror image of an eye in the sea's level, for water that mirrors what it sees. Where
  /// no cloud sees eye and image more than 0.02 rad apart, the light is that to the eye itself. May wait for
  /// the light's box.
  void see_mirrored(const Camera& mirrored, double plane_m);

  /// What lit the particles of the last light(), one a cloud that is not hidden; none before one.
  std::span<const clouds::CloudIllumination> illumination() const;

  /// Enqueues the shadow that the particles of the last light() throw in the light of its first sun, if that
  /// shines, which shadow_about() carries along with them; nothing where neither has changed. Waits for their
  /// light.
  void cast_shadow();
  /// Of the last cast_shadow(): nullptr where none was cast, or there is no sun.
  const clouds::CloudShadowMap* shadow() const;
  /// The parameters of shadow(), with places relative to a point of the world; without one, those of no
  /// shadow.
  CloudShadowParams shadow_about(const glm::dvec3& point_m) const;

  /// The time of the clouds that light() lights, by the last at().
  double lit_at_s() const;

  // On the device, of the last at(), light() and see().

  /// [count()]
  const ocl::Buffer<CloudParticle>& particles() const;
  std::uint32_t count() const;
  /// count() without halvings.
  std::uint32_t whole_count() const;
  /// [count()], one a particle, in the order of particles().
  const ocl::Buffer<CloudSprite>& sprites() const;
  /// [count()], indices of particles, the farthest from the eye first.
  const ocl::Buffer<std::uint32_t>& order() const;
  /// What is marched of them; nullptr where the light's model is not the calibrated one.
  clouds::ResolvedClouds* resolved() const;
  /// In the world: what the particles' places are relative to. Where they lag behind it drifts with them;
  /// else it changes with set() only, multiples of 1024 m.
  glm::dvec3 sky_origin_m() const;

 private:
  struct Sky;
  std::unique_ptr<Sky> sky_;
};

}  // namespace offing::world
