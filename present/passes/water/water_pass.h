#pragma once

#include <compare>

#include "host/base/camera.h"
#include "host/world/world.h"
#include "present/gl/gl_context.h"
#include "present/gl/gl_objects.h"
#include "present/gl/render_target.h"
#include "present/gl/shader_program.h"
#include "present/gl/transfer.h"
#include "present/gl/uniform_block.h"
#include "present/passes/clouds/cloud_shadows.h"
#include "present/passes/frame_request.h"
#include "present/passes/view_uniforms.h"
#include "present/passes/water/ring_waves.h"
#include "present/passes/water/water_maps.h"
#include "present/passes/water/water_surface.h"
#include "present/passes/water/water_uniforms.h"
#include "present/passes/water/water_views.h"
#include "present/passes/water/wave_features.h"

namespace offing::present {

/// How finely the water is drawn.
struct WaterDetail {
  GridCells cells;
  /// Samples along a pixel's footprint, which is long where water is seen at a grazing angle.
  int taps = 1;
  /// Pixels along the longer side of the pictures of what water mirrors and shows beneath it (O13); 0: it
  /// mirrors the sky alone, and is deep.
  int views_px = 256;
};

/// Draws the ocean: its shape (WaterSurface), then its light on the pixels that show it.
class WaterPass {
 public:
  WaterPass(const GlCapabilities& capabilities, WaterDetail detail);

  void set_detail(const WaterDetail& detail) { detail_ = detail; }
  /// Copies the world's maps into textures.
  void prepare(world::World& world, Transfer& transfer) { maps_.prepare(world, transfer); }
  /// Draws onto a target whose depth is reversed, with what is not water mirrored in it and seen through it.
  /// False where the request is not wanted any more (FrameRequest::goes_on).
  bool draw(world::World& world, const FrameRequest& request, const DryPasses& dry,
            const RenderTarget& target, Transfer& transfer);

 private:
  /// What the shader is compiled for.
  struct Features {
    WaveFeatures waves;
    int taps = 1;
    WaterShow debug = WaterShow::none;
    bool mirrors = false;
    bool mirrors_things = false;
    bool mirrors_finely = true;
    bool shows_beneath = false;
    bool has_clouds = false;  // in the sky that it mirrors

    auto operator<=>(const Features&) const = default;
  };
  static ShaderProgram program_for(const Features& features);

  void bind_surface(const ShaderProgram& program) const;
  /// Keeps what a target shows before the water, at its own pixels.
  void keep_ground(const RenderTarget& target);
  /// Puts the water's depth into a target, and 1 into the mask's depth for each pixel that shows water.
  void draw_mask(const RenderTarget& target);
  /// A picture of this many rows.
  static bool fill(const FrameRequest& request, int height_px);

  WaterDetail detail_;
  WaterMaps maps_;
  WaterSurface surface_;
  WaterViews views_;
  ShaderVariants<Features> programs_;
  UniformBlock<glsl::ViewUniforms, glsl::WaveUniforms, glsl::WaterUniforms> block_;
  GlVertexArray no_vertices_;
  GlTexture foam_pattern_;
  ShaderProgram ground_, depth_, mask_;
  RenderTarget ground_target_, mask_target_;
  GlFramebuffer masked_;  // a picture's light with the mask's depth
};

}  // namespace offing::present
