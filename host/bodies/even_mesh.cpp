#include "host/bodies/even_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace offing::bodies {
namespace {

using Vertex = std::uint32_t;
using Edge = std::pair<Vertex, Vertex>;  // the lower index first
using EdgeFaces = std::map<Edge, std::vector<std::uint32_t>>;

Edge edge_of(Vertex a, Vertex b) {
  return {std::min(a, b), std::max(a, b)};
}

glm::dvec3 twice_area(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return glm::cross(b - a, c - a);
}

glm::dvec3 nearest_on(const std::array<glm::dvec3, 2>& segment, const glm::dvec3& place) {
  const glm::dvec3 along = segment[1] - segment[0];
  const double length2 = glm::dot(along, along);
  const double share =
      length2 > 0.0 ? std::clamp(glm::dot(place - segment[0], along) / length2, 0.0, 1.0) : 0.0;
  return segment[0] + share * along;
}

glm::dvec3 nearest_on(const std::array<glm::dvec3, 3>& t, const glm::dvec3& place) {
  const glm::dvec3 normal = twice_area(t[0], t[1], t[2]);
  const double size2 = glm::dot(normal, normal);
  double longest2 = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
    longest2 = std::max(longest2, glm::dot(t[(i + 1) % 3] - t[i], t[(i + 1) % 3] - t[i]));
  // A flat one is its edges.
  bool is_inside = size2 > 1e-16 * longest2 * longest2;
  for (std::size_t i = 0; is_inside && i < 3; ++i)
    is_inside = glm::dot(twice_area(t[i], t[(i + 1) % 3], place), normal) >= 0.0;
  if (is_inside) return place - glm::dot(place - t[0], normal) / size2 * normal;
  glm::dvec3 nearest = t[0];
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 other = nearest_on(std::array{t[i], t[(i + 1) % 3]}, place);
    if (glm::distance(place, other) < glm::distance(place, nearest)) nearest = other;
  }
  return nearest;
}

/// Triangles or segments to find the nearest place on.
template <std::size_t corner_count>
class Reference {
 public:
  void add(const std::array<glm::dvec3, corner_count>& piece) {
    glm::dvec3 centre(0.0);
    for (const glm::dvec3& corner : piece) centre += corner / static_cast<double>(corner_count);
    double radius = 0.0;
    for (const glm::dvec3& corner : piece) radius = std::max(radius, glm::distance(corner, centre));
    pieces_.push_back({piece, centre, radius});
  }

  glm::dvec3 nearest(const glm::dvec3& place) const {
    glm::dvec3 found = place;
    double least = std::numeric_limits<double>::infinity();
    for (const Piece& piece : pieces_) {
      const glm::dvec3 off = place - piece.centre;
      const double reach = least + piece.radius;
      if (glm::dot(off, off) >= reach * reach) continue;
      const glm::dvec3 other = nearest_on(piece.corners, place);
      if (const double distance = glm::distance(other, place); distance < least) {
        least = distance;
        found = other;
      }
    }
    return found;
  }

 private:
  struct Piece {
    std::array<glm::dvec3, corner_count> corners;
    glm::dvec3 centre;
    double radius;
  };
  std::vector<Piece> pieces_;
};

class Remesher {
 public:
  Remesher(const TriangleMesh& surface, double cos_crease)
      : places_(surface.positions_m), faces_(surface.faces), is_fixed_(places_.size(), false) {
    for (const TriangleIndices& face : faces_) surface_.add(places_of(face));
    std::vector<std::vector<Vertex>> ends(places_.size());
    for (const auto& [edge, faces] : edges()) {
      if (faces.size() == 2) {
        const glm::dvec3 a = normal(faces[0]), b = normal(faces[1]);
        const double sizes = glm::length(a) * glm::length(b);
        if (!(sizes > 0.0) || glm::dot(a, b) > cos_crease * sizes) continue;
      }
      features_.insert(edge);
      ends[edge.first].push_back(edge.second);
      ends[edge.second].push_back(edge.first);
      lines_[line_of(edge)].add({places_[edge.first], places_[edge.second]});
    }
    for (Vertex v = 0; v < places_.size(); ++v) {
      if (ends[v].empty()) continue;
      is_fixed_[v] =
          ends[v].size() != 2 || line_of(edge_of(v, ends[v][0])) != line_of(edge_of(v, ends[v][1]));
      if (is_fixed_[v]) continue;
      const glm::dvec3 a = places_[v] - places_[ends[v][0]], b = places_[ends[v][1]] - places_[v];
      is_fixed_[v] = glm::dot(a, b) < cos_crease * glm::length(a) * glm::length(b);
    }
  }

