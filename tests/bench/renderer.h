// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#pragma once

#include <string>
#include <vector>

#include "host/scene/model/view_scene.h"
#include "present/gl/gl_context.h"
#include "present/passes/frame.h"
#include "present/passes/sky/light_meter.h"
#include "present/view_options.h"
#include "tests/bench/benches.h"

namespace offing::bench {

/// A scene drawn into a framebuffer, frame after frame, as the window draws it where the CPU draws.
class Renderer {
 public:
  /// `selector` is of ocl::select_device(). Throws what the presenter throws.
  Renderer(const std::string& selector, const world::WorldParameters& parameters,
           const scene::ViewScene& view, present::ImageSize size);

  const std::string& gl_renderer() const { return context_.capabilities().renderer; }
  const scene::ViewScene& view() const { return view_; }
  world::World& world() { return world_; }

  /// A 24th of a second after the last one, with the eye moved from the scene's by so much. Waits for all of
  /// it.
  void draw_next(const glm::dvec3& moved_m = glm::dvec3(0.0));

  /// Of the last frame.
  double stage_ms(present::Stage stage) {
    return frame_.times().history_ms(stage, present::TimeSource::cpu).back();
  }
  /// Stages last until they are done from now on.
  void wait_for_stages() { frame_.times().wait_for_stages(); }

 private:
  present::GlContext context_;
  ocl::Device device_;
  world::World world_;
  present::Frame frame_;
  present::LightMeter light_meter_;
  scene::ViewScene view_;
  double time_s_ = 0.0;
};

}  // namespace offing::bench
