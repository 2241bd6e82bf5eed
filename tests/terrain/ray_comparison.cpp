#include "tests/terrain/ray_comparison.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace offing::test {
namespace {

constexpr double moved_cells = 1e-4, gate_cells = 1e-3;

double cell_m(const HeightMap& map) {
  return std::min(map.grid.spacing_x_m, map.grid.spacing_z_m);
}

}  // namespace

bool is_robust(const HeightMap& map, const terrain::Ray& ray, const ReferenceHit& hit) {
  const double moved_m = moved_cells * cell_m(map);
  for (const double raised_m : {-moved_m, moved_m}) {
    const ReferenceHit moved = reference_hit(map, ray, raised_m);
    if (moved.kind != hit.kind) return false;
    const double change_m = std::abs(moved.distance_m - hit.distance_m) * hit.facing;
    if (hit.kind != TERRAIN_MISS && change_m > 3.0 * moved_m) return false;
  }
  return true;
}

std::vector<ReferenceHit> reference_hits(const HeightMap& map, const std::vector<terrain::Ray>& rays) {
  std::vector<ReferenceHit> hits;
  for (const terrain::Ray& ray : rays) hits.push_back(reference_hit(map, ray));
  return hits;
}

RayComparison compare(const HeightMap& map, const std::vector<terrain::Ray>& rays,
                      const std::vector<terrain::RayHit>& found) {
  return compare(map, rays, reference_hits(map, rays), found);
}

RayComparison compare(const HeightMap& map, const std::vector<terrain::Ray>& rays,
                      const std::vector<ReferenceHit>& references,
                      const std::vector<terrain::RayHit>& found) {
  RayComparison comparison;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const ReferenceHit& expected = references[i];
    const bool is_hit = expected.kind != TERRAIN_MISS;
    comparison.hits += is_hit ? 1 : 0;
    double error_cells = 0.0;
    if (is_hit && found[i].kind != TERRAIN_MISS) {
      error_cells = std::abs(found[i].distance_m - expected.distance_m) * expected.facing / cell_m(map);
    }
    if (found[i].kind == expected.kind && error_cells <= gate_cells) {
      comparison.worst_cells = std::max(comparison.worst_cells, error_cells);
      continue;
    }
    if (!is_robust(map, rays[i], expected)) {
      ++comparison.touching;
      continue;
    }
    if (++comparison.wrong > 3) continue;
    const terrain::Ray& ray = rays[i];
    ADD_FAILURE() << map.name << ": ray " << i << " from (" << ray.origin_m.x << ", " << ray.origin_m.y
                  << ", " << ray.origin_m.z << ") along (" << ray.direction.x << ", " << ray.direction.y
                  << ", " << ray.direction.z << "): expected kind " << expected.kind << " at "
                  << expected.distance_m << " m, found kind " << found[i].kind << " at "
                  << found[i].distance_m << " m in cell (" << found[i].cell_x << ", " << found[i].cell_z
                  << ") at (" << found[i].u << ", " << found[i].v << ")";
  }
  return comparison;
}

}  // namespace offing::test