  /// Splits no more when there are most_faces: on a surface much rougher than faces edges can grow each time.
  void make_even(double length, std::size_t most_faces) {
    split(4.0 / 3.0 * length, most_faces);
    collapse(0.8 * length, 4.0 / 3.0 * length);
    flip();
    relax();
  }

  std::size_t count() const { return faces_.size(); }
  double area() const {
    double sum = 0.0;
    for (std::uint32_t face = 0; face < faces_.size(); ++face) sum += 0.5 * glm::length(normal(face));
    return sum;
  }

  TriangleMesh mesh() const {
    TriangleMesh made;
    std::vector<Vertex> number(places_.size(), none);
    for (TriangleIndices face : faces_) {
      for (Vertex& v : face) {
        if (number[v] == none) {
          number[v] = static_cast<Vertex>(made.positions_m.size());
          made.positions_m.push_back(places_[v]);
        }
        v = number[v];
      }
      made.faces.push_back(face);
    }
    return made;
  }

 private:
  static constexpr Vertex none = std::numeric_limits<Vertex>::max();
  static constexpr int most_rounds = 40;

  EdgeFaces edges() const {
    EdgeFaces made;
    for (std::uint32_t face = 0; face < faces_.size(); ++face) {
      for (std::size_t i = 0; i < 3; ++i)
        made[edge_of(faces_[face][i], faces_[face][(i + 1) % 3])].push_back(face);
    }
    return made;
  }

  double length(const Edge& edge) const { return glm::distance(places_[edge.first], places_[edge.second]); }
  glm::dvec3 normal(const TriangleIndices& face) const {
    return twice_area(places_[face[0]], places_[face[1]], places_[face[2]]);
  }
  glm::dvec3 normal(std::uint32_t face) const { return normal(faces_[face]); }

  /// Lines in the planes x = 0, y = 0 and z = 0 stay there, apart from each other and from all else.
  std::size_t line_of(const Edge& edge) const {
    const glm::dvec3 &a = places_[edge.first], &b = places_[edge.second];
    for (const glm::length_t axis : {1, 2, 0}) {
      if (a[axis] == 0.0 && b[axis] == 0.0) return static_cast<std::size_t>(axis) + 1;
    }
    return 0;
  }

  /// Edges by length, those that `choose` chooses.
  template <typename Choose>
  std::vector<Edge> sorted(const EdgeFaces& edges, const Choose& choose) const {
    std::vector<std::pair<double, Edge>> found;
    for (const auto& [edge, faces] : edges) {
      if (const double size = length(edge); choose(size)) found.emplace_back(size, edge);
    }
    std::ranges::sort(found);
    std::vector<Edge> result;
    for (const auto& [size, edge] : found) result.push_back(edge);
    return result;
  }

  void split(double most, std::size_t most_faces) {
    for (int round = 0; round < most_rounds && faces_.size() < most_faces; ++round) {
      const EdgeFaces around = edges();
      std::vector<Edge> longest = sorted(around, [&](double size) { return size > most; });
      if (longest.empty()) return;
      std::vector<bool> is_touched(faces_.size(), false);
      for (auto edge = longest.rbegin(); edge != longest.rend(); ++edge) {
        const std::vector<std::uint32_t>& faces = around.at(*edge);
        if (std::ranges::any_of(faces, [&](std::uint32_t face) { return is_touched[face]; })) continue;
        const auto [a, b] = *edge;
        const auto middle = static_cast<Vertex>(places_.size());
        places_.push_back(0.5 * (places_[a] + places_[b]));
        is_fixed_.push_back(false);
        if (features_.erase(*edge) > 0) {
          features_.insert(edge_of(a, middle));
          features_.insert(edge_of(b, middle));
        }
        for (const std::uint32_t face : faces) {
          is_touched[face] = true;
          TriangleIndices other = faces_[face];
          std::ranges::replace(other, a, middle);
          std::ranges::replace(faces_[face], b, middle);
          faces_.push_back(other);
        }
      }
    }
  }

