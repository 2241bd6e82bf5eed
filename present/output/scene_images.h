#pragma once

#include <optional>

#include "host/base/work.h"
#include "host/ocl/device.h"
#include "host/scene/model/scene.h"
#include "host/world/world.h"
#include "present/gl/gl_context.h"
#include "present/output/highlight_layer.h"
#include "present/passes/frame.h"
#include "present/passes/sky/light_meter.h"
#include "present/view_options.h"

namespace offing::present {

/// Draws pictures of a scene without a window, each at its own time. Use it in the thread that made it.
class SceneImages {
 public:
  /// Throws Error(no_device) without OpenGL, Error(cancelled) when asked to stop, and what preparing the
  /// scene's world throws.
  SceneImages(const scene::Scene& scene, const ocl::DeviceInfo& device, const FrameSettings& settings,
              const CancelToken& cancel);

  /// Draws a picture of a sequence that begins at `first_s`. False, with nothing drawn, when asked to stop.
  bool draw(double time_s, double first_s, const ImageSize& size, const CancelToken& cancel,
            HighlightShow highlights = HighlightShow::shown);

  /// Draws its highlights alone: HighlightShow::only or unobstructed. Nothing when asked to stop.
  std::optional<HighlightLayer> draw_highlights(double time_s, double first_s, const ImageSize& size,
                                                const CancelToken& cancel, HighlightShow highlights);

  // Of the last draw().
  const Frame& frame() const { return frame_; }
  double exposure() const { return exposure_; }

 private:
  void warn_of_eye(double time_s);

  GlContext context_;
  ocl::Device device_;
  scene::Scene scene_;
  world::World world_;
  highlights::LightingAt lighting_at_;
  Frame frame_;
  LightMeter light_meter_;
  double exposure_ = 1.0;
  bool has_warned_ = false;
};

}  // namespace offing::present
