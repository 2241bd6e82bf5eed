#pragma once

#include <vector>

#include "host/world/world.h"
#include "present/gl/image_textures.h"
#include "present/gl/shader_program.h"
#include "present/gl/uniform_block.h"
#include "present/passes/frame_request.h"
#include "present/passes/meshes/mesh_geometry.h"
#include "present/passes/meshes/mesh_lights.h"
#include "present/passes/meshes/mesh_uniforms.h"
#include "present/passes/meshes/mesh_view_matrices.h"
#include "present/passes/view_uniforms.h"

namespace offing::present {

/// Draws the highlights of a mesh over its base (H7, H9 of docs/sources.md): the faces of each one's region
/// once more, clipped to its projector's box.
class HighlightPass {
 public:
  HighlightPass();

  /// What all meshes of a picture share.
  struct Scenery {
    const world::World& world;
    const MeshLights& lights;
    ImageTextures& pictures;
    GLuint environment;
  };
  /// Onto the bound target, in which the mesh has been drawn with these matrices.
  void draw(const world::WorldMesh& mesh, const MeshGeometry& geometry, const MeshViewMatrices& matrices,
            const FrameRequest& request, const Scenery& scenery);

 private:
  glsl::HighlightUniforms uniforms_of(const world::WorldMesh& mesh,
                                      const highlights::DrawnHighlight& highlight,
                                      const FrameRequest& request, const Scenery& scenery) const;
  void bind_image(const ShaderProgram& program, const highlights::HighlightControls& controls,
                  const Scenery& scenery) const;

  ShaderVariants<highlights::HighlightTexture> programs_;
  UniformBlock<glsl::ViewUniforms, glsl::MeshMatrices, glsl::HighlightUniforms> block_;
  std::vector<std::uint32_t> corners_;
};

/// A bright colour for each highlight, unlike those of its neighbours: linear Rec.709.
glm::vec3 id_colour(std::uint64_t id);

}  // namespace offing::present
