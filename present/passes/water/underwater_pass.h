#pragma once

#include "host/base/camera.h"
#include "host/world/world.h"
#include "present/gl/gl_objects.h"
#include "present/gl/render_target.h"
#include "present/gl/shader_program.h"
#include "present/gl/uniform_block.h"
#include "present/passes/sky/cloudy_sky.h"
#include "present/passes/view_uniforms.h"
#include "present/passes/water/water_uniforms.h"

namespace offing::present {

/// What an eye below the level sea sees: light that is lost in the water on its way, the light of the water
/// itself, and the sky through the surface in Snell's window, which is taken as flat and beyond which it
/// mirrors the deep.
class UnderwaterPass {
 public:
  UnderwaterPass();

  /// Whether this eye is in the water.
  static bool is_under(const world::World& world, const Camera& camera) {
    return world.has_sea() && camera.eye_m.y <= world.sea_level_m();
  }
  /// What is drawn already.
  struct Dry {
    const RenderTarget& light;  ///< light and reversed depth without a sea
    GLuint environment;         ///< the map of SkyPass
    const CloudySky& cloudy_sky;
  };
  /// Fills `target` with what reaches the eye of it.
  void draw(const world::World& world, const Camera& camera, const Dry& dry, const RenderTarget& target);

 private:
  enum class Sky { clear, cloudy };  // above the water
  static ShaderProgram program_for(Sky sky);

  ShaderVariants<Sky> programs_;
  UniformBlock<glsl::ViewUniforms, glsl::UnderwaterUniforms> block_;
  GlVertexArray no_vertices_;
};

}  // namespace offing::present
