// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include "tests/bench/renderer.h"

#include "host/scene/prepare/scene_terrain.h"

namespace offing::bench {

Renderer::Renderer(const std::string& selector, const world::WorldParameters& parameters,
                   const scene::ViewScene& view, present::ImageSize size)
    : context_(present::GlContext::headless()),
      device_(ocl::Device::open_shared(ocl::select_device(selector), ocl::Profiling::off,
                                       context_.share_properties())),
      world_(device_, parameters),
      frame_(context_, device_, present::frame_settings(present::Detail::low)),
      view_(view) {
  view_.camera.width_px = size.width;
  view_.camera.height_px = size.height;
  if (world_.terrain()) scene::stand_on_ground(*world_.terrain(), view_);
}

void Renderer::draw_next(const glm::dvec3& moved_m) {
  constexpr double frame_s = 1.0 / 24.0;
  time_s_ += frame_s;
  Camera camera = view_.camera;
  camera.eye_m += moved_m;
  {
    const present::StageTimes::Scope stage(frame_.times(), present::Stage::simulate);
    world_.at(time_s_, camera.eye_m.y);
    device_.finish();
  }
  const double exposure = light_meter_.exposure(world_, camera, view_.exposure_ev);
  // As a window does it: the map of the cloudy sky comes in slices.
  frame_.draw(world_, {.camera = camera, .exposure = exposure, .sky = present::SkyRefresh::slice});
  glFinish();
  frame_.times().end_frame();
}

}  // namespace offing::bench
