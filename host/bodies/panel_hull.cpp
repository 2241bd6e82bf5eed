#include "host/bodies/panel_hull.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "host/base/error.h"
#include "host/bodies/even_mesh.h"
#include "host/bodies/hull.h"

namespace offing::bodies {
namespace {

using Triangle = std::array<glm::dvec3, 3>;

/// What is left of a polygon where sign * coordinate <= 0. Crossings are the same from both faces of an edge.
std::vector<glm::dvec3> clipped(const std::vector<glm::dvec3>& polygon, glm::length_t axis, double sign) {
  std::vector<glm::dvec3> part;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec3 &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    const double a = sign * from[axis], b = sign * to[axis];
    if (a <= 0.0) part.push_back(from);
    if ((a <= 0.0) != (b <= 0.0)) {
      const glm::dvec3 &kept = a <= 0.0 ? from : to, &lost = a <= 0.0 ? to : from;
      glm::dvec3 crossing = kept + kept[axis] / (kept[axis] - lost[axis]) * (lost - kept);
      crossing[axis] = 0.0;
      part.push_back(crossing);
    }
  }
  return part;
}

glm::dvec3 twice_area(const Triangle& t) {
  return glm::cross(t[1] - t[0], t[2] - t[0]);
}

/// The part where y < 0, and x < 0 or z > 0 where the hull has images there, in axes from origin_m, with
/// shared vertices. Vertices nearer than near_m to a plane go there, so that no thin faces are cut off. Faces
/// in these planes bound no water.
TriangleMesh wetted(const TriangleMesh& mesh, const PanelHull& hull, double near_m) {
  std::vector<std::pair<glm::length_t, double>> planes{{1, 1.0}};
  if (hull.images.size() > 1) planes.emplace_back(2, -1.0);
  if (hull.images.size() > 2) planes.emplace_back(0, 1.0);
  TriangleMesh part;
  std::map<std::array<double, 3>, std::uint32_t> numbers;
  for (const TriangleIndices& face : mesh.faces) {
    std::vector<glm::dvec3> polygon;
    for (const std::uint32_t corner : face) {
      glm::dvec3 place = mesh.positions_m[corner] - hull.origin_m;
      for (const auto& [axis, sign] : planes) {
        if (std::abs(place[axis]) < near_m) place[axis] = 0.0;
      }
      polygon.push_back(place);
    }
    for (const auto& [axis, sign] : planes) polygon = clipped(polygon, axis, sign);
    const bool is_in_plane = std::ranges::any_of(planes, [&](const auto& plane) {
      return std::ranges::all_of(polygon, [&](const glm::dvec3& place) { return place[plane.first] == 0.0; });
    });
    if (is_in_plane) continue;
    std::vector<std::uint32_t> corners;
    for (const glm::dvec3& place : polygon) {
      // + 0 makes a zero of one sign.
      const auto [found, is_new] = numbers.try_emplace({place.x + 0.0, place.y + 0.0, place.z + 0.0},
                                                       static_cast<std::uint32_t>(part.positions_m.size()));
      if (is_new) part.positions_m.push_back(place);
      if (corners.empty() || (corners.back() != found->second && corners.front() != found->second))
        corners.push_back(found->second);
    }
    for (std::size_t i = 2; i < corners.size(); ++i)
      part.faces.push_back({corners[0], corners[i - 1], corners[i]});
  }
  return part;
}

std::vector<Triangle> triangles_of(const TriangleMesh& mesh) {
  std::vector<Triangle> triangles;
  for (const TriangleIndices& face : mesh.faces)
    triangles.push_back({mesh.positions_m[face[0]], mesh.positions_m[face[1]], mesh.positions_m[face[2]]});
  return triangles;
}

/// Whether each vertex has an image across a plane of this axis, within a thousandth of the extent along it.
bool is_symmetric(const TriangleMesh& mesh, glm::length_t axis, double middle_m, double extent_m) {
  std::vector<glm::dvec3> places = mesh.positions_m;
  const double near_m = 1e-3 * extent_m;
  const glm::length_t other = axis == 0 ? 2 : 0;
  const auto along = [other](const glm::dvec3& place) { return place[other]; };
  std::ranges::sort(places, {}, along);
  return std::ranges::all_of(mesh.positions_m, [&](const glm::dvec3& place) {
    glm::dvec3 image = place;
    image[axis] = 2.0 * middle_m - place[axis];
    auto at = std::ranges::lower_bound(places, image[other] - near_m, {}, along);
    for (; at != places.end() && along(*at) <= image[other] + near_m; ++at) {
      if (glm::distance(*at, image) <= near_m) return true;
    }
    return false;
  });
}

/// The volume below y = 0 in front of these faces: the water plane adds nothing, nor does the plane z = 0.
double volume_of(const std::vector<Triangle>& triangles) {
  double volume = 0.0;
  for (const Triangle& t : triangles) volume += glm::dot(t[0], glm::cross(t[1], t[2])) / 6.0;
  return volume;
}

/// The area of the water plane above these faces.
double plane_of(const std::vector<Triangle>& triangles) {
  double area = 0.0;
  for (const Triangle& t : triangles) area -= 0.5 * twice_area(t).y;
  return area;
}

/// About this many panels, fewer in a narrow section, at this height inside the section of the hull there,
/// their normals down. Water above them is too thin to resonate at the frequencies of the method.
void cover(const std::vector<Triangle>& triangles, double height_m, std::size_t count, double least_side_m,
           PanelHull& hull) {
  struct Segment {
    glm::dvec3 from, to;
  };
  std::vector<Segment> section;
  double low_x = 1e300, high_x = -1e300, area = 0.0;
  for (const Triangle& t : triangles) {
    std::vector<glm::dvec3> ends;
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::dvec3 &a = t[i], &b = t[(i + 1) % 3];
      if ((a.y > height_m) != (b.y > height_m)) ends.push_back(a + (height_m - a.y) / (b.y - a.y) * (b - a));
    }
    area += 0.5 * twice_area(t).y;
    if (ends.size() != 2) continue;
    section.push_back({ends[0], ends[1]});
    for (const glm::dvec3& end : ends) {
      low_x = std::min(low_x, end.x);
      high_x = std::max(high_x, end.x);
    }
  }
  if (section.empty()) return;
  // Where the section's walls stand along z at this x, in order; the plane of symmetry is one.
  const auto walls_at = [&](double x) {
    std::vector<double> walls;
    for (const Segment& s : section) {
      if ((s.from.x > x) == (s.to.x > x)) continue;
      walls.push_back(s.from.z + (x - s.from.x) / (s.to.x - s.from.x) * (s.to.z - s.from.z));
    }
    if (hull.images.size() > 1 && walls.size() % 2 != 0) walls.push_back(0.0);
    std::ranges::sort(walls);
    return walls;
  };
  const double side_m = std::max(least_side_m, std::sqrt(std::abs(area) / static_cast<double>(count)));
  const auto cells = [&](double span) { return std::max(1, static_cast<int>(std::lround(span / side_m))); };
  const int columns = cells(high_x - low_x);
  // The ends lie a little within, where walls stand.
  const double first_x = low_x + 1e-3 * side_m, dx = (high_x - low_x - 2e-3 * side_m) / columns;
  for (int column = 0; column < columns; ++column) {
    const double x0 = first_x + column * dx, x1 = x0 + dx;
    const std::vector<double> walls0 = walls_at(x0), walls1 = walls_at(x1);
    // Where a column begins or ends a part of the section, it stays open.
    if (walls0.size() != walls1.size()) continue;
    for (std::size_t wall = 0; wall + 1 < walls0.size(); wall += 2) {
      const double a0 = walls0[wall], b0 = walls0[wall + 1], a1 = walls1[wall], b1 = walls1[wall + 1];
      const int rows = cells(0.5 * (b0 - a0 + b1 - a1));
      for (int row = 0; row < rows; ++row) {
        const double low = static_cast<double>(row) / rows, high = static_cast<double>(row + 1) / rows;
        Panel panel;
        panel.corners_m = {glm::dvec3(x0, height_m, std::lerp(a0, b0, low)),
                           glm::dvec3(x1, height_m, std::lerp(a1, b1, low)),
                           glm::dvec3(x1, height_m, std::lerp(a1, b1, high)),
                           glm::dvec3(x0, height_m, std::lerp(a0, b0, high))};
        panel.corner_count = 4;
        const auto& c = panel.corners_m;
        const double one = 0.5 * glm::length(twice_area({c[0], c[1], c[2]}));
        const double other = 0.5 * glm::length(twice_area({c[0], c[2], c[3]}));
        panel.area_m2 = one + other;
        if (!(panel.area_m2 > 1e-3 * side_m * side_m)) continue;
        panel.centre_m = (one * (c[0] + c[1] + c[2]) + other * (c[0] + c[2] + c[3])) / (3.0 * panel.area_m2);
        panel.normal = {0.0, -1.0, 0.0};
        hull.panels.push_back(panel);
      }
    }
  }
}

