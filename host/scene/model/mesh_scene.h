#pragma once

#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "host/world/mesh_parameters.h"

namespace offing::scene {

/// Whether a light is infinitely far away, or stands at a place.
enum class LightKind { direction, place };

/// A light beside the sun.
struct LightScene {
  std::string name;
  LightKind kind = LightKind::direction;
  double azimuth_rad = 0.0;  ///< clockwise from north (-z): where a light of a direction stands
  double elevation_rad = std::numbers::pi / 4.0;  ///< above the horizon
  glm::dvec3 place_m{0.0, 10.0, 0.0};
  glm::dvec3 colour{1.0};
  double illuminance_klx = 50.0;
};

/// What is drawn of the highlights of a mesh that fit, and which do.
struct HighlightScene {
  highlights::HighlightRule rule;  ///< light and picture are those of the names below
  std::string light;               ///< of a [[light]], or "sun"; empty: any
  std::string picture;             ///< file of HighlightTexture::image or normal_map
};

enum class MeshHighlights { off, on };
/// Whether the animation of a mesh begins again at its end.
enum class AnimationRepeats { off, on };

/// A mesh of a scene: a file's or, without one, a shape.
struct MeshScene {
  std::string name;
  std::string file;
  std::string animation;  ///< of a file that has several; empty: all of them
  AnimationRepeats repeats = AnimationRepeats::off;
  double sequence_frames_per_s = 24.0;  ///< of a file that is a sequence of meshes
  std::size_t shape = 0;                ///< index of mesh_shapes::shapes()
  double size_m = 1.0;
  int detail = 2;
  double scale = 1.0;
  glm::dvec3 position_m{0.0};
  double yaw_rad = 0.0, pitch_rad = 0.0, roll_rad = 0.0;
  double spin_radps = 0.0;
  std::string aboard;            ///< name of the [[body]] that carries it; empty: it stands in the world
  world::MeshMaterial material;  ///< its ramp is that of the name below
  std::string cartoon_ramp;      ///< file; empty: equal steps
  int smoothing_rounds = 0;
  double threshold = 0.95;
  std::optional<double> cap_radius_m;
  highlights::FlatLimit flat_limit = highlights::FlatLimit::surface;  ///< without cap_radius_m
  MeshHighlights shown = MeshHighlights::on;
  std::vector<HighlightScene> highlights;
};

}  // namespace offing::scene
