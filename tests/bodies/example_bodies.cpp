#include "tests/bodies/example_bodies.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "host/mesh_shapes/shape.h"

namespace offing::test {

TriangleMesh box(const glm::dvec3& sides_m) {
  TriangleMesh mesh;
  for (int corner = 0; corner < 8; ++corner) {
    mesh.positions_m.push_back(0.5 * sides_m *
                               glm::dvec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1));
  }
  mesh.faces = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

TriangleMesh ball(double radius_m, int level) {
  return mesh_shapes::make_sphere(radius_m, level, {}).mesh;
}

TriangleMesh ship(double length_m, int cells) {
  return mesh_shapes::make_ship(length_m, {.u_cells = cells, .v_cells = 2 * cells / 3}).mesh;
}

TriangleMesh boat(double length_m, int cells) {
  return mesh_shapes::make_boat(length_m, {.u_cells = cells, .v_cells = cells}).mesh;
}

bodies::FloatingBodies::WaterSurface still_water(double level_m) {
  return [level_m](double, const ocl::Buffer<SurfaceQueryPoint>&, std::size_t count,
                   ocl::Buffer<SurfaceQueryShifted>& samples) {
    SurfaceQueryShifted sample{};
    sample.water.height_m = static_cast<float>(level_m);
    samples.write(std::vector<SurfaceQueryShifted>(count, sample));
  };
}

bodies::FloatingBodies::WaterSurface wavy_water(const LongWave& wave) {
  return [wave](double time_s, const ocl::Buffer<SurfaceQueryPoint>& points, std::size_t count,
                ocl::Buffer<SurfaceQueryShifted>& samples) {
    const std::vector<SurfaceQueryPoint> places = points.read();
    const double k = 2.0 * std::numbers::pi / wave.wavelength_m, omega = std::sqrt(9.81 * k);
    std::vector<SurfaceQueryShifted> found;
    for (std::size_t i = 0; i < count; ++i) {
      const double x_m = static_cast<double>(SURFACE_QUERY_TILE_M) * places[i].tile_x + places[i].x_m;
      const double phase = k * x_m - omega * time_s;
      SurfaceQueryShifted sample{};
      sample.water.height_m = static_cast<float>(wave.amplitude_m * std::cos(phase));
      sample.water.slope_x = static_cast<float>(-wave.amplitude_m * k * std::sin(phase));
      sample.shift_x_m = static_cast<float>(-wave.amplitude_m * std::sin(phase));
      sample.water.velocity_x_mps = static_cast<float>(wave.amplitude_m * omega * std::cos(phase));
      sample.water.velocity_y_mps = static_cast<float>(wave.amplitude_m * omega * std::sin(phase));
      found.push_back(sample);
    }
    samples.write(found);
  };
}

}  // namespace offing::test
