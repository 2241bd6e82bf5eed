#include "tests/terrain/relief/relief_reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/base/parallel_for.h"

namespace offing::test {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double relief_gate_cells = 1e-3;

/// A ray's height above a patch from `begin` to `end`: a + b s + c s^2, s from `begin` on.
struct Way {
  double begin = 0.0, end = 0.0, a = 0.0, b = 0.0, c = 0.0;

  double at(double t) const { return a + (t - begin) * (b + (t - begin) * c); }
  double lowest_until(double t) const {
    const double last = std::min(t, end), turn = c > 0.0 ? begin - 0.5 * b / c : end;
    return std::min({a, at(last), at(std::clamp(turn, begin, last))});
  }
  /// The first t at which it is not above 0.
  double first_zero() const {
    if (a <= 0.0) return begin;
    const double length = end - begin, square = b * b - 4.0 * a * c;
    double found = infinite;
    if (square >= 0.0) {
      const double q = -0.5 * (b + std::copysign(std::sqrt(square), b));
      for (const double root : {q != 0.0 ? a / q : infinite, c != 0.0 ? q / c : infinite})
        if (root >= 0.0 && root <= length) found = std::min(found, root);
    }
    return begin + found;
  }
};

/// Calls visit(way), which says whether to go on, for all patches on the way from the eye.
template <class Visit>
void walk(const std::vector<PostSheet>& sheets, const glm::dvec3& eye_m, const glm::dvec3& ray,
          const Visit& visit) {
  double t = 0.0;
  for (const PostSheet& sheet : sheets) {
    const std::array<double, 2> from{(eye_m.x - sheet.left_m) / sheet.step_x_m,
                                     (eye_m.z - sheet.top_m) / sheet.step_z_m};
    const std::array<double, 2> along{ray.x / sheet.step_x_m, ray.z / sheet.step_z_m};
    const std::array<int, 2> cells{sheet.cells_x, sheet.cells_z};
    std::array<int, 2> cell{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double place = from[axis] + t * along[axis];
      // A ray on a border is in the cell that it goes into.
      const double whole = std::abs(place - std::round(place)) < 1e-9 && along[axis] < 0.0
                               ? std::round(place) - 1.0
                               : std::floor(place + 1e-9);
      cell[axis] = std::clamp(static_cast<int>(whole), 0, cells[axis] - 1);
    }
    while (cell[0] >= 0 && cell[0] < cells[0] && cell[1] >= 0 && cell[1] < cells[1]) {
      std::array<double, 2> ends{infinite, infinite};
      for (std::size_t axis = 0; axis < 2; ++axis) {
        if (along[axis] != 0.0)
          ends[axis] = (cell[axis] + (along[axis] > 0.0 ? 1 : 0) - from[axis]) / along[axis];
      }
      const std::size_t crossed = ends[0] <= ends[1] ? 0 : 1;
      const double end = std::max(t, ends[crossed]);
      const double h00 = static_cast<double>(sheet.post_m(cell[0], cell[1])),
                   h10 = static_cast<double>(sheet.post_m(cell[0] + 1, cell[1]));
      const double h01 = static_cast<double>(sheet.post_m(cell[0], cell[1] + 1)),
                   h11 = static_cast<double>(sheet.post_m(cell[0] + 1, cell[1] + 1));
      const double highest = std::max(std::max(h00, h10), std::max(h01, h11));
      if (std::min(eye_m.y + t * ray.y, eye_m.y + end * ray.y) <= highest + 1.0) {
        const double u = from[0] + t * along[0] - cell[0], v = from[1] + t * along[1] - cell[1];
        const double p = h10 - h00, q = h01 - h00, r = h11 - h10 - h01 + h00;
        const Way way{.begin = t,
                      .end = end,
                      .a = eye_m.y + t * ray.y - (h00 + p * u + q * v + r * u * v),
                      .b = ray.y - (p * along[0] + q * along[1] + r * (u * along[1] + v * along[0])),
                      .c = -r * along[0] * along[1]};
        if (!visit(way)) return;
      }
      t = end;
      if (std::isinf(t)) return;
      cell[crossed] += along[crossed] > 0.0 ? 1 : -1;
    }
  }
}

struct Verdict {
  bool is_wrong = false, is_touching = false;
  double error_cells = 0.0, expected_m = infinite;
};

Verdict judge(const std::vector<PostSheet>& sheets, const Camera& camera, const glm::dvec3& ray,
              double found_m) {
  const double cell_m = std::min(sheets.back().step_x_m, sheets.back().step_z_m);
  Verdict verdict;
  double lowest_m = infinite, over_found_m = infinite, fall = 1.0;
  walk(sheets, camera.eye_m, ray, [&](const Way& way) {
    if (std::isinf(verdict.expected_m)) {
      verdict.expected_m = way.first_zero();
      if (std::isfinite(verdict.expected_m))
        fall = std::abs(way.b + 2.0 * way.c * (verdict.expected_m - way.begin));
    }
    if (way.begin <= found_m) lowest_m = std::min(lowest_m, way.lowest_until(found_m - 1e-6 * found_m));
    if (found_m >= way.begin && found_m <= way.end)
      over_found_m = std::min(over_found_m, std::abs(way.at(found_m)));
    return way.begin <= found_m || std::isinf(verdict.expected_m);
  });
  if (std::isinf(found_m) && std::isinf(verdict.expected_m)) return verdict;
  verdict.error_cells = std::isfinite(found_m) && std::isfinite(verdict.expected_m)
                            ? std::abs(found_m - verdict.expected_m) * std::min(1.0, fall) / cell_m
                            : infinite;
  if (verdict.error_cells <= relief_gate_cells) return verdict;
  // What a ray touches it may pass over.
  const bool is_on_ground = std::isinf(found_m) || over_found_m <= relief_gate_cells * cell_m;
  verdict.is_touching = is_on_ground && lowest_m >= -relief_gate_cells * cell_m;
  verdict.is_wrong = !verdict.is_touching;
  return verdict;
}

}  // namespace