/// Whether a place is above or below a triangle, nearer than thin_m.
bool is_close_to(const glm::dvec3& place, const Panel& panel, double thin_m) {
  if (std::abs(glm::dot(place - panel.centre_m, panel.normal)) > thin_m) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 &from = panel.corners_m[i], &to = panel.corners_m[(i + 1) % 3];
    if (glm::dot(glm::cross(to - from, place - from), panel.normal) < 0.0) return false;
  }
  return true;
}

/// Takes away the panels of both sides of a blade, such as a coarse mesh makes of a stem, and copies: sources
/// on both sides of a blade would be any that cancel each other.
void remove_blades(std::vector<Panel>& panels) {
  constexpr double thin = 0.05;  // of a panel's size
  std::vector<bool> is_removed(panels.size());
  for (std::size_t i = 0; i < panels.size(); ++i) {
    for (std::size_t j = 0; j < panels.size() && !is_removed[i]; ++j) {
      const double turn = glm::dot(panels[i].normal, panels[j].normal);
      const bool is_copied = turn > 0.9 && j < i, is_opposite = turn < -0.9;
      is_removed[i] = (is_copied || is_opposite) &&
                      is_close_to(panels[i].centre_m, panels[j], thin * std::sqrt(panels[j].area_m2));
    }
  }
  std::size_t at = 0;
  std::erase_if(panels, [&](const Panel&) { return is_removed[at++]; });
}

}  // namespace

