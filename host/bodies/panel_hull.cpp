#include "host/bodies/panel_hull.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <queue>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include "host/base/error.h"
#include "host/bodies/hull.h"

namespace offing::bodies {
namespace {

using Triangle = std::array<glm::dvec3, 3>;

/// Appends what is left of a polygon where sign * coordinate <= 0.
std::vector<glm::dvec3> clipped(const std::vector<glm::dvec3>& polygon, glm::length_t axis, double sign) {
  std::vector<glm::dvec3> part;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec3 &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    const double a = sign * from[axis], b = sign * to[axis];
    if (a <= 0.0) part.push_back(from);
    if ((a <= 0.0) != (b <= 0.0)) {
      glm::dvec3 crossing = from + a / (a - b) * (to - from);
      crossing[axis] = 0.0;
      part.push_back(crossing);
    }
  }
  return part;
}

glm::dvec3 twice_area(const Triangle& t) {
  return glm::cross(t[1] - t[0], t[2] - t[0]);
}

/// The triangles below y = 0, of the half z >= 0 if asked, in axes from origin_m. Faces in the plane of
/// symmetry or of the water bound no water.
std::vector<Triangle> wetted(const TriangleMesh& mesh, const glm::dvec3& origin_m, bool half) {
  std::vector<Triangle> triangles;
  for (const TriangleIndices& face : mesh.faces) {
    std::vector<glm::dvec3> polygon;
    for (const std::uint32_t corner : face) polygon.push_back(mesh.positions_m[corner] - origin_m);
    polygon = clipped(polygon, 1, 1.0);
    if (half) polygon = clipped(polygon, 2, -1.0);
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      const Triangle triangle{polygon[0], polygon[i - 1], polygon[i]};
      const double longest =
          std::max({glm::distance(triangle[0], triangle[1]), glm::distance(triangle[1], triangle[2]),
                    glm::distance(triangle[2], triangle[0])});
      const bool is_flat = !(glm::length(twice_area(triangle)) > 1e-6 * longest * longest);
      const bool is_on_water = triangle[0].y + triangle[1].y + triangle[2].y > -1e-9 * longest;
      if (!is_flat && !is_on_water) triangles.push_back(triangle);
    }
  }
  return triangles;
}

