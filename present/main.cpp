#include <cstdio>
#include <cstdlib>
#include <string>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/ocl/device.h"
#include "host/scene/scene_file.h"
#include "host/scene/world_scene.h"
#include "present/exposure.h"
#include "present/frame.h"
#include "present/picture_file.h"

using namespace offing;

int main(int argc, char** argv) {
  try {
    const scene::OceanScene scene = scene::load_scene(argv[1]);
    const present::GlContext context = present::GlContext::headless();
    const ocl::Device device = ocl::Device::open();
    world::World world(device, scene::prepare_world(scene));
    Camera camera = scene.view.camera;
    camera.width_px = std::atoi(argv[4]);
    camera.height_px = std::atoi(argv[5]);
    const int cells = argc > 6 ? std::atoi(argv[6]) : 384;
    present::Frame frame(context, device,
                         {.water = {.cells = {cells, cells}, .taps = argc > 7 ? std::atoi(argv[7]) : 4}});
    const double time_s = std::atof(argv[3]);
    world.at(time_s, camera.eye_m.y);
    const double exposure = present::exposure_for(world.sky(), camera, scene.view.exposure_ev);
    frame.draw(world, camera, exposure);
    present::write_picture(argv[2], frame, time_s, exposure);
    fmt::print("{} {} ev {}\n", context.capabilities().renderer, present::to_string(frame.transfer_rung()),
               exposure);
    return 0;
  } catch (const Error& error) {
    fmt::print(stderr, "error: {}\nhint: {}\n", error.what(), error.hint());
    return 1;
  }
}