PanelHull panel_hull(const TriangleMesh& mesh, double level_m, std::size_t panels) {
  const Extent extent = extent_of(mesh);
  const glm::dvec3 span = extent.high_m - extent.low_m, middle = 0.5 * (extent.low_m + extent.high_m);
  PanelHull hull;
  hull.images = {{1.0, 1.0, 1.0}};
  if (is_symmetric(mesh, 2, middle.z, span.z)) {
    hull.images.push_back({1.0, 1.0, -1.0});
    if (is_symmetric(mesh, 0, middle.x, span.x)) {
      hull.images.push_back({-1.0, 1.0, 1.0});
      hull.images.push_back({-1.0, 1.0, -1.0});
    }
  }
  hull.origin_m = {middle.x, level_m, middle.z};
  const double share = 1.0 / std::sqrt(static_cast<double>(hull.images.size()));
  const auto count = static_cast<std::size_t>(std::ceil(share * static_cast<double>(panels)));
  const double near_m =
      std::min(1e-4 * std::cbrt(span.x * span.y * span.z), 0.01 * (level_m - extent.low_m.y));
  const TriangleMesh whole = wetted(mesh, hull, near_m);
  const std::vector<Triangle> fine = triangles_of(whole);
  const double volume_m3 = volume_of(fine);
  if (fine.empty() || !(volume_m3 > 0.0)) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("panels of a hull: expected a part of it below its water line, found none below {:.4g} m",
                    level_m),
        "give it a draught above 0");
  }
  std::vector<Triangle> triangles = triangles_of(even_mesh(whole, count));
  // The water plane and the volume of the given hull: they bear it up in long waves.
  const double plane_m2 = plane_of(triangles), planes = plane_m2 > 0.0 ? plane_of(fine) / plane_m2 : 1.0;
  const double volumes = volume_m3 / volume_of(triangles);
  double mean_m2 = 0.0;
  glm::dvec3 low(1e300), high(-1e300);
  for (Triangle& triangle : triangles) {
    for (glm::dvec3& corner : triangle) {
      corner *= glm::dvec3(std::sqrt(planes), volumes / planes, std::sqrt(planes));
      for (const glm::dvec3& image : hull.images) {
        low = glm::min(low, image * corner);
        high = glm::max(high, image * corner);
      }
    }
    mean_m2 += 0.5 * glm::length(twice_area(triangle)) / static_cast<double>(triangles.size());
  }
  for (const Triangle& t : triangles) {
    Panel panel;
    std::ranges::copy(t, panel.corners_m.begin());
    panel.corners_m[3] = t[2];
    panel.centre_m = (t[0] + t[1] + t[2]) / 3.0;
    const glm::dvec3 twice = twice_area(t);
    panel.area_m2 = 0.5 * glm::length(twice);
    if (!(panel.area_m2 > 1e-3 * mean_m2)) continue;
    panel.normal = twice / glm::length(twice);
    hull.panels.push_back(panel);
  }
  remove_blades(hull.panels);
  hull.wetted_count = hull.panels.size();
  const double breadth_m = high.z - low.z, side_m = std::sqrt(4.0 / std::sqrt(3.0) * mean_m2);
  hull.length_m = std::sqrt((high.x - low.x) * breadth_m);
  // The water above the cover resonates from omega^2 / g = kappa coth(kappa d) on, at least 1 / d. The
  // centres of panels at the water line lie 0.3 sides or more below it: the cover's edge, where the velocity
  // is singular, must not come near them.
  const double depth_m = std::min({0.04 * std::min(high.x - low.x, breadth_m), -0.2 * low.y, 0.1 * side_m});
  cover(triangles, -depth_m, count / 6 + 1, 0.8 * side_m, hull);
  return hull;
}

}  // namespace offing::bodies
