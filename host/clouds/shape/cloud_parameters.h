#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "host/base/cloud_volume.h"
#include "host/base/keyframes.h"
#include "host/clouds/particles/particle_edit.h"

namespace offing::clouds {

/// Kinds of clouds (C6, C15 of docs/sources.md): presets of all that a CloudShape and a CloudLook have.
enum class Genus { cirrus, stratus, cumulus, stratocumulus, altocumulus, cumulonimbus, lenticular, funnel };

/// How particles are made: of the density of metaballs (C5), or grown on spheres (C7).
enum class Modelling { sampled, hierarchical };

/// Where the density of a sampled cloud is read: on a grid, merged to a fixed point, or at random places.
enum class Sampling { uniform, random };

/// A metaball (C1), or the seed of a hierarchy (C7).
struct Metaball {
  glm::dvec3 centre_m{0.0};  ///< in the cloud's axes
  double radius_m = 100.0;
  double weight = 1.0;

  bool operator==(const Metaball&) const = default;
};

/// Noise that frays a cloud (C2, C3).
struct Turbulence {
  double wavelength_m = 200.0;  ///< of the longest octave
  int octaves = 5;
  double lacunarity = 2.0;    ///< ratio of the wave numbers of two octaves
  double gain = 0.5;          ///< ratio of their amplitudes
  double strength = 1.0;      ///< alpha of C2
  double blend = 0.5;         ///< share of the noise in the density, 0 ... 1
  double wisp = 1.0;          ///< exponent of C3
  double edge = 0.3;          ///< implicit density below which the noise fades out
  double change_per_s = 0.0;  ///< how fast it changes by itself: noise lengths in the fourth dimension

  bool operator==(const Turbulence&) const = default;
};

/// One level of a hierarchy (C7): radius = ratio * (parent's radius + deviation * rand).
struct HierarchyLevel {
  double ratio = 0.5;
  double deviation_m = 0.0;
  double repulsion = 1.0;  ///< radius that sets the spacing, in drawn radii

  bool operator==(const HierarchyLevel&) const = default;
};

/// What a cloud scatters with (C10, C11).
enum class PhaseKind { rayleigh, henyey_greenstein, double_henyey_greenstein, mie_droplet };

/// Which billboard textures particles have (C8): crisp as a cauliflower, or soft and wispy.
enum class BillboardSet { crisp, soft };

/// Diameters for which droplet phase functions are known (Jendersie & d'Eon 2023), um.
inline constexpr double smallest_droplet_um = 5.0, largest_droplet_um = 50.0;

/// How a cloud scatters light, and how its particles are drawn.
struct CloudLook {
  double extinction_per_m = 0.02;  ///< of density 1
  glm::dvec3 albedo{0.9999};       ///< of single scattering
  PhaseKind phase = PhaseKind::double_henyey_greenstein;
  double g = 0.85;              ///< mean cosine, of the forward lobe
  double g_back = -0.3;         ///< of the backward lobe of a double one
  double forward_share = 0.95;  ///< of a double one
  double droplet_um = 10.0;     ///< diameter, of mie_droplet
  BillboardSet billboards = BillboardSet::crisp;

  bool operator==(const CloudLook&) const = default;
};

/// Warm air that carries a cloud (C15): it rises until it is no warmer than the air around it, swings about
/// that height, cools, and sinks again. There is cloud only above the level at which its water condenses, so
/// that it forms as it rises and dissolves as it sinks.
struct CloudHeat {
  double begins_s = 0.0;
  double excess_k = 2.0;          ///< over the air around it, when it begins
  double spread = 0.3;            ///< how much that differs between its parts, 0 ... 1
  double cooling_s = 1200.0;      ///< in which the excess falls to 1 / e
  double stability_per_s = 0.01;  ///< of the air: frequency at which it swings (Brunt-Vaisala)
  double damping_per_s = 0.004;   ///< of the swings
  double condensation_m = 0.0;    ///< the level, in the cloud's axes
  double condensing_m = 100.0;    ///< how far above it its water is all condensed

  bool operator==(const CloudHeat&) const = default;
};

/// A sphere that the wind carries a cloud around (C15), in the world.
struct CloudObstacle {
  glm::dvec3 centre_m{0.0};
  double radius_m = 100.0;

  bool operator==(const CloudObstacle&) const = default;
};

/// How a cloud moves (C4, C15). Its place at any time follows from the time alone.
struct CloudMotion {
  glm::dvec3 wind_mps{0.0};      ///< at the cloud's own altitude
  double shear_per_s = 0.0;      ///< how much faster wind is, a metre higher, along itself
  double shear_lasts_s = 600.0;  ///< after which a cloud turns over instead of leaning more
  double drag = 0.0;             ///< beta of C4: how far thin parts run ahead of dense ones, s
  double sway_m = 0.0;           ///< how far eddies of its noise move its parts
  /// Places of its origin in the world along x, y, z, m, in place of its position and its drift with the
  /// wind.
  std::optional<std::array<KeyframeTrack, 3>> path = {};
  std::optional<CloudHeat> heat = {};
  std::optional<CloudObstacle> obstacle = {};

  bool operator==(const CloudMotion&) const = default;
};

/// One cloud.
struct CloudParameters {
  std::uint64_t seed = 1;
  Genus genus = Genus::cumulus;
  glm::dvec3 position_m{0.0};  ///< of the origin of its axes, in the world, at time 0
  Modelling modelling = Modelling::hierarchical;
  std::vector<Metaball> balls = {};
  /// In place of balls: density 0 ... 1 of a shape, in the cloud's axes (meshes, text, VDB files).
  std::shared_ptr<const CloudVolume> shape = {};
  /// Whether particles are merged from the cells that the shape has, in place of those of its frayed field.
  bool takes_cells_of_shape = false;
  Turbulence turbulence = {};
  Sampling sampling = Sampling::uniform;
  int target_particles = 1000;  ///< of a sampled cloud
  std::vector<HierarchyLevel> levels = {};
  /// Height below which a hierarchical cloud is pressed flat, in its axes: what would hang lower is pressed
  /// to a tenth of its depth.
  std::optional<double> base_m = {};
  /// Of its particles at rest, in their order.
  std::vector<ParticleEdit> edits = {};
  CloudLook look = {};
  CloudMotion motion = {};

  /// Shapes are equal that are the same object.
  bool operator==(const CloudParameters&) const = default;
};

/// Throws Error(bad_input) that names the first value out of range: "cloud.ball[2].radius_m".
void require_valid(const CloudParameters& parameters);

/// What light falls on clouds.
struct CloudLight {
  glm::dvec3 direction{0.0, 1.0, 0.0};  ///< unit, toward it
  glm::dvec3 illuminance_klx{0.0};      ///< of a surface that faces it, at the cloud; linear Rec.709

  bool operator==(const CloudLight&) const = default;
};

/// All light that falls on a cloud.
struct CloudIllumination {
  std::vector<CloudLight> suns;
  glm::dvec3 sky_kcdpm2{0.0};     ///< mean radiance of the upper hemisphere
  glm::dvec3 ground_kcdpm2{0.0};  ///< of the lower one
  /// What other clouds before them add to these means, or take from them (with_light_of_others()).
  glm::dvec3 clouds_above_kcdpm2{0.0}, clouds_below_kcdpm2{0.0};

  bool operator==(const CloudIllumination&) const = default;
};

/// How light goes through clouds: as Harris and the paper have it, or corrected to keep energy.
enum class LightModel { harris, calibrated };

}  // namespace offing::clouds
