#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "host/world/world.h"
#include "present/gl/gl_context.h"
#include "present/gl/multisample_target.h"
#include "present/gl/render_target.h"
#include "present/gl/shader_program.h"
#include "present/gl/uniform_block.h"
#include "present/passes/frame_request.h"
#include "present/passes/meshes/highlight_pass.h"
#include "present/passes/meshes/mesh_geometry.h"
#include "present/passes/meshes/mesh_lights.h"
#include "present/passes/meshes/mesh_lines.h"
#include "present/passes/meshes/mesh_uniforms.h"
#include "present/passes/meshes/mesh_view_matrices.h"
#include "present/passes/view_uniforms.h"

namespace offing::present {

/// Draws the meshes of a world with their outlines and highlights, several samples a pixel, and lays them
/// over what lies behind.
class MeshPass {
 public:
  explicit MeshPass(const GlCapabilities& capabilities);

  /// Copies meshes that are new or have another form.
  void prepare(const world::World& world);
  /// Draws onto a target whose depth is reversed: behind what is nearer there. `environment` is the map of
  /// SkyPass.
  void draw(const world::World& world, const FrameRequest& request, GLuint environment,
            const CloudShadows& shadows, const RenderTarget& target);
  /// Draws a part of all meshes onto a target of light and depth as draw() does, one sample a pixel.
  void draw_plainly(const world::World& world, const FrameRequest& request, GLuint environment,
                    const CloudShadows& shadows, MeshPart part, const RenderTarget& target);

 private:
  struct Mesh {
    std::uint64_t revision;
    MeshGeometry geometry;
  };

  /// What mesh.frag is compiled for.
  struct BaseFeatures {
    world::BaseShading shading = world::BaseShading::phong;
    bool shows_curvature = false;

    auto operator<=>(const BaseFeatures&) const = default;
  };
  static ShaderProgram base_program(const BaseFeatures& features);

  PixelBox pixels(const world::World& world, const Camera& camera) const;
  void begin(const RenderTarget& target);
  void draw_mesh(const world::World& world, std::size_t index, const FrameRequest& request,
                 GLuint environment, MeshPart part);
  void draw_base(const world::World& world, std::size_t index, const MeshViewMatrices& matrices,
                 const FrameRequest& request, GLuint environment);
  void draw_outline(std::size_t index, const MeshViewMatrices& matrices, const FrameRequest& request,
                    const world::MeshMaterial& material);
  void end(const RenderTarget& target, const FrameRequest& request);

  GlCapabilities capabilities_;
  ShaderProgram begin_, outline_, end_;
  ShaderVariants<BaseFeatures> bases_;
  UniformBlock<glsl::ViewUniforms, glsl::MeshMatrices, glsl::MeshUniforms> base_block_;
  UniformBlock<glsl::MeshMatrices, glsl::PlainUniforms> outline_block_;
  UniformBlock<glsl::MeshEndUniforms> end_block_;
  GlVertexArray no_vertices_;
  MeshLights lights_;
  ImageTextures pictures_;
  HighlightPass highlights_;
  MeshLines lines_;
  MultisampleTarget samples_;
  std::vector<Mesh> meshes_;  // in the order of the world's
};

}  // namespace offing::present
