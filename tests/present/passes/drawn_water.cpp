#include "tests/present/passes/drawn_water.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace offing::test {
namespace {

constexpr double earth_radius_m = 6.36e6;

}  // namespace

DrawnWater drawn_beside_queried(world::World& world, const present::WaterSurface& surface,
                                const Camera& camera) {
  const std::vector<float> facets = surface.target().read(1);
  std::vector<ocean::WaterPoint> points;
  std::vector<double> heights_m;
  for (int row = 0; row < camera.height_px; ++row) {
    for (int column = 0; column < camera.width_px; ++column) {
      const double distance_m = facets[4 * static_cast<std::size_t>(row * camera.width_px + column) + 2];
      if (distance_m <= 0.0) continue;
      const glm::dvec3 drawn_m =
          distance_m * glm::normalize(ray_direction(camera, {(2.0 * column + 1.0) / camera.width_px - 1.0,
                                                             (2.0 * row + 1.0) / camera.height_px - 1.0}));
      const double drop_m = (drawn_m.x * drawn_m.x + drawn_m.z * drawn_m.z) / (2.0 * earth_radius_m);
      points.push_back({camera.eye_m.x + drawn_m.x, camera.eye_m.z + drawn_m.z});
      heights_m.push_back(camera.eye_m.y + drawn_m.y + drop_m);
    }
  }
  DrawnWater drawn{.count = points.size()};
  if (points.empty()) return drawn;
  const std::vector<ocean::WaterSample> samples =
      world.sample(points, {.accuracy = ocean::WaterQuery::Accuracy::frame_maps});
  // Queries know no swash: what it adds to the height, as present/passes/water/swash.glsl has it.
  const auto swash_m = [&](std::size_t i) {
    if (!world.swash()) return 0.0;
    const double depth_m = world.shoals()->instant().depths->depth_m(points[i].x_m, points[i].z_m);
    const double share = 1.0 - glm::smoothstep(0.0, 2.0 * world.swash()->reach_m(), depth_m);
    return share * world.swash()->level_m(points[i].x_m, points[i].z_m, world.time_s());
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double off_m = samples[i].height_m + swash_m(i) - heights_m[i];
    drawn.height_squares_m2 += heights_m[i] * heights_m[i];
    drawn.off_squares_m2 += off_m * off_m;
  }
  if (world.terrain() == nullptr) return drawn;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto terrain = world.terrain()->terrain_at(points[i].x_m, points[i].z_m);
    if (!terrain || terrain->height_m <= 0.0) continue;
    drawn.over_land_m = std::max(drawn.over_land_m, std::abs(heights_m[i] - swash_m(i)));
    ++drawn.land_count;
  }
  return drawn;
}

}  // namespace offing::test
