#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "host/base/camera.h"
#include "host/world/world_mesh.h"
#include "present/gl/gl_context.h"
#include "present/gl/shader_program.h"
#include "present/passes/meshes/mesh_uniforms.h"

namespace offing::present {

enum class MeshPart {
  all,
  above_sea,  ///< above the level sea
};

/// How places of MeshGeometry, relative to the mesh's middle, come to the screen. Made in double precision.
struct MeshViewMatrices {
  glm::dmat4 to_eye;   ///< relative to the eye, in the world's axes
  glm::dmat4 to_clip;  ///< of the screen
  double cut_m;        ///< height over the eye's below which nothing is drawn

  MeshViewMatrices(const world::WorldMesh& mesh, const Camera& camera, const GlCapabilities& capabilities,
                   MeshPart part, double sea_level_m);

  /// As mesh_place.glsl reads them.
  glsl::MeshMatrices uniforms() const {
    return {.to_clip = to_clip, .to_eye = to_eye, .cut_m = static_cast<float>(cut_m)};
  }
};

/// The structs of the uniforms of meshes, and a block of this name with these members.
std::vector<ShaderPart> mesh_uniforms(const std::string& block, const std::string& members);

/// The stages of a program that draws in one plain light, with these vertex shader files. They read the block
/// "Plain" of MeshMatrices and PlainUniforms.
ShaderStages plain_stages(std::initializer_list<const char*> vertex);

/// Pixels, from the picture's lower left corner.
struct PixelBox {
  int left = 0, bottom = 0, width = 0, height = 0;
};

/// The pixels that a box around a mesh's vertices may be seen on, with a margin; all of them where it reaches
/// behind the eye.
PixelBox pixels_of(const glm::dvec3& low_m, const glm::dvec3& high_m, const MeshViewMatrices& matrices,
                   const Camera& camera, double margin_px);

/// The smallest box around both; a box without pixels adds nothing.
PixelBox around(const PixelBox& a, const PixelBox& b);

}  // namespace offing::present
