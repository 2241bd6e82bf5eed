// The C++ side of speed.py: a sea of the same scene. For each line of standard input it measures a block of
// what the line names, as block_ms() of speed.py does, and answers with the milliseconds of the median.
#include <algorithm>
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
  const auto run_once_ms = [&](const std::string& what) {
    time_s += 0.1;
    const auto begin = std::chrono::steady_clock::now();
    if (what == "sample") {
      world.sample(points);
    } else {
      scene::show_at(world, scene, time_s);
      const auto count =
          static_cast<std::size_t>(world.sea_samples()) * static_cast<std::size_t>(world.sea_samples());
      std::vector<float> x(count), y(count), z(count);
      world.ocean().read_fields(0,
                                std::vector{ocean::SeaField::displacement_x, ocean::SeaField::displacement_y,
                                            ocean::SeaField::displacement_z},
                                std::vector{x.data(), y.data(), z.data()});
    }
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  };
  for (std::string what; std::cin >> what;) {
    if (what != "sample" && what != "frame_and_displacement") return 2;
    constexpr double warm_up_ms = 15.0, block_ms = 30.0;
    for (double spent_ms = 0.0; spent_ms < warm_up_ms;) spent_ms += run_once_ms(what);
    std::vector<double> took_ms;
    for (double spent_ms = 0.0; spent_ms < block_ms; spent_ms += took_ms.back())
      took_ms.push_back(run_once_ms(what));
    std::ranges::sort(took_ms);
    std::cout << (took_ms[took_ms.size() / 2] + took_ms[(took_ms.size() - 1) / 2]) / 2.0 << std::endl;
  }
  return 0;
}
