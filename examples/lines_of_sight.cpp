// Shows the C++ class HeightField: casts rays from a lighthouse over a hill to boats behind it, and prints
// which of them see the light.
//
// Build: see README.md beside this file. Use: lines_of_sight
#include <cmath>
#include <cstdio>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "host/base/error.h"
#include "host/ocl/device.h"
#include "host/terrain/field/height_field.h"

namespace {

namespace terrain = offing::terrain;

/// A bell-shaped hill of 80 m in the middle of 6 km x 6 km of flat land at sea level, posts 30 m apart; x = z
/// = 0 is at its top.
terrain::HeightField make_hill(const offing::ocl::Device& device) {
  const terrain::PostGrid grid{.columns = 201,
                               .rows = 201,
                               .spacing_x_m = 30.0,
                               .spacing_z_m = 30.0,
                               .origin_x_m = -3000.0,
                               .origin_z_m = -3000.0};
  std::vector<float> heights_m;  // [rows][columns]
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const double x_m = grid.origin_x_m + column * grid.spacing_x_m;
      const double z_m = grid.origin_z_m + row * grid.spacing_z_m;
      heights_m.push_back(static_cast<float>(80.0 * std::exp(-(x_m * x_m + z_m * z_m) / (400.0 * 400.0))));
    }
  }
  return {device, grid, heights_m};
}

}  // namespace

int main() try {
  terrain::HeightField hill = make_hill(offing::ocl::Device::open());
  const glm::dvec3 light_m(-2000.0, 50.0, 0.0);
  std::vector<glm::dvec3> boats_m;
  for (int i = -4; i <= 4; ++i) boats_m.emplace_back(2000.0, 5.0, 500.0 * i);

  std::vector<terrain::Ray> rays;
  for (const glm::dvec3& boat_m : boats_m) {
    // The limit ends the ray at the boat: what is hit beyond hides nothing.
    rays.push_back({light_m, glm::normalize(boat_m - light_m), glm::distance(light_m, boat_m)});
  }
  const std::vector<terrain::RayHit> hits = hill.cast(rays);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    std::printf("boat %5.0f m south: ", boats_m[i].z);
    if (hits[i].kind == TERRAIN_MISS) {
      std::puts("sees the light");
    } else {
      std::printf("hidden by the hill %.0f m from the light\n", hits[i].distance_m);
    }
  }
  return 0;
} catch (const offing::Error& error) {
  std::fprintf(stderr, "error: %s\nhint: %s\n", error.what(), error.hint().c_str());
  return offing::exit_code(error.kind());
}
