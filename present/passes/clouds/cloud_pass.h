#pragma once

#include <optional>
#include <vector>

#include "host/clouds/image/cloud_image.h"
#include "host/sky/atmosphere.h"
#include "host/world/world.h"
#include "present/gl/gl_objects.h"
#include "present/gl/render_target.h"
#include "present/gl/shader_program.h"
#include "present/gl/texture_array.h"
#include "present/gl/transfer.h"
#include "present/gl/uniform_block.h"
#include "present/passes/clouds/cloud_uniforms.h"
#include "present/passes/layer_light.h"
#include "present/passes/view_uniforms.h"

namespace offing::present {

/// Draws clouds over all that is opaque: their picture is made by OpenCL (clouds::CloudImage), which sees
/// each pixel's depth, and laid over the scene here.
///
/// Why not by OpenGL: its billboards cannot stop at what is opaque already, of which clouds have much. 1,000
/// particles over 59 % of 640 x 360 pixels cost 23 ms here.
class CloudPass {
 public:
  CloudPass();

  /// Reads the depth of the target and makes the picture for it; textures are made by the first call. Throws
  /// what CloudImage and Transfer throw.
  void prepare(const ocl::Device& device, const clouds::DrawnParticles& drawn, const Camera& camera,
               const RenderTarget& target, Transfer& transfer);
  /// The same where nothing stands before the clouds, without a target to read.
  void prepare_open(const ocl::Device& device, const clouds::DrawnParticles& drawn, const Camera& camera,
                    Transfer& transfer);
  /// Where the air before clouds begins: at the eye, or, for an eye below the sea, where its rays leave it.
  enum class AirFrom { eye, sea };
  /// Lays the picture of prepare() over the bound target. `environment` is the map of SkyPass.
  void draw(const Camera& camera, const sky::Atmosphere& air, GLuint environment,
            AirFrom air_from = AirFrom::eye, LayerLight light = LayerLight::drawn);

  /// Puts other textures in the place of Offing's own.
  void set_textures(const ocl::Device& device, const clouds::BillboardTextures& textures);

 private:
  void fit(const ocl::Device& device, int width_px, int height_px);
  void make(const clouds::DrawnParticles& drawn, const Camera& camera, Transfer& transfer);

  ShaderProgram program_;
  UniformBlock<glsl::ViewUniforms, glsl::CloudUniforms> block_;
  GlVertexArray no_vertices_;
  std::optional<clouds::CloudImage> cloud_image_;
  std::vector<float> depth_;
  TextureArray image_, distance_;
};

/// The clouds of a world as the last World::see_clouds() sorted them, for CloudPass. The world has clouds.
clouds::DrawnParticles drawn_clouds(const world::World& world);

/// Offing's own textures of clouds, made at the first call: half a second of work for two cores.
const clouds::BillboardTextures& built_in_billboards();

}  // namespace offing::present
