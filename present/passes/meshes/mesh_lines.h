#pragma once

#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "host/world/world_mesh.h"
#include "present/gl/gl_objects.h"
#include "present/gl/shader_program.h"
#include "present/gl/uniform_block.h"
#include "present/passes/frame_request.h"
#include "present/passes/meshes/mesh_uniforms.h"
#include "present/passes/meshes/mesh_view_matrices.h"

namespace offing::present {

/// Draws what explains a mesh's highlights as lines: directions of curvature, boxes of projectors.
class MeshLines {
 public:
  MeshLines();

  /// Strokes along e_max, red, and e_min, blue, at the mesh's vertices, as far as they can be trusted.
  void draw_directions(const world::WorldMesh& mesh, const MeshViewMatrices& matrices,
                       const FrameRequest& request);
  /// A box for each highlight, as deep as half its width, with an arrow's tip toward its up.
  void draw_projectors(const world::WorldMesh& mesh, const MeshViewMatrices& matrices,
                       const FrameRequest& request);

 private:
  void draw(const std::vector<glm::vec3>& ends_m, const glm::vec3& colour, const MeshViewMatrices& matrices,
            const FrameRequest& request);

  ShaderProgram program_;
  UniformBlock<glsl::MeshMatrices, glsl::PlainUniforms> block_;
  GlVertexArray array_;
  GlBuffer ends_;
};

}  // namespace offing::present
