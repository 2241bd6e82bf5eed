#include "host/terrain/analysis/line_of_sight.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "host/base/error.h"

namespace offing::terrain {
namespace {

// A target on the ground is not hidden by the ground that it lies on: hits are right to 1e-3 cells and 2^-23.
constexpr double slack_cells = 2e-3, slack_share = 2e-7;
constexpr const char* example = "give X,Z,H such as 1200,350,1.7";

glm::dvec3 place_of(const TerrainPosts& posts, const SightEnd& end) {
  const std::optional<TerrainPoint> ground = terrain_at(posts, end.x_m, end.z_m);
  if (!ground) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected a place within 0 ... {:g} m east and 0 ... {:g} m south of the "
                            "north-west post, found {:g}, {:g}",
                            end.name, posts.width_m(), posts.depth_m(), end.x_m, end.z_m),
                "give a place on the map");
  }
  if (!(end.height_m >= 0.0 && std::isfinite(end.height_m))) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("{}: expected a height above ground of 0 or more, found {:g} m", end.name, end.height_m),
        example);
  }
  return {end.x_m, ground->height_m + end.height_m, end.z_m};
}

}  // namespace

LineOfSight::LineOfSight(const TerrainPosts& posts, const EarthCurve& curve, const SightEnd& from,
                         const SightEnd& to)
    : from_m_(place_of(posts, from)), bend_perm_(curve.bend_perm()) {
  glm::dvec3 to_m = place_of(posts, to);
  const double plan_m = std::hypot(to_m.x - from_m_.x, to_m.z - from_m_.z);
  to_m.y -= bend_perm_ * plan_m * plan_m;
  distance_m_ = glm::length(to_m - from_m_);
  slack_m_ = slack_cells * std::max(posts.spacing_x_m, posts.spacing_z_m) + slack_share * distance_m_;
  if (distance_m_ <= 2.0 * slack_m_) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected a place away from the start of the line, found one {:g} m away",
                            to.name, distance_m_),
                example);
  }
  way_ = (to_m - from_m_) / distance_m_;
}

double LineOfSight::plan_share() const {
  return std::hypot(way_.x, way_.z);
}

Ray LineOfSight::ray() const {
  // From one slack to the other. Over its own origin the ground does not fall.
  const double start_m = slack_m_ * plan_share();
  const glm::dvec3 rise(0.0, 2.0 * bend_perm_ * start_m * plan_share(), 0.0);
  return {.origin_m = point_m(slack_m_),
          .direction = glm::normalize(way_ + rise),
          .limit_m = distance_m_ - 2.0 * slack_m_};
}

glm::dvec3 LineOfSight::point_m(double along_m) const {
  const double plan_m = along_m * plan_share();
  return from_m_ + along_m * way_ + glm::dvec3(0.0, bend_perm_ * plan_m * plan_m, 0.0);
}

}  // namespace offing::terrain
