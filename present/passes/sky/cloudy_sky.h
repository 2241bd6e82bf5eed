#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "host/clouds/image/cloud_image.h"
#include "host/sky/atmosphere.h"
#include "present/gl/gl_objects.h"
#include "present/gl/render_target.h"
#include "present/gl/shader_program.h"
#include "present/gl/transfer.h"
#include "present/gl/uniform_block.h"
#include "present/passes/clouds/cloud_pass.h"
#include "present/passes/frame_request.h"
#include "present/passes/sky/sky_uniforms.h"
#include "present/passes/view_uniforms.h"

namespace offing::present {

/// The round map of the sky (environment.glsl) with its clouds, for what mirrors all of the sky: an eye looks
/// at the five faces of a cube that stand above the horizon, and each is laid over the part of the clear
/// sky's map that it shows. Has coarser levels, for light that is spread.
class CloudySky {
 public:
  /// With so many pixels along a side of each face; the map has twice as many in the same angle at the
  /// horizon.
  explicit CloudySky(int face_px = 48);

  struct Scenery {
    const clouds::DrawnParticles& drawn;  ///< seen from the eye
    const sky::Atmosphere& air;
    GLuint clear_sky;  ///< the map of SkyPass
    double sea_level_m = 0.0;
  };
  /// Draws the clouds as an eye at the sea or below it sees them, without the air below the sea: one below
  /// is the mirror image of one above. All of them, or with SkyRefresh::slice one face that is due: all are
  /// after five calls. The first draw() after forget() draws all. Throws what CloudPass throws.
  void draw(const ocl::Device& device, const Scenery& scenery, const glm::dvec3& eye_m, SkyRefresh refresh,
            Transfer& transfer);
  /// There is no map until the next draw().
  void forget() { has_map_ = false; }

  /// Whether shaders find clouds in the sky, which they read with cloudy_sky.glsl.
  bool has_map() const { return has_map_; }
  /// Binds its two maps, if there are any, as an array to the unit of the sampler `environment`.
  void bind(int unit) const;
  /// Light of the sky with its clouds, [side_px()][side_px()] of 4 floats, kcd/m2, row 0 at the bottom; has a
  /// map.
  std::vector<float> read() const;
  int side_px() const { return 4 * face_px_; }  ///< of the map

  /// Puts other textures of clouds in the place of Offing's own.
  void set_textures(const ocl::Device& device, const clouds::BillboardTextures& textures) {
    clouds_.set_textures(device, textures);
  }

 private:
  void make_maps();
  void fill_levels() const;
  void draw_face(const ocl::Device& device, const Scenery& scenery, const glm::dvec3& eye_m, int face,
                 Transfer& transfer);

  int face_px_;
  CloudPass clouds_;
  ShaderProgram program_;
  UniformBlock<glsl::ViewUniforms, glsl::CloudySkyUniforms> block_;
  GlVertexArray no_vertices_;
  RenderTarget face_;
  GlTexture maps_;             // one texture of two layers: some drivers have no unit to spare for another
  GlFramebuffer framebuffer_;  // draws on both
  int due_ = 0;                // the face that the next slice draws
  bool has_map_ = false;
};

}  // namespace offing::present