/// Whether each vertex has an image in the plane z = middle, within a thousandth of the breadth.
bool is_symmetric(const TriangleMesh& mesh, double middle_m, double breadth_m) {
  std::vector<glm::dvec3> places = mesh.positions_m;
  const double near_m = 1e-3 * breadth_m;
  std::ranges::sort(places, {}, [](const glm::dvec3& place) { return place.x; });
  return std::ranges::all_of(mesh.positions_m, [&](const glm::dvec3& place) {
    const glm::dvec3 image(place.x, place.y, 2.0 * middle_m - place.z);
    auto at = std::ranges::lower_bound(places, place.x - near_m, {}, [](const glm::dvec3& p) { return p.x; });
    for (; at != places.end() && at->x <= place.x + near_m; ++at) {
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

std::size_t longest_edge(const Triangle& t) {
  std::size_t longest = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (glm::distance(t[i], t[(i + 1) % 3]) > glm::distance(t[longest], t[(longest + 1) % 3])) longest = i;
  }
  return longest;
}

/// Vertices of a cell become the one of them next to their mean, those on the water line and on the plane of
/// symmetry apart, so that these stay (after Rossignac & Borrel 1993). The cells fit a hull of these sides:
/// `along` of them along a side as long as the geometric mean.
std::vector<Triangle> clustered(const std::vector<Triangle>& triangles, const glm::dvec3& span_m, int along) {
  struct Cluster {
    glm::dvec3 sum{0.0};
    double count = 0.0;
    glm::dvec3 kept{0.0};
    double off_m = 1e300;
  };
  // Between cells that are cubes and cells in proportion to the hull.
  const double mean_m = std::cbrt(span_m.x * span_m.y * span_m.z);
  const glm::dvec3 cell_m = glm::sqrt(span_m * mean_m) / static_cast<double>(along);
  const auto key = [&](const glm::dvec3& place) {
    const glm::dvec3 at = glm::floor(place / cell_m + 0.25);
    return std::array<int, 5>{static_cast<int>(at.x), static_cast<int>(at.y), static_cast<int>(at.z),
                              place.y == 0.0 ? 1 : 0, place.z == 0.0 ? 1 : 0};
  };
  std::map<std::array<int, 5>, Cluster> clusters;
  for (const Triangle& t : triangles) {
    for (const glm::dvec3& place : t) {
      Cluster& cluster = clusters[key(place)];
      cluster.sum += place;
      cluster.count += 1.0;
    }
  }
  for (const Triangle& t : triangles) {
    for (const glm::dvec3& place : t) {
      Cluster& cluster = clusters[key(place)];
      const double off_m = glm::distance(place, cluster.sum / cluster.count);
      if (off_m < cluster.off_m) {
        cluster.off_m = off_m;
        cluster.kept = place;
      }
    }
  }
  std::vector<Triangle> result;
  for (const Triangle& t : triangles) {
    const std::array<std::array<int, 5>, 3> keys{key(t[0]), key(t[1]), key(t[2])};
    if (keys[0] == keys[1] || keys[1] == keys[2] || keys[2] == keys[0]) continue;
    const Triangle kept{clusters[keys[0]].kept, clusters[keys[1]].kept, clusters[keys[2]].kept};
    const bool is_on_water = kept[0].y == 0.0 && kept[1].y == 0.0 && kept[2].y == 0.0;
    const bool is_on_middle = kept[0].z == 0.0 && kept[1].z == 0.0 && kept[2].z == 0.0;
    const double longest = std::max(
        {glm::distance(kept[0], kept[1]), glm::distance(kept[1], kept[2]), glm::distance(kept[2], kept[0])});
    if (!is_on_water && !is_on_middle && glm::length(twice_area(kept)) > 1e-6 * longest * longest)
      result.push_back(kept);
  }
  return result;
}

/// Halves triangles across their longest edges, those of the longest edge first.
std::vector<Triangle> halved(const std::vector<Triangle>& triangles, std::size_t count) {
  struct Piece {
    double length_m;
    Triangle triangle;
    bool operator<(const Piece& other) const { return length_m < other.length_m; }
  };
  const auto piece = [](const Triangle& t) {
    const std::size_t at = longest_edge(t);
    return Piece{glm::distance(t[at], t[(at + 1) % 3]), t};
  };
  std::priority_queue<Piece> pieces;
  for (const Triangle& t : triangles) pieces.push(piece(t));
  while (pieces.size() < count) {
    const Triangle t = pieces.top().triangle;
    pieces.pop();
    const std::size_t at = longest_edge(t);
    const glm::dvec3 &a = t[at], &b = t[(at + 1) % 3], &c = t[(at + 2) % 3], middle = 0.5 * (a + b);
    pieces.push(piece({a, middle, c}));
    pieces.push(piece({middle, b, c}));
  }
  std::vector<Triangle> result;
  for (; !pieces.empty(); pieces.pop()) result.push_back(pieces.top().triangle);
  return result;
}

/// About this many panels at this height inside the section of the hull there, their normals down. Water
/// above them is too thin to resonate at the frequencies of the method.
void cover(const std::vector<Triangle>& triangles, double height_m, std::size_t count, PanelHull& hull) {
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
    if (hull.is_mirrored && walls.size() % 2 != 0) walls.push_back(0.0);
    std::ranges::sort(walls);
    return walls;
  };
  const double side_m = std::sqrt(std::abs(area) / static_cast<double>(count));
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

}  // namespace

PanelHull panel_hull(const TriangleMesh& mesh, double level_m, std::size_t most_panels) {
  const Extent extent = extent_of(mesh);
  const double middle_m = 0.5 * (extent.low_m.z + extent.high_m.z);
  PanelHull hull;
  hull.is_mirrored = is_symmetric(mesh, middle_m, extent.high_m.z - extent.low_m.z);
  hull.origin_m = {0.5 * (extent.low_m.x + extent.high_m.x), level_m, middle_m};
  const std::size_t count = hull.is_mirrored ? (most_panels + 1) / 2 : most_panels;
  std::vector<Triangle> triangles = wetted(mesh, hull.origin_m, hull.is_mirrored);
  const double volume_m3 = volume_of(triangles);
  if (triangles.empty() || !(volume_m3 > 0.0)) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("panels of a hull: expected a part of it below its water line, found none below {:.4g} m",
                    level_m),
        "give it a draught above 0");
  }
  if (triangles.size() > count) {
    const std::vector<Triangle> whole = triangles;
    const glm::dvec3 span = extent.high_m - extent.low_m;
    for (int cells = 64; cells > 3 && triangles.size() > count; --cells)
      triangles = clustered(whole, span, cells);
    // The water plane and the volume of the finer hull: they bear it up in long waves.
    const double plane_m2 = plane_of(triangles), planes = plane_m2 > 0.0 ? plane_of(whole) / plane_m2 : 1.0;
    const double volumes = volume_m3 / volume_of(triangles);
    for (Triangle& triangle : triangles) {
      for (glm::dvec3& corner : triangle)
        corner *= glm::dvec3(std::sqrt(planes), volumes / planes, std::sqrt(planes));
    }
  }
  triangles = halved(triangles, count);
  glm::dvec3 low(1e300), high(-1e300);
  for (const Triangle& t : triangles) {
    Panel panel;
    std::ranges::copy(t, panel.corners_m.begin());
    panel.corners_m[3] = t[2];
    panel.centre_m = (t[0] + t[1] + t[2]) / 3.0;
    const glm::dvec3 twice = twice_area(t);
    panel.area_m2 = 0.5 * glm::length(twice);
    panel.normal = twice / glm::length(twice);
    hull.panels.push_back(panel);
    for (const glm::dvec3& corner : t) {
      low = glm::min(low, corner);
      high = glm::max(high, corner);
    }
  }
  hull.wetted_count = hull.panels.size();
  const double breadth_m = hull.is_mirrored ? 2.0 * high.z : high.z - low.z;
  hull.length_m = std::sqrt((high.x - low.x) * breadth_m);
  // The water above the cover resonates from omega^2 / g = kappa coth(kappa d) on, at least 1 / d.
  const double depth_m = std::min(0.04 * std::min(high.x - low.x, breadth_m), -0.2 * low.y);
  cover(triangles, -depth_m, count / 6 + 1, hull);
  return hull;
}

}  // namespace offing::bodies
