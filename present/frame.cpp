#include "present/frame.h"

namespace offing::present {

Frame::Frame(const GlContext& context, const ocl::Device& device, const FrameSettings& settings)
    : capabilities_(context.capabilities()),
      transfer_(context, device, settings.transfer),
      water_(context.capabilities(), settings.water) {}

void Frame::fit(int width, int height) {
  if (light_.width() == width && light_.height() == height) return;
  light_ = RenderTarget(width, height, GL_RGBA16F, RenderTarget::Depth::single_precision);
  screen_ = RenderTarget(width, height, GL_RGBA8, RenderTarget::Depth::none);
}

void Frame::draw(world::World& world, const FrameRequest& request) {
  fit(request.camera.width_px, request.camera.height_px);
  // Depth is 1 at the near plane and 0 at infinity.
  if (capabilities_.has_clip_control) glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  {
    const StageTimes::Scope stage(times_, Stage::transfer);
    water_.prepare(world, transfer_);
    sky_.prepare(world.sky());
  }
  {
    const StageTimes::Scope stage(times_, Stage::water);
    light_.bind();
    glClearDepth(0.0);
    glClear(GL_DEPTH_BUFFER_BIT);
    water_.draw(world, request, sky_.environment(), light_);
  }
  {
    // Last, where nothing else is.
    const StageTimes::Scope stage(times_, Stage::sky);
    light_.bind();
    sky_.draw(request.camera);
  }
  {
    const StageTimes::Scope stage(times_, Stage::tone);
    screen_.bind();
    tone_.draw(light_, request.exposure);
  }
  require_no_gl_error("frame");
}

}  // namespace offing::present
