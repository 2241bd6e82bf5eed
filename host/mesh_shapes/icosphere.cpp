#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "host/mesh_shapes/shape_parts.h"

namespace offing::mesh_shapes {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// Each edge split in halves, each face in four.
void split(Icosphere& sphere) {
  std::map<Edge, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [found, is_new] = middles.try_emplace(Edge(std::min(a, b), std::max(a, b)),
                                                     static_cast<std::uint32_t>(sphere.directions.size()));
    if (is_new) sphere.directions.push_back(glm::normalize(sphere.directions[a] + sphere.directions[b]));
    return found->second;
  };
  std::vector<TriangleIndices> faces;
  faces.reserve(4 * sphere.faces.size());
  for (const auto& [a, b, c] : sphere.faces) {
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    faces.insert(faces.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
  }
  sphere.faces = std::move(faces);
}

double mean_edge(const Icosphere& sphere) {
  double sum = 0.0;
  for (const auto& [a, b, c] : sphere.faces) {
    sum += glm::distance(sphere.directions[a], sphere.directions[b]) +
           glm::distance(sphere.directions[b], sphere.directions[c]) +
           glm::distance(sphere.directions[c], sphere.directions[a]);
  }
  return sum / (3.0 * static_cast<double>(sphere.faces.size()));
}

}  // namespace

Icosphere icosphere(int level, const Roughness& roughness) {
  require_shape_value("level", level, 0, finest_level);
  require_roughness(roughness);
  constexpr double golden = std::numbers::phi;
  Icosphere sphere;
  // Corners of three golden rectangles across one another.
  for (const glm::dvec3& corner : {glm::dvec3{-1, golden, 0},
                                   {1, golden, 0},
                                   {-1, -golden, 0},
                                   {1, -golden, 0},
                                   {0, -1, golden},
                                   {0, 1, golden},
                                   {0, -1, -golden},
                                   {0, 1, -golden},
                                   {golden, 0, -1},
                                   {golden, 0, 1},
                                   {-golden, 0, -1},
                                   {-golden, 0, 1}}) {
    sphere.directions.push_back(glm::normalize(corner));
  }
  sphere.faces = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                  {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                  {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (int i = 0; i < level; ++i) split(sphere);
  sphere.edge = mean_edge(sphere);
  if (roughness.jitter > 0.0) {
    for (std::size_t i = 0; i < sphere.directions.size(); ++i) {
      const ShapeRandom random(roughness.seed, i);
      const glm::dvec3 way{random.within_one(0), random.within_one(1), random.within_one(2)};
      sphere.directions[i] = glm::normalize(sphere.directions[i] + roughness.jitter * sphere.edge * way);
    }
  }
  return sphere;
}

}  // namespace offing::mesh_shapes
