#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "host/base/camera.h"
#include "host/clouds/image/billboard_textures.h"
#include "host/world/world.h"
#include "present/gl/gl_context.h"
#include "present/gl/render_target.h"
#include "present/gl/stage_times.h"
#include "present/gl/transfer.h"
#include "present/passes/clouds/cloud_pass.h"
#include "present/passes/clouds/cloud_shadows.h"
#include "present/passes/meshes/mesh_pass.h"
#include "present/passes/sky/cloudy_sky.h"
#include "present/passes/sky/sky_pass.h"
#include "present/passes/terrain/terrain_pass.h"
#include "present/passes/tone_pass.h"
#include "present/passes/water/underwater_pass.h"
#include "present/passes/water/water_pass.h"

namespace offing::present {

struct FrameSettings {
  WaterDetail water;
  std::optional<TransferPath> transfer = {};  ///< the best one where absent
  terrain::Sampling terrain = {};
  int sky_step_px = 1;  ///< between pixels of whose sky the light is worked out (SkyPass)
};

/// What a picture of the sky depends on.
struct SkySight {
  glm::dvec3 eye_m{0.0}, sun_direction{0.0};
  double time_s = 0.0;
};

/// Draws pictures of a world, always into framebuffers of its own, so that a window, a file and a test see
/// the same. One context, one thread.
class Frame {
 public:
  Frame(const GlContext& context, const ocl::Device& device, const FrameSettings& settings);

  /// Pictures from one slice of the cloudy sky's map to the next (SkyRefresh::slice): a pixel of the map is
  /// two degrees, which clouds and eyes take seconds for. Where eye, sun or time jump all of it is drawn.
  static constexpr int slice_frames = 4;

  /// Draws the next pictures as finely as these settings say; the transfer path stays.
  void set_detail(const FrameSettings& settings);
  /// Draws the world as it stands (World::at()), with the camera's width and height. False where the request
  /// is not wanted any more: screen() is the last picture then.
  bool draw(world::World& world, const FrameRequest& request);

  /// Puts other textures of clouds in the place of Offing's own.
  void set_billboards(const ocl::Device& device, const clouds::BillboardTextures& textures) {
    clouds_.set_textures(device, textures);
    cloudy_sky_.set_textures(device, textures);
  }

  /// Has the next picture draw all that pictures may keep of those before it (SkyRefresh).
  void forget() { cloudy_sky_.forget(); }

  /// Scene-linear light of the last picture, kcd/m2.
  const RenderTarget& light() const { return is_under_ ? under_ : light_; }
  /// The last picture as a screen shows it, sRGB.
  const RenderTarget& screen() const { return screen_; }
  /// Times of the stages, for callers to add their own and to end the frame.
  StageTimes& times() { return times_; }
  TransferPath transfer_path() const { return transfer_.path(); }

 private:
  void fit(int width, int height);
  void show_light(const FrameRequest& request, bool shows_steps);
  bool draw_light(world::World& world, const FrameRequest& request, bool sees_terrain);
  void draw_clouds(world::World& world, const FrameRequest& request);
  void draw_cloudy_sky(world::World& world, const FrameRequest& request);

  GlCapabilities capabilities_;
  terrain::Sampling terrain_sampling_;
  Transfer transfer_;
  SkyPass sky_;
  WaterPass water_;
  TerrainPass terrain_;
  MeshPass meshes_;
  CloudPass clouds_;
  CloudySky cloudy_sky_;
  int frames_of_slice_ = 0;  // drawn since a slice of it was
  SkySight sky_sight_;       // of the last picture with clouds
  CloudShadows shadows_;
  UnderwaterPass underwater_;
  TonePass tone_;
  RenderTarget light_, under_, screen_;
  bool is_under_ = false;  // the eye, by the last picture
  StageTimes times_;
};

}  // namespace offing::present