  void collapse(double least, double most) {
    for (int round = 0; round < most_rounds; ++round) {
      const EdgeFaces around = edges();
      std::vector<std::vector<std::uint32_t>> fans(places_.size());
      for (std::uint32_t face = 0; face < faces_.size(); ++face) {
        for (const Vertex v : faces_[face]) fans[v].push_back(face);
      }
      std::vector<bool> is_bound(places_.size(), false), is_touched(faces_.size(), false);
      std::vector<bool> is_gone(faces_.size(), false);
      for (const auto& [a, b] : features_) is_bound[a] = is_bound[b] = true;
      bool is_changed = false;
      for (const Edge& edge : sorted(around, [&](double size) { return size < least; })) {
        auto [kept, lost] = edge;
        const bool is_feature = features_.contains(edge);
        if (is_fixed_[lost] || (is_bound[lost] && !is_bound[kept])) std::swap(kept, lost);
        const bool joins_lines = is_bound[lost] && (is_fixed_[lost] || !is_feature);
        if (joins_lines) {
          // What is much smaller than a face goes, whatever it is, but nothing leaves the planes of 0.
          if (leaves_plane(kept, lost)) std::swap(kept, lost);
          if (length(edge) > 0.5 * least || leaves_plane(kept, lost)) continue;
        }
        const glm::dvec3 place = is_bound[kept] ? places_[kept] : 0.5 * (places_[kept] + places_[lost]);
        if (!can_collapse(kept, lost, place, most, around.at(edge).size(), fans, is_touched)) continue;
        is_changed = true;
        places_[kept] = place;
        for (const Vertex v : {kept, lost}) {
          for (const std::uint32_t face : fans[v]) is_touched[face] = true;
        }
        for (const std::uint32_t face : fans[lost]) {
          std::ranges::replace(faces_[face], lost, kept);
          const TriangleIndices& f = faces_[face];
          is_gone[face] = f[0] == f[1] || f[1] == f[2] || f[2] == f[0];
        }
        if (is_bound[lost]) rename_features(kept, lost);
        if (joins_lines) is_fixed_[kept] = true;
      }
      if (!is_changed) return;
      std::vector<TriangleIndices> faces;
      for (std::uint32_t face = 0; face < faces_.size(); ++face) {
        if (!is_gone[face]) faces.push_back(faces_[face]);
      }
      faces_ = std::move(faces);
    }
  }

  bool leaves_plane(Vertex kept, Vertex lost) const {
    const glm::dvec3 &to = places_[kept], &from = places_[lost];
    return (from.x == 0.0 && to.x != 0.0) || (from.y == 0.0 && to.y != 0.0) || (from.z == 0.0 && to.z != 0.0);
  }

  std::array<glm::dvec3, 3> places_of(const TriangleIndices& face) const {
    return {places_[face[0]], places_[face[1]], places_[face[2]]};
  }
  /// Where a face would bound no water: between vertices of one border.
  static bool lies_in_plane(const std::array<glm::dvec3, 3>& corners) {
    for (const glm::length_t axis : {0, 1, 2}) {
      if (corners[0][axis] == 0.0 && corners[1][axis] == 0.0 && corners[2][axis] == 0.0) return true;
    }
    return false;
  }

  bool can_collapse(Vertex kept, Vertex lost, const glm::dvec3& place, double most, std::size_t shared,
                    const std::vector<std::vector<std::uint32_t>>& fans,
                    const std::vector<bool>& is_touched) const {
    std::set<Vertex> around_kept, around_lost;
    for (const Vertex v : {kept, lost}) {
      for (const std::uint32_t face : fans[v]) {
        if (is_touched[face]) return false;
        bool has_both = true;
        for (const Vertex w : {kept, lost}) has_both = has_both && std::ranges::count(faces_[face], w) > 0;
        const TriangleIndices& corners = faces_[face];
        for (const Vertex corner : corners) {
          if (corner != v) (v == kept ? around_kept : around_lost).insert(corner);
        }
        if (has_both) continue;
        std::array<glm::dvec3, 3> at{};
        for (std::size_t i = 0; i < 3; ++i) at[i] = corners[i] == v ? place : places_[corners[i]];
        for (std::size_t i = 0; i < 3; ++i) {
          if (glm::distance(at[i], at[(i + 1) % 3]) > most) return false;
        }
        if (lies_in_plane(at) && !lies_in_plane(places_of(corners))) return false;
        const glm::dvec3 before = normal(face), after = twice_area(at[0], at[1], at[2]);
        // No face turns by more than 60 degrees.
        if (!(glm::dot(before, after) > 0.5 * glm::length(before) * glm::length(after)) &&
            glm::length(before) > 1e-3 * most * most)
          return false;
      }
    }
    // The edge's faces are all that both vertices share (link condition).
    std::size_t common = 0;
    for (const Vertex v : around_kept) common += around_lost.contains(v) ? 1 : 0;
    return common == shared;
  }

  void rename_features(Vertex kept, Vertex lost) {
    std::vector<Edge> renamed;
    for (auto edge = features_.begin(); edge != features_.end();) {
      if (edge->first != lost && edge->second != lost) {
        ++edge;
        continue;
      }
      const Vertex other = edge->first == lost ? edge->second : edge->first;
      if (other != kept) renamed.push_back(edge_of(kept, other));
      edge = features_.erase(edge);
    }
    features_.insert(renamed.begin(), renamed.end());
  }

