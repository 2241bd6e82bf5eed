#pragma once

#include "host/base/camera.h"
#include "host/world/world.h"
#include "present/gl_objects.h"
#include "present/render_target.h"
#include "present/shader_program.h"

namespace offing::present {

/// What an eye below the level sea sees: light that is lost in the water on its way, the light of the water
/// itself, and the sky through the surface in Snell's window, which is taken as flat and beyond which it
/// mirrors the deep.
class UnderwaterPass {
 public:
  UnderwaterPass();

  /// Whether this eye is in the water.
  static bool is_under(const world::World& world, const Camera& camera) {
    return world.has_sea() && camera.eye_m.y <= 0.0;
  }
  /// Fills `target` with the light of `dry`, drawn without a sea: light and reversed depth. `environment` is
  /// the map of SkyPass.
  void draw(const world::World& world, const Camera& camera, GLuint environment, const RenderTarget& dry,
            const RenderTarget& target) const;

 private:
  ShaderProgram program_;
  GlVertexArray no_vertices_;
};

}  // namespace offing::present
