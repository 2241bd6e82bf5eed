// A march in double precision through crowns, in steps that are shorter than the crowns.
#include "tests/terrain/canopy/crown_reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include <glm/glm.hpp>
#include <gtest/gtest.h>

namespace offing::test {
namespace {

constexpr double cell_m = 8192.0 * 0.01171875 / 13.0, step_m = 0.25, never = 1e30;

double smooth(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

double of_whole(std::uint32_t bits) {
  return static_cast<double>(static_cast<std::int32_t>(bits)) * 0x1p-31;
}

/// Seen along a ray.
struct Crown {
  double x = 0.0, z = 0.0;  ///< of its middle, in cells of the lattice
  double reach = 0.0, top_m = 0.0, hollow = 0.0, leaves_m = 0.0;

  double base_m() const { return (0.3 - hollow) * top_m; }
};

class March {
 public:
  March(const HeightMap& map, double highest_m, const Camera& camera)
      : map_(map),
        highest_m_(highest_m),
        eye_m_(camera.eye_m),
        above_(smooth(0.9, 1.5, (camera.eye_m.y - ground_m(camera.eye_m.x, camera.eye_m.z)) / highest_m)) {}

  double ground_m(double x_m, double z_m) const {
    const double x = x_m / map_.grid.spacing_x_m, z = z_m / map_.grid.spacing_z_m;
    const int column = std::clamp(static_cast<int>(std::floor(x)), 0, map_.grid.columns - 2);
    const int row = std::clamp(static_cast<int>(std::floor(z)), 0, map_.grid.rows - 2);
    const double u = x - column, v = z - row;
    const auto post = [&](int i, int j) { return static_cast<double>(map_.at(column + i, row + j)); };
    return (post(0, 0) * (1.0 - u) + post(1, 0) * u) * (1.0 - v) +
           (post(0, 1) * (1.0 - u) + post(1, 1) * u) * v;
  }

  /// From now on of this ray.
  void turn(const glm::dvec3& way) {
    way_ = way;
    along_x_ = (5.0 * way.x + 12.0 * way.z) / 13.0 / cell_m;
    along_z_ = (5.0 * way.z - 12.0 * way.x) / 13.0 / cell_m;
  }

  double clearance_m(double t_m) const {
    const glm::dvec3 place_m = eye_m_ + t_m * way_;
    return place_m.y - ground_m(place_m.x, place_m.z);
  }

  /// How deep the ray is in a crown, negative beside it: in smooth ones, or without all that leaves may hide.
  double depth_m(double t_m, bool is_smooth) const {
    const double clearance = clearance_m(t_m);
    if (clearance > highest_m_) return -1.0;
    double deepest_m = -1.0;
    each_crown(t_m, [&](const Crown& crown, double away) {
      const double share = away / (crown.reach * crown.reach), less_m = is_smooth ? 0.0 : crown.leaves_m;
      const double side = 2.0 * std::sqrt(share) * crown.top_m / (crown.reach * cell_m);
      const double rim = 2.0 * crown.top_m / (crown.reach * cell_m);
      const double top_m =
          crown.top_m * (1.0 - 0.7 * share) - less_m * std::hypot(1.0, 0.7 * rim) - clearance;
      const double low_m = clearance - crown.base_m() - crown.hollow * crown.top_m * share -
                           less_m * std::hypot(1.0, crown.hollow * rim);
      // Across its surface.
      deepest_m = std::max(deepest_m, std::min(top_m, low_m) / std::hypot(1.0, side));
    });
    return deepest_m;
  }

  bool is_in_trunk(double t_m, double tolerance_m) const {
    const double clearance = clearance_m(t_m);
    bool is_in = false;
    each_crown(t_m, [&](const Crown& crown, double away) {
      const double trunk = 0.0022 * crown.top_m + tolerance_m / cell_m;
      is_in |= away < trunk * trunk && clearance < 1.1 * crown.base_m() + tolerance_m;
    });
    return is_in;
  }

  bool is_smooth(double t_m) const { return t_m > 180.0; }

  /// Where the ray comes into a crown between two places, or `never`.
  double entry_m(double from_m, double to_m, bool is_smooth) const {
    double before_m = from_m;
    for (double t_m = from_m; t_m <= to_m;) {
      if (depth_m(t_m, is_smooth) > 0.0) {
        double out_m = before_m, in_m = t_m;
        for (int i = 0; i < 40; ++i) {
          const double middle_m = 0.5 * (out_m + in_m);
          (depth_m(middle_m, is_smooth) > 0.0 ? in_m : out_m) = middle_m;
        }
        return in_m;
      }
      before_m = t_m;
      // Over the layer, no slope is steeper than 2.
      t_m += std::max(step_m, (clearance_m(t_m) - highest_m_) / 3.0);
    }
    return never;
  }

 private:
  template <class Visit>
  void each_crown(double t_m, const Visit& visit) const {
    const glm::dvec3 place_m = eye_m_ + t_m * way_;
    const double x = (5.0 * place_m.x + 12.0 * place_m.z) / 13.0 / cell_m;
    const double z = (5.0 * place_m.z - 12.0 * place_m.x) / 13.0 / cell_m;
    for (int j = 0; j < 2; ++j) {
      for (int i = 0; i < 2; ++i) {
        const double cell_x = std::floor(x - 0.5) + i, cell_z = std::floor(z - 0.5) + j;
        std::uint32_t h = static_cast<std::uint32_t>(static_cast<std::int64_t>(cell_x)) * 0x8da6b343u +
                          static_cast<std::uint32_t>(static_cast<std::int64_t>(cell_z)) * 0xcb1ab31fu +
                          0x51ed270bu;
        h = (h ^ (h >> 15)) * 0x2c1b3c6du;
        h ^= h >> 13;
        const double off_x = x - cell_x - 0.5 - 0.4 * of_whole(h);
        const double off_z = z - cell_z - 0.5 - 0.4 * of_whole(h << 11);
        const double chance = 0.5 + 0.5 * of_whole(h << 22), size = 0.5 + 0.5 * of_whole(h * 0x9e3779b1u);
        // Where the ray passes its middle.
        const double square = along_x_ * along_x_ + along_z_ * along_z_;
        const double middle_m = t_m - (off_x * along_x_ + off_z * along_z_) / std::max(square, 1e-9);
        const double density = std::max(above_, smooth(12.0, 60.0, middle_m));
        const double whole = std::clamp((1.12 * density - chance) / 0.12, 0.0, 1.0);
        if (whole <= 0.0) continue;
        const double near = 1.0 - smooth(70.0, 160.0, middle_m);
        const Crown crown{.reach = (0.2 + 0.8 * std::sqrt(whole)) * (0.42 + 0.18 * size),
                          .top_m = whole * highest_m_ * (0.55 + 0.45 * size),
                          .hollow = 1.0 + near * (0.22 - 0.12 * size - 1.0),
                          .leaves_m = near};
        visit(crown, off_x * off_x + off_z * off_z);
      }
    }
  }

  const HeightMap& map_;
  double highest_m_;
  glm::dvec3 eye_m_;
  double above_;
  glm::dvec3 way_{0.0, -1.0, 0.0};
  double along_x_ = 0.0, along_z_ = 0.0;
};

}  // namespace

CrownComparison compare_crowns(const HeightMap& map, double highest_m, const Camera& camera,
                               double farthest_m, const std::vector<TerrainHit>& hits) {
  March march(map, highest_m, camera);
  const double tolerance_m = 1e-3 * map.grid.spacing_x_m;
  const double width_m = map.grid.spacing_x_m * (map.grid.columns - 1),
               depth_m = map.grid.spacing_z_m * (map.grid.rows - 1);
  CrownComparison found;
  for (std::size_t pixel = 0; pixel < hits.size(); ++pixel) {
    const double column = static_cast<double>(pixel % static_cast<std::size_t>(camera.width_px));
    const double row = static_cast<double>(pixel / static_cast<std::size_t>(camera.width_px));
    const glm::dvec3 way = glm::normalize(ray_direction(
        camera, {2.0 * (column + 0.5) / camera.width_px - 1.0, 1.0 - 2.0 * (row + 0.5) / camera.height_px}));
    march.turn(way);
    const bool is_hit = hits[pixel].kind != TERRAIN_MISS;
    const double hit_m = is_hit ? static_cast<double>(hits[pixel].distance_m) : never;
    const auto out_m = [&](double eye_m, double along, double side_m) {
      return along > 0.0 ? (side_m - eye_m) / along : (along < 0.0 ? -eye_m / along : never);
    };
    const double end_m = std::min(
        {hit_m, farthest_m, out_m(camera.eye_m.x, way.x, width_m), out_m(camera.eye_m.z, way.z, depth_m)});
    ++found.rays;
    const bool is_crown = is_hit && hit_m < farthest_m && march.clearance_m(hit_m) > 0.04;
    if (is_crown) {
      ++found.crowns;
      if (march.is_smooth(hit_m)) ++found.smooth;
    }
    // No ray goes on behind what leaves leave.
    const double missed_m = march.entry_m(0.0, end_m - tolerance_m, false);
    bool is_wrong = false, is_touching = false;
    if (missed_m < never) {
      double deepest_m = 0.0;
      for (double t_m = missed_m; t_m < end_m - tolerance_m; t_m += 0.02) {
        deepest_m = std::max(deepest_m, march.depth_m(t_m, false));
      }
      (deepest_m < tolerance_m ? is_touching : is_wrong) = true;
    }
    // A hit is at the surface of a crown, or between that of a smooth one and what leaves leave.
    if (is_crown && !is_wrong) {
      const double ahead_m = std::max(march.depth_m(hit_m + tolerance_m, true), march.depth_m(hit_m, true));
      if (!(ahead_m > -tolerance_m) && !march.is_in_trunk(hit_m, tolerance_m)) is_wrong = true;
      if (march.is_smooth(hit_m) && !is_touching) {
        found.worst_cells =
            std::max(found.worst_cells, std::abs(march.depth_m(hit_m, true)) / map.grid.spacing_x_m);
      }
    }
    found.touching += is_touching && !is_wrong ? 1 : 0;
    if (is_wrong && ++found.wrong <= 5) {
      ADD_FAILURE() << map.name << ", pixel " << pixel << ": hit at " << hit_m << " m, "
                    << march.clearance_m(std::min(hit_m, 1e4)) << " m high, depth "
                    << march.depth_m(std::min(hit_m, 1e4), true) << " m; a crown from " << missed_m
                    << " m on";
    }
  }
  return found;
}

}  // namespace offing::test
