#pragma once

#include <array>
#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "host/base/camera.h"

namespace offing::ocean {

/// How far the waves move the surface from the mean water plane y = 0.
struct SurfaceReach {
  double horizontal_m = 0.0;  ///< largest distance of a displaced point from its label
  double vertical_m = 0.0;    ///< largest height of a crest and depth of a trough
};

/// A grid of labels on the water plane, even on the picture of a projector above it (O12 of docs/sources.md).
///
/// Lee & Lee lay the grid over the screen and clamp w where it passes the horizon. Here the projector has no
/// roll, so that w depends on the row alone, and its picture is cut to what the camera can see of a slab of
/// displaced water: every w is positive, no vertex lies behind the horizon, and no triangle is turned over.
/// For waves higher than the eye the projector stands above the eye.
///
/// Label of the picture's point (X, Y), relative to the point of the water plane below the eye:
/// (across X + along (cosine + Y sine)) height_m / (sine - Y cosine), with sine and cosine of the downward
/// pitch.
class ProjectedGrid {
 public:
  /// The grid for a camera, nothing if it sees no water. Throws what require_valid() throws, and
  /// Error(bad_input) if the reach is negative or not finite, or the eye is below the water.
  static std::optional<ProjectedGrid> for_camera(const Camera& camera, const SurfaceReach& reach);

  /// Label, in metres along world x and z from the eye, of a point of the grid: (0, 0) is its near left, (1,
  /// 1) its far right corner.
  glm::dvec2 label_m(glm::dvec2 place) const;
  /// A corner of the grid in homogeneous coordinates: its label is label_m / w.
  struct Corner {
    glm::dvec2 label_m;
    double w;
  };
  /// The corners (0, 0), (1, 0), (0, 1), (1, 1). label_m() of any place is the bilinear mean of the corners'
  /// labels over that of their w (Lee & Lee 2007, eq. 11), which is how a shader makes the grid.
  std::array<Corner, 4> corners() const;

  /// Where in the grid a label lies, by label_m(); components outside 0 ... 1 are off the grid. Nothing for
  /// labels behind the projector.
  std::optional<glm::dvec2> place_of(glm::dvec2 label_m) const;

  double projector_height_m() const { return height_m_; }

 private:
  ProjectedGrid() = default;

  Corner homogeneous(glm::dvec2 place) const;
  /// Position on the projector's picture, nothing behind it.
  std::optional<glm::dvec2> image_of(glm::dvec2 label_m) const;

  glm::dvec2 along_{0.0}, across_{0.0};  // unit vectors (x, z): horizontal line of sight, and its right
  double sine_ = 0.0, cosine_ = 0.0;     // of the downward pitch
  double height_m_ = 0.0;
  glm::dvec2 lower_{0.0}, upper_{0.0};  // corners of the cut picture
};

}  // namespace offing::ocean
