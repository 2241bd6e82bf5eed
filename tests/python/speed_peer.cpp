// The C++ side of speed.py: a sea of the same scene. For each line of standard input it does once what the
// line names, and answers with the milliseconds that it took.
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include "host/ocl/device.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/prepare/world_scene.h"
#include "host/world/world.h"

namespace {

using namespace offing;

std::vector<ocean::WaterPoint> points_of(std::size_t count) {
  std::vector<ocean::WaterPoint> points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back({0.37 * static_cast<double>(i % 1000), 0.41 * static_cast<double>(i / 1000)});
  return points;
}

}  // namespace

// speed_peer SCENE_TEXT SAMPLES
int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const scene::Scene scene = scene::parse_scene(argv[1], "scene", "");
  world::World world(ocl::Device::open(), scene::prepare_world(scene));
  const std::vector<ocean::WaterPoint> points = points_of(std::strtoull(argv[2], nullptr, 10));
  scene::show_at(world, scene, 0.0);
  double time_s = 0.0;
  for (std::string what; std::cin >> what;) {
    time_s += 0.1;
    const auto begin = std::chrono::steady_clock::now();
    if (what == "sample") {
      world.sample(points);
    } else if (what == "frame_and_displacement") {
      scene::show_at(world, scene, time_s);
      const auto count =
          static_cast<std::size_t>(world.sea_samples()) * static_cast<std::size_t>(world.sea_samples());
      std::vector<float> x(count), y(count), z(count);
      world.ocean().read_fields(0,
                                std::vector{ocean::SeaField::displacement_x, ocean::SeaField::displacement_y,
                                            ocean::SeaField::displacement_z},
                                std::vector{x.data(), y.data(), z.data()});
    } else {
      return 2;
    }
    std::cout << std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count()
              << std::endl;
  }
  return 0;
}
