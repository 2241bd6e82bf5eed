#include "host/highlights/search/surface_walk.h"

#include <algorithm>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "host/highlights/search/tangent_axes.h"

namespace offing::highlights {
namespace {

// Faces steeper than this are seen from the side: acos(0.17) = 80 degrees.
constexpr double least_facing = 0.17;
// Vertices that count as one may be apart by a share of the diagonal; so may the two sides of an edge.
constexpr double gap_share = 4e-6;

/// Where the line comes into a face and leaves it.
struct Crossing {
  std::uint32_t face = 0;
  double in_m = 0.0, out_m = 0.0;  ///< along the line
  glm::dvec3 in{0.0}, out{0.0};    ///< as weights of the corners
};

class Line {
 public:
  Line(const HighlightSurface& surface, const glm::dvec3& start_m, const glm::dvec3& along,
       const glm::dvec3& normal)
      : surface_(surface),
        start_m_(start_m),
        along_(along),
        across_(glm::cross(normal, along)),
        normal_(normal),
        gap_m_(gap_share * surface.diagonal_m()) {}

  /// None if the face looks away or the line passes it by. A corner on the line counts as left of it, for
  /// every face alike, so that a line through a vertex is lost between no two faces.
  std::optional<Crossing> crossing(std::uint32_t face) const {
    if (glm::dot(surface_.face_normals()[face], normal_) < least_facing) return {};
    const TriangleIndices& corners = surface_.mesh().faces[face];
    glm::dvec3 x_m, y_m;
    int left = 0;
    for (int i = 0; i < 3; ++i) {
      const glm::dvec3 way_m = surface_.mesh().positions_m[corners[static_cast<std::size_t>(i)]] - start_m_;
      x_m[i] = glm::dot(way_m, along_);
      y_m[i] = glm::dot(way_m, across_);
      left += y_m[i] >= 0.0 ? 1 : 0;
    }
    if (left == 0 || left == 3) return {};
    int apex = 0;  // alone on its side
    while ((y_m[apex] >= 0.0) != (left == 1)) ++apex;
    Crossing result{.face = face};
    const int first = (apex + 1) % 3, second = (apex + 2) % 3;
    result.in_m = cut(apex, first, x_m, y_m, result.in);
    result.out_m = cut(apex, second, x_m, y_m, result.out);
    if (result.in_m > result.out_m) {
      std::swap(result.in_m, result.out_m);
      std::swap(result.in, result.out);
    }
    return result;
  }

  /// The face that goes on from a place of the line, among those around the corners of `face`: of several, as
  /// at an edge with three faces, the one that bends least.
  std::optional<Crossing> next(std::uint32_t face, double at_m, const glm::dvec3& place_m) const {
    std::optional<Crossing> best;
    double most_alike = -2.0;
    for (const std::uint32_t corner : surface_.mesh().faces[face]) {
      for (const std::uint32_t other : surface_.links().faces_at(surface_.links().place_of(corner))) {
        if (other == face) continue;
        const double alike = glm::dot(surface_.face_normals()[other], surface_.face_normals()[face]);
        if (alike <= most_alike) continue;
        const std::optional<Crossing> found = crossing(other);
        if (!found || !goes_on(*found, at_m, place_m)) continue;
        best = found;
        most_alike = alike;
      }
    }
    return best;
  }

  static SurfacePlace place(const Crossing& crossing, double at_m) {
    const double length_m = crossing.out_m - crossing.in_m;
    const double share = std::clamp((at_m - crossing.in_m) / length_m, 0.0, 1.0);
    return {crossing.face, (1.0 - share) * crossing.in + share * crossing.out};
  }

  bool goes_on(const Crossing& found, double at_m, const glm::dvec3& place_m) const {
    if (!(found.out_m > at_m) || found.in_m > at_m + gap_m_) return false;
    return glm::distance(position_at(surface_, place(found, at_m)), place_m) <= gap_m_;
  }