namespace {

/// Along one axis, from the eye's place in cells of the map.
struct SheetSide {
  int first = 0, cells = 0;
};
SheetSide side_of(double eye, int map_cells, double steps) {
  constexpr int ratio = 1 << TERRAIN_RELIEF_RATIO_LOG2;
  const double begin = ratio * std::floor((std::floor(eye * steps) - 0.5 * TERRAIN_RELIEF_CELLS) / ratio);
  const double first = std::max(begin, 0.0), last = std::min(begin + TERRAIN_RELIEF_CELLS, map_cells * steps);
  return {static_cast<int>(first), static_cast<int>(last - first)};
}

}  // namespace

std::vector<PostSheet> sheets_of(const HeightMap& map, const terrain::ReliefSurface& relief) {
  const TerrainRelief& params = relief.params();
  const std::vector<float> all_m = relief.heights_m().read();
  constexpr std::size_t posts = std::size_t{TERRAIN_RELIEF_POSTS} * TERRAIN_RELIEF_POSTS;
  std::vector<PostSheet> sheets;
  for (int level = 0; level < params.levels; ++level) {
    const double steps = std::ldexp(1.0, params.finest_log2 - level * TERRAIN_RELIEF_RATIO_LOG2);
    const SheetSide x = side_of(params.eye_cell_x + static_cast<double>(params.eye_fraction_x),
                                map.grid.columns - 1, steps),
                    z = side_of(params.eye_cell_z + static_cast<double>(params.eye_fraction_z),
                                map.grid.rows - 1, steps);
    PostSheet sheet{.step_x_m = map.grid.spacing_x_m / steps,
                    .step_z_m = map.grid.spacing_z_m / steps,
                    .cells_x = x.cells,
                    .cells_z = z.cells,
                    .columns = TERRAIN_RELIEF_POSTS};
    sheet.left_m = sheet.step_x_m * x.first;
    sheet.top_m = sheet.step_z_m * z.first;
    const auto begin = all_m.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(level) * posts);
    sheet.heights_m.assign(begin, begin + static_cast<std::ptrdiff_t>(posts));
    sheets.push_back(sheet);
  }
  sheets.push_back({.step_x_m = map.grid.spacing_x_m,
                    .step_z_m = map.grid.spacing_z_m,
                    .cells_x = map.grid.columns - 1,
                    .cells_z = map.grid.rows - 1,
                    .columns = static_cast<std::size_t>(map.grid.columns),
                    .heights_m = map.heights_m});
  return sheets;
}

ReliefComparison compare(const std::vector<PostSheet>& sheets, const Camera& camera,
                         const std::vector<TerrainHit>& hits) {
  ReliefComparison comparison{.rays = hits.size()};
  std::mutex guard;
  parallel_rows(camera.height_px, [&](int row) {
    ReliefComparison of_row;
    for (int column = 0; column < camera.width_px; ++column) {
      const TerrainHit& hit = hits[static_cast<std::size_t>(row) * static_cast<std::size_t>(camera.width_px) +
                                   static_cast<std::size_t>(column)];
      const glm::dvec2 clip(2.0 * (column + 0.5) / camera.width_px - 1.0,
                            1.0 - 2.0 * (row + 0.5) / camera.height_px);
      const auto found_m = static_cast<double>(hit.distance_m);
      const Verdict verdict = judge(sheets, camera, glm::normalize(ray_direction(camera, clip)), found_m);
      of_row.hits += hit.kind == TERRAIN_MISS ? 0 : 1;
      of_row.touching += verdict.is_touching ? 1 : 0;
      if (verdict.is_wrong) {
        ++of_row.wrong;
      } else if (!verdict.is_touching) {
        of_row.worst_cells = std::max(of_row.worst_cells, verdict.error_cells);
      }
      if (verdict.is_wrong && of_row.wrong == 1) {
        const std::scoped_lock lock(guard);
        if (comparison.wrong == 0) {
          ADD_FAILURE() << "pixel (" << column << ", " << row << "): expected a hit at " << verdict.expected_m
                        << " m, found " << found_m << " m, kind " << hit.kind;
        }
      }
    }
    const std::scoped_lock lock(guard);
    comparison.hits += of_row.hits;
    comparison.wrong += of_row.wrong;
    comparison.touching += of_row.touching;
    comparison.worst_cells = std::max(comparison.worst_cells, of_row.worst_cells);
  });
  return comparison;
}

}  // namespace offing::test
