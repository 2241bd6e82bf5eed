// Prints what the panel method finds for a hull, and fine panels of it, as JSON: for panel_method_test.py.
#include <chrono>
#include <complex>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <string>

#include <nlohmann/json.hpp>

#include "host/bodies/hull.h"
#include "host/bodies/panel_hull.h"
#include "host/bodies/panel_method.h"
#include "host/mesh_shapes/shape.h"

namespace {

using namespace offing;
using nlohmann::json;

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

TriangleMesh cylinder(double radius_m, double height_m) {
  constexpr std::uint32_t sides = 32;
  TriangleMesh mesh;
  for (const double y : {-0.5 * height_m, 0.5 * height_m}) {
    for (std::uint32_t i = 0; i < sides; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / sides;
      mesh.positions_m.emplace_back(radius_m * std::cos(angle), y, radius_m * std::sin(angle));
    }
    mesh.positions_m.emplace_back(0.0, y, 0.0);
  }
  const std::uint32_t top = sides + 1;
  for (std::uint32_t i = 0; i < sides; ++i) {
    const std::uint32_t next = (i + 1) % sides;
    mesh.faces.push_back({i, next, sides});
    mesh.faces.push_back({top + next, top + i, top + sides});
    mesh.faces.push_back({i, top + i, top + next});
    mesh.faces.push_back({i, top + next, next});
  }
  return mesh;
}

struct Case {
  TriangleMesh mesh;
  double draught_m, below_m;  ///< of the mass centre below the water
};

Case case_of(const std::string& name) {
  if (name == "cube") return {box({10, 10, 10}), 5.0, 2.5};
  if (name == "shallow") return {box({10, 10, 10}), 2.0, 0.5};
  if (name == "cylinder") return {cylinder(5.0, 20.0), 10.0, 6.0};
  if (name == "barge") return {box({30, 6, 12}), 3.0, 1.0};
  return {mesh_shapes::make_ship(24.0, {.u_cells = 48, .v_cells = 32}).mesh, 0.0,
          0.0};  // the coaster of scenes/ship.toml
}

}  // namespace

int main(int count, char** arguments) {
  const std::string name = count > 1 ? arguments[1] : "cube";
  const Case given = case_of(name);
  const bodies::Extent extent = bodies::extent_of(given.mesh);
  const double density = 1025.0, gravity = 9.81;
  const double level_m = given.draught_m > 0.0 ? extent.low_m.y + given.draught_m : -0.1;
  const bodies::Submerged below = bodies::submerged_below(given.mesh, level_m);
  const double mass = density * below.volume_m3;
  glm::dvec3 centre = below.centre_m;
  centre.y =
      given.draught_m > 0.0 ? level_m - given.below_m : below.centre_m.y + 0.25 * (level_m - extent.low_m.y);
  const glm::dvec3 sides = extent.high_m - extent.low_m, s = sides * sides * (mass / 12.0);
  const HullMatrix inertia =
      bodies::mass_matrix(mass, {s.y + s.z, 0, 0, 0, s.x + s.z, 0, 0, 0, s.x + s.y}, centre, centre);
  const HullMatrix restoring = bodies::restoring_matrix(below, centre, centre, density, gravity);
  bodies::PanelOptions options;
  options.threads = 1;
  if (count > 2) options.panels = static_cast<std::size_t>(std::atoi(arguments[2]));
  const auto start = std::chrono::steady_clock::now();
  const HydrodynamicData data = bodies::panel_method(given.mesh, level_m, centre, density, gravity, options);
  const double cost_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const bodies::NaturalPeriods natural = bodies::natural_periods(data, inertia, restoring);

  json out{{"cost_s", cost_s},
           {"mass", inertia},
           {"restoring", restoring},
           {"natural_s", {natural.heave_s, natural.roll_s, natural.pitch_s}}};
  for (const double period_s : {3.5, 4.0, 5.0, 6.0, 7.0, 8.0, 10.0, 14.0}) {
    const double frequency = 2.0 * std::numbers::pi / period_s;
    const HullWrench head = bodies::linear_response(data, inertia, restoring, frequency, 0.0);
    const HullWrench beam =
        bodies::linear_response(data, inertia, restoring, frequency, 0.5 * std::numbers::pi);
    out["responses"].push_back({{"period_s", period_s},
                                {"heave", std::abs(head[1])},
                                {"pitch", std::abs(head[5])},
                                {"roll", std::abs(beam[3])}});
  }
  // Triangles from the water line down, from the mass centre, in axes x forward, y to port, z up.
  const bodies::PanelHull fine = bodies::panel_hull(given.mesh, level_m, name == "coaster" ? 1300 : 450);
  out["centre_below_m"] = level_m - centre.y;
  for (std::size_t i = 0; i < fine.wetted_count; ++i) {
    for (const glm::dvec3& image : fine.images) {
      const bool is_turned = image.x * image.z < 0.0;
      json triangle;
      for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 corner =
            image * fine.panels[i].corners_m[is_turned ? 2 - k : k] + fine.origin_m - centre;
        triangle.push_back({corner.x, -corner.z, corner.y + centre.y - fine.origin_m.y});
      }
      out["triangles"].push_back(triangle);
    }
  }
  std::puts(out.dump().c_str());
}
