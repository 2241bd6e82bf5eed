#pragma once

#include <optional>

#include "host/base/camera.h"
#include "host/world/world.h"
#include "present/gl_context.h"
#include "present/render_target.h"
#include "present/sky_pass.h"
#include "present/tone_pass.h"
#include "present/transfer.h"
#include "present/water_pass.h"

namespace offing::present {

struct FrameSettings {
  WaterDetail water;
  std::optional<TransferRung> transfer = {};  ///< the best one where absent
};

/// Draws pictures of a world, always into framebuffers of its own, so that a window, a file and a test see
/// the same. One context, one thread.
class Frame {
 public:
  Frame(const GlContext& context, const ocl::Device& device, const FrameSettings& settings);

  /// Draws the world as it stands (World::at()) as the camera sees it, with its width and height. `exposure`
  /// is that of TonePass.
  void draw(world::World& world, const Camera& camera, double exposure);

  /// Scene-linear light of the last picture, kcd/m2.
  const RenderTarget& light() const { return light_; }
  /// The last picture as a screen shows it, sRGB.
  const RenderTarget& screen() const { return screen_; }
  TransferRung transfer_rung() const { return transfer_.rung(); }

 private:
  void fit(int width, int height);

  GlCapabilities capabilities_;
  TransferLadder transfer_;
  SkyPass sky_;
  WaterPass water_;
  TonePass tone_;
  RenderTarget light_, screen_;
};

}  // namespace offing::present
