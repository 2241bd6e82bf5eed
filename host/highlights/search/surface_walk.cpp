#include "host/highlights/search/surface_walk.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "host/highlights/search/surface_line.h"
#include "host/highlights/search/tangent_axes.h"

namespace offing::highlights {
namespace {

// As many for every length: a number that grew with it would jump.
constexpr int steps = 16;
// Each round of a step shrinks its error by about the turn of the normal within it.
constexpr int most_rounds = 24;
constexpr double settled_share = 1e-12;  // of the diagonal

struct Walker {
  SurfacePlace place;
  glm::dvec3 position_m, normal, heading;
};

/// A vector across one unit normal, turned with it to another by the shortest way.
glm::dvec3 carried(const glm::dvec3& v, const glm::dvec3& from, const glm::dvec3& to) {
  return v - glm::dot(v, to) / (1.0 + glm::dot(from, to)) * (from + to);
}

/// A straight line seen along the mean of the normals at its two ends, in the mean of the headings there: the
/// same line from both ends. The far end is found by repetition.
Walker stepped(const HighlightSurface& surface, const Walker& start, double length_m) {
  Walker end = start;
  glm::dvec3 normal = start.normal, heading = start.heading;
  for (int round = 0; round < most_rounds; ++round) {
    const glm::dvec3 before_m = end.position_m;
    end.place = line_end(surface, start.place, heading, normal, length_m);
    end.position_m = position_at(surface, end.place);
    end.normal = normal_at(surface, end.place);
    if (!(glm::dot(start.normal, end.normal) > 0.0)) return start;  // folded over: no step leads on
    end.heading = carried(start.heading, start.normal, end.normal);
    normal = glm::normalize(start.normal + end.normal);
    heading = glm::normalize(start.heading + end.heading);
    if (glm::distance(before_m, end.position_m) <= settled_share * surface.diagonal_m()) break;
  }
  return end;
}

glm::dmat3 axes_of(const Walker& walker) {
  return {walker.heading, glm::cross(walker.normal, walker.heading), walker.normal};
}

}  // namespace

SurfaceWalk walk_over(const HighlightSurface& surface, const SurfacePlace& from, const glm::dvec3& direction,
                      double length_m) {
  Walker walker{.place = from,
                .position_m = position_at(surface, from),
                .normal = normal_at(surface, from),
                .heading = {}};
  const glm::dvec3 flat = direction - glm::dot(direction, walker.normal) * walker.normal;
  const double flat_length = glm::length(flat);
  walker.heading = flat_length > 1e-9 ? flat / flat_length : tangent_axes(walker.normal).right;
  const Walker start = walker;
  for (int step = 0; step < steps; ++step) walker = stepped(surface, walker, length_m / steps);
  return {walker.place, walker.position_m - start.position_m,
          axes_of(walker) * glm::transpose(axes_of(start))};
}

}  // namespace offing::highlights
