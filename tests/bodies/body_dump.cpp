// body_dump FILE: where two bodies are on a wave, on the device that the environment names. FILE: of each of
// some times and each body, its state; then what the ship presses aside in a window of 32 x 32 cells.
#include <cmath>
#include <fstream>
#include <memory>
#include <numbers>

#include "host/bodies/floating_bodies.h"
#include "host/bodies/hull_press.h"
#include "host/bodies/panel_method.h"
#include "tests/bodies/example_bodies.h"
#include "tests/ocl/dump_program.h"

namespace {

using namespace offing;
using namespace offing::bodies;

void write_dump(const char* path) {
  const test::LongWave wave{.amplitude_m = 1.0, .wavelength_m = 90.0};
  FloatingBody ship = load_to_level("ship", test::ship(30.0, 12), 0.0, test::sea_density_kgpm3);
  ship.start = at_rest(ship, test::sea_density_kgpm3, 0.0, 0.0, 0.4);
  ship.hydrodynamics = std::make_shared<const HydrodynamicData>(
      panel_method(ship.hull, 0.0, ship.mass_centre_m, test::sea_density_kgpm3, 9.81, {.frequencies = 4}));
  FloatingBody box = load_to_mass("box", test::box({4.0, 2.0, 3.0}), 9000.0, test::sea_density_kgpm3);
  box.start = at_rest(box, test::sea_density_kgpm3, 40.0, 5.0, 0.0);
  const ocl::Device device = ocl::Device::open();
  FloatingBodies floating(device, {ship, box});
  const double k_radpm = 2.0 * std::numbers::pi / wave.wavelength_m;
  ModalSea sea;
  sea.modes.push_back(
      {.amplitude_m = wave.amplitude_m, .kx_radpm = k_radpm, .omega_radps = std::sqrt(9.81 * k_radpm)});
  floating.set_waves(sea);
  const auto drive = [](std::size_t body, double) {
    BodyDrive now{};
    now.thrust_n = body == 0 ? 10e3f : 0.0f;
    now.rudder_rad = 0.2f;
    return now;
  };
  std::ofstream file(path, std::ios::binary);
  for (int frame = 1; frame <= 2; ++frame) {
    floating.advance_to(frame / 15.0, test::wavy_water(wave), drive);
    for (const BodyPose& pose : floating.read_poses()) {
      for (const double value :
           {pose.mass_centre_m.x, pose.mass_centre_m.y, pose.mass_centre_m.z, pose.turn.x, pose.turn.y,
            pose.turn.z, pose.turn.w, pose.velocity_mps.x, pose.velocity_mps.y, pose.velocity_mps.z,
            pose.spin_radps.x, pose.spin_radps.y, pose.spin_radps.z}) {
        const auto rounded = static_cast<float>(value);
        file.write(reinterpret_cast<const char*>(&rounded), sizeof(rounded));
      }
    }
  }
  constexpr int cells = 32;
  ocl::Buffer<float> displaced(device, std::size_t{cells} * cells, "displaced");
  displaced.fill(0.0f);
  const HullPresser presser(device, map_of_hull(ship.hull), ship.mass_centre_m);
  // The window cuts the stern off.
  presser.press(floating.read_poses().front(), 0.9, {cells, -10, -16, 1.0f}, displaced);
  for (const float depth_m : displaced.read()) {
    file.write(reinterpret_cast<const char*>(&depth_m), sizeof(depth_m));
  }
}

}  // namespace

int main(int argc, char** argv) {
  return offing::test::run_dump_program(argc, argv, write_dump);
}
