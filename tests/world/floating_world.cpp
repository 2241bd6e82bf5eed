#include "tests/world/floating_world.h"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "host/bodies/path_drive.h"
#include "host/bodies/pressed_hull.h"
#include "host/mesh_shapes/shape.h"
#include "host/ocean/spectrum/spectrum_parameters.h"

namespace offing::test {
namespace {

constexpr double density_kgpm3 = 1025.0, speed_mps = 4.0, run_up_s = 10.0;

world::BodySettings settings_of(const char* name, const TriangleMesh& mesh, std::size_t index, double level_m,
                                double z_m) {
  world::BodySettings settings;
  settings.map = std::make_shared<const bodies::HullMap>(bodies::map_of_hull(mesh));
  settings.body =
      bodies::load_to_level(name, bodies::pressed_hull(mesh, *settings.map, 600), level_m, density_kgpm3);
  settings.mesh = index;
  const double pace_mps = index == 0 ? speed_mps : 0.0;
  const auto path = [pace_mps, z_m](double time_s) { return bodies::PathPlace{pace_mps * time_s, z_m, 0.0}; };
  settings.body.start = bodies::at_rest(settings.body, density_kgpm3, path(-run_up_s).x_m, z_m, 0.0);
  settings.drive = [path, index](double time_s, double start_s) {
    if (time_s + 0.004 < start_s) {
      return bodies::drive_along([&](double at_s) { return path(std::min(at_s - start_s, 0.0)); }, time_s);
    }
    BodyDrive drive{};
    drive.thrust_n = index == 0 ? 8e3f : 0.0f;
    return drive;
  };
  return settings;
}

world::MeshParameters drawn(const TriangleMesh& mesh) {
  world::MeshParameters parameters;
  parameters.mesh = std::make_shared<const TriangleMesh>(mesh);
  parameters.motion = [](double) { return highlights::RigidMotion{}; };
  parameters.has_highlights = false;
  return parameters;
}

}  // namespace

world::WorldParameters floating_world(double wind_speed_mps) {
  ocean::SpectrumParameters spectrum;
  spectrum.wind_speed_mps = wind_speed_mps;
  world::WorldParameters result;
  result.spectrum = ocean::make_sea_spectrum(spectrum);
  result.ocean.size = 64;
  result.ocean.cascades = ocean::cascades_from_patches(std::array{400.0, 50.0}, 64);
  const TriangleMesh ship = mesh_shapes::make_ship(24.0, {.u_cells = 30, .v_cells = 16}).mesh;
  const TriangleMesh box = mesh_shapes::make_box({2.0, 2.0, 2.0}, 2).mesh;
  result.meshes = {drawn(ship), drawn(box), drawn(box)};
  result.meshes[2].motion = [](double) {
    return highlights::RigidMotion{.rotation = glm::dmat3(1.0), .translation_m = {-8.0, 3.0, 0.0}};
  };
  result.bodies = {settings_of("ship", ship, 0, 0.0, 0.0), settings_of("box", box, 1, -0.4, 30.0)};
  result.bodies[0].aboard = {2};
  result.run_up_s = run_up_s;
  world::WakeSettings wake{.parameters = {.cells = 64, .length_m = 128.0, .step_s = 1.0 / 40.0},
                           .history_s = run_up_s};
  wake.forcing_at = [](double) { return ocean::WakeForcing{}; };
  wake.body = 0;
  wake.behind_m = 30.0;
  result.wakes = {wake};
  return result;
}

}  // namespace offing::test
