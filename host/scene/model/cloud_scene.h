#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "host/clouds/shape/cloud_parameters.h"

namespace offing::scene {

/// Which axis of a file points up.
enum class CloudUp { y, z };

/// What the shape of a cloud is made of, in place of balls; the first one that is given counts.
struct CloudShapeScene {
  std::string file;              ///< .vdb or, of particles, .ply
  std::string grid = "density";  ///< of a .vdb
  CloudUp up = CloudUp::y;       ///< of a file
  std::string mesh;              ///< a closed one
  std::string text;
  std::optional<std::size_t> solid;                       ///< index of mesh_shapes::closed_shapes()
  double yaw_rad = 0.0, pitch_rad = 0.0, roll_rad = 0.0;  ///< how it is turned
  double size_m = 500.0;                                  ///< height of a text; longest edge of a mesh
  double depth_m = 150.0;                                 ///< of a text, from front to back
  double thickness_m = 40.0;  ///< how deep below the surface of a mesh or a text its density has risen to 1
  double fluff_m = 15.0;      ///< how far beyond that surface it begins

  bool is_given() const { return !file.empty() || !mesh.empty() || !text.empty() || solid; }
  bool operator==(const CloudShapeScene&) const = default;
};

/// A noise and its blend; what is absent is as the genus has it.
struct CloudNoiseScene {
  std::optional<double> wavelength_m, lacunarity, gain, strength, blend, wisp, edge, change_per_s;
  int octaves = 0;  ///< 0: absent

  bool operator==(const CloudNoiseScene&) const = default;
};

/// How a cloud scatters light; what is absent is as the genus has it.
struct CloudLookScene {
  std::optional<double> extinction_per_m;
  std::optional<glm::dvec3> albedo;
  std::optional<clouds::PhaseKind> phase;
  std::optional<clouds::BillboardSet> billboards;
  std::optional<double> g, g_back, forward_share, droplet_um;

  bool operator==(const CloudLookScene&) const = default;
};

/// Whether a cloud, or the clouds of a layer, are shown and cast shadows.
enum class CloudVisibility { off, on };

/// How a cloud moves; what is absent is as the genus has it.
struct CloudMotionScene {
  std::optional<glm::dvec3> wind_mps;
  std::optional<double> shear_per_s, drag_s, sway_m;
  /// Warm air that carries it: where there is any, all of clouds::CloudHeat.
  std::optional<double> heat_k;
  clouds::CloudHeat heat = {};
  std::optional<glm::dvec3> obstacle_m;
  double obstacle_radius_m = 100.0;
};

/// A cloud of a scene. What is absent is as its genus has it.
struct CloudScene {
  std::string name;
  CloudVisibility visible = CloudVisibility::on;
  clouds::Genus genus = clouds::Genus::cumulus;
  glm::dvec3 position_m{0.0};  ///< of which y counts only where it is given
  std::optional<double> altitude_m;
  std::uint64_t seed = 1;
  double scale = 1.0;
  std::optional<clouds::Modelling> modelling;
  std::optional<clouds::Sampling> sampling;
  int target_particles = 0;  ///< 0: as its genus
  std::optional<double> base_m;
  CloudShapeScene shape;
  CloudNoiseScene noise;
  CloudLookScene look;
  CloudMotionScene motion;
  std::vector<clouds::Metaball> balls;         ///< empty: those of its genus
  std::vector<clouds::HierarchyLevel> levels;  ///< empty: those of its genus
  std::vector<clouds::ParticleEdit> edits;     ///< of its particles, before its scale
};

/// Many clouds of a genus at an altitude.
struct CloudLayerScene {
  CloudVisibility visible = CloudVisibility::on;
  clouds::Genus genus = clouds::Genus::cumulus;
  double coverage = 0.3;             ///< share of the sky, 0 ... 0.95
  double extent_m = 10'000.0;        ///< edge of the square that it covers
  double x_m = 0.0, z_m = 0.0;       ///< its middle
  std::optional<double> altitude_m;  ///< of the clouds' bases
  std::uint64_t seed = 1;
};

/// Whether clouds throw shadows on ground, sea and meshes.
enum class CloudShadows { off, on };

/// All clouds of a scene, and how they are lit.
struct CloudsScene {
  clouds::LightModel light = clouds::LightModel::calibrated;
  std::uint64_t seed = 1;
  CloudShadows shadows = CloudShadows::on;
  double quality = 1.0;       ///< particles, in those that clouds ask for
  double light_step_s = 0.5;  ///< of CloudSkyParameters
  /// Folders of pictures for the two sets of billboard textures; empty: Offing's own.
  std::string crisp_billboards, soft_billboards;
};

}  // namespace offing::scene