 private:
  static double cut(int apex, int other, const glm::dvec3& x_m, const glm::dvec3& y_m, glm::dvec3& weights) {
    const double share = y_m[apex] / (y_m[apex] - y_m[other]);
    weights[apex] = 1.0 - share;
    weights[other] = share;
    return x_m[apex] + share * (x_m[other] - x_m[apex]);
  }

  const HighlightSurface& surface_;
  glm::dvec3 start_m_, along_, across_, normal_;
  double gap_m_;
};

/// Seen along `normal`: a straight line over the surface from a place, by `length_m` >= 0 along `along`
/// (unit, across the normal), face by face. It ends early at a border and where faces look away from the
/// normal.
SurfacePlace line_end(const HighlightSurface& surface, const SurfacePlace& from, const glm::dvec3& along,
                      const glm::dvec3& normal, double length_m) {
  const glm::dvec3 start_m = position_at(surface, from);
  const Line line(surface, start_m, along, normal);
  std::optional<Crossing> here = line.crossing(from.face);
  if (!here || !line.goes_on(*here, 0.0, start_m)) here = line.next(from.face, 0.0, start_m);
  if (!here) return from;
  while (here->out_m < length_m) {
    const SurfacePlace rim{here->face, here->out};
    const std::optional<Crossing> next = line.next(here->face, here->out_m, position_at(surface, rim));
    if (!next) return rim;
    here = next;
  }
  return Line::place(*here, length_m);
}

/// Whether a line leaves the surface through this edge of its face: no other face has both of its ends.
bool is_border(const HighlightSurface& surface, const SurfacePlace& rim) {
  const VertexLinks& links = surface.links();
  const auto has_corner = [&](std::uint32_t face, std::uint32_t place) {
    return std::ranges::any_of(surface.mesh().faces[face],
                               [&](std::uint32_t corner) { return links.place_of(corner) == place; });
  };
  std::vector<std::uint32_t> ends;
  for (int i = 0; i < 3; ++i) {
    const std::uint32_t corner = surface.mesh().faces[rim.face][static_cast<std::size_t>(i)];
    if (rim.weights[i] > 0.0) ends.push_back(links.place_of(corner));
  }
  return std::ranges::none_of(links.faces_at(ends.front()), [&](std::uint32_t face) {
    return face != rim.face && has_corner(face, ends.back());
  });
}

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

double facing_length_m(const HighlightSurface& surface, const SurfacePlace& from, const glm::dvec3& direction,
                       double least_cosine, double most_m) {
  const glm::dvec3 start_m = position_at(surface, from), normal = normal_at(surface, from);
  const glm::dvec3 flat = direction - glm::dot(direction, normal) * normal;
  if (!(glm::length(flat) > 1e-9)) return most_m;
  const Line line(surface, start_m, glm::normalize(flat), normal);
  std::optional<Crossing> here = line.crossing(from.face);
  if (!here || !line.goes_on(*here, 0.0, start_m)) here = line.next(from.face, 0.0, start_m);
  const auto cosine_at = [&](const SurfacePlace& place) {
    return glm::dot(normal_at(surface, place), normal);
  };
  double at_m = 0.0, cosine = 1.0;
  while (here && at_m < most_m) {
    const SurfacePlace rim{here->face, here->out};
    const double rim_cosine = cosine_at(rim);
    if (rim_cosine < least_cosine) {
      const double share = cosine > least_cosine ? (cosine - least_cosine) / (cosine - rim_cosine) : 0.0;
      return std::min(most_m, at_m + share * (here->out_m - at_m));
    }
    at_m = here->out_m;
    here = line.next(here->face, at_m, position_at(surface, rim));
    if (!here) return is_border(surface, rim) ? most_m : std::min(most_m, at_m);
    cosine = cosine_at({here->face, here->in});  // not that of the rim where normals have an edge
  }
  return most_m;
}

}  // namespace offing::highlights