  /// Flips edges whose opposite angles sum to more than half a turn (Delaunay).
  void flip() {
    for (int round = 0; round < most_rounds; ++round) {
      const EdgeFaces around = edges();
      std::vector<bool> is_touched(faces_.size(), false);
      std::set<Edge> made;
      for (const auto& [edge, faces] : around) {
        if (faces.size() != 2 || features_.contains(edge)) continue;
        if (is_touched[faces[0]] || is_touched[faces[1]]) continue;
        const Vertex c = opposite(faces[0], edge), d = opposite(faces[1], edge);
        const Edge other = edge_of(c, d);
        if (c == d || around.contains(other) || made.contains(other)) continue;
        if (!(angle(c, edge) + angle(d, edge) > 3.1416 + 1e-3)) continue;
        TriangleIndices one = faces_[faces[0]], two = faces_[faces[1]];
        const glm::dvec3 before = normal(one) + normal(two);
        // The first face loses one end of the edge, the second the other one.
        std::ranges::replace(one, edge.second, d);
        std::ranges::replace(two, edge.first, c);
        if (lies_in_plane(places_of(one)) || lies_in_plane(places_of(two))) continue;
        if (!(glm::dot(normal(one), before) > 0.0 && glm::dot(normal(two), before) > 0.0)) continue;
        faces_[faces[0]] = one;
        faces_[faces[1]] = two;
        is_touched[faces[0]] = is_touched[faces[1]] = true;
        made.insert(other);
      }
      if (made.empty()) return;
    }
  }

  Vertex opposite(std::uint32_t face, const Edge& edge) const {
    for (const Vertex v : faces_[face]) {
      if (v != edge.first && v != edge.second) return v;
    }
    return none;
  }
  double angle(Vertex at, const Edge& edge) const {
    const glm::dvec3 a = places_[edge.first] - places_[at], b = places_[edge.second] - places_[at];
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
  }

  /// Each vertex goes to the mean of the faces around it, by area, and back onto the surface; those of
  /// borders and creases to the mean of their neighbours there.
  void relax() {
    std::vector<glm::dvec3> sums(places_.size(), glm::dvec3(0.0)), normals = sums, lines = sums;
    std::vector<double> areas(places_.size(), 0.0);
    std::vector<int> on_line(places_.size(), 0);
    std::vector<std::size_t> line(places_.size(), 0);
    for (const TriangleIndices& face : faces_) {
      const glm::dvec3 twice = normal(face);
      const glm::dvec3 centre = (places_[face[0]] + places_[face[1]] + places_[face[2]]) / 3.0;
      for (const Vertex v : face) {
        sums[v] += glm::length(twice) * centre;
        areas[v] += glm::length(twice);
        normals[v] += twice;
      }
    }
    for (const Edge& edge : features_) {
      for (const auto& [v, other] :
           {std::pair(edge.first, edge.second), std::pair(edge.second, edge.first)}) {
        lines[v] += places_[other];
        ++on_line[v];
        line[v] = line_of(edge);
      }
    }
    for (Vertex v = 0; v < places_.size(); ++v) {
      if (is_fixed_[v] || !(areas[v] > 0.0)) continue;
      if (on_line[v] == 2) {
        places_[v] = lines_[line[v]].nearest(0.5 * lines[v]);
      } else if (on_line[v] == 0) {
        const double size2 = glm::dot(normals[v], normals[v]);
        const glm::dvec3 off = sums[v] / areas[v] - places_[v];
        const glm::dvec3 along = size2 > 0.0 ? off - glm::dot(off, normals[v]) / size2 * normals[v] : off;
        places_[v] = surface_.nearest(places_[v] + along);
      }
    }
  }

  std::vector<glm::dvec3> places_;
  std::vector<TriangleIndices> faces_;
  std::vector<bool> is_fixed_;
  std::set<Edge> features_;
  Reference<3> surface_;
  std::array<Reference<2>, 4> lines_;
};

}  // namespace

TriangleMesh even_mesh(const TriangleMesh& surface, std::size_t count) {
  constexpr double cos_crease = 0.766, no_crease = -2.0;
  const auto most = count + count / 10;
  for (const double crease : {cos_crease, no_crease}) {
    Remesher remesher(surface, crease);
    // Equilateral ones.
    double length = std::sqrt(4.0 / std::sqrt(3.0) * remesher.area() / static_cast<double>(count));
    for (int turn = 0; turn < 12; ++turn) {
      for (int pass = 0; pass < 4; ++pass) remesher.make_even(length, 8 * count);
      const double share = static_cast<double>(remesher.count()) / static_cast<double>(count);
      if (std::abs(share - 1.0) < 0.08) break;
      length *= std::clamp(std::sqrt(share), 0.8, 1.25);
    }
    if (remesher.count() <= most || crease == no_crease) return remesher.mesh();
  }
  return {};
}

}  // namespace offing::bodies
