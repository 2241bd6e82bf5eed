#pragma once

#include <string_view>

#include <glm/vec3.hpp>

#include "host/terrain/analysis/earth_curve.h"
#include "host/terrain/cast/ray.h"
#include "host/terrain/field/terrain_posts.h"

namespace offing::terrain {

/// An end of a line of sight.
struct SightEnd {
  std::string_view name;  ///< for messages
  double x_m = 0.0, z_m = 0.0;
  double height_m = 0.0;  ///< above the ground, 0 or more
};

/// A line from an eye to a target, over ground that falls away from the eye on by a curve. Ground that it
/// touches within 2e-3 cells and 2e-7 of its length from an end hides nothing, so that both ends may lie on
/// the ground: rays hit as exactly as that.
class LineOfSight {
 public:
  /// Throws Error(bad_input) that names the end: beyond the map, below ground, too near to the other one.
  LineOfSight(const TerrainPosts& posts, const EarthCurve& curve, const SightEnd& from, const SightEnd& to);

  double distance_m() const { return distance_m_; }
  /// The target is hidden if this ray hits, over ground that falls away by the same curve.
  Ray ray() const;
  /// From the eye to where the ray hit, with the decimals that the hit has.
  double hidden_at_m(const RayHit& hit) const { return hit.rounded_m(slack_m_ + hit.distance_m); }
  /// Where the line is after some metres, as the map has heights.
  glm::dvec3 point_m(double along_m) const;

 private:
  /// How far a metre of the way comes in plan.
  double plan_share() const;

  glm::dvec3 from_m_, way_;
  double distance_m_, slack_m_, bend_perm_;
};

}  // namespace offing::terrain
