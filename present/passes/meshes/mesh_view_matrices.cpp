#include "present/passes/meshes/mesh_view_matrices.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>

#include "present/passes/camera_projection.h"

namespace offing::present {
namespace {

constexpr double nowhere_m = -1e9;  // deeper than anything is drawn

}  // namespace

MeshViewMatrices::MeshViewMatrices(const world::WorldMesh& mesh, const Camera& camera,
                                   const GlCapabilities& capabilities, MeshPart part, double sea_level_m)
    : to_eye(mesh.motion().rotation),
      cut_m(part == MeshPart::above_sea ? sea_level_m - camera.eye_m.y : nowhere_m) {
  const highlights::RigidMotion& motion = mesh.motion();
  to_eye[3] =
      glm::dvec4(motion.rotation * mesh.surface().middle_m() + (motion.translation_m - camera.eye_m), 1.0);
  to_clip = clip_from_eye(camera, capabilities.has_clip_control) * to_eye;
}

std::vector<ShaderPart> mesh_uniforms(const std::string& block, const std::string& members) {
  return {shader_file("view_uniforms.h"), shader_file("meshes/mesh_uniforms.h"),
          uniform_block(block, members)};
}

ShaderStages plain_stages(std::initializer_list<const char*> vertex) {
  const std::vector<ShaderPart> uniforms =
      mesh_uniforms("Plain", "MeshMatrices matrices; PlainUniforms plain;");
  ShaderStages stages{.vertex = uniforms, .fragment = uniforms};
  for (const char* name : vertex) stages.vertex.push_back(shader_file(name));
  stages.fragment.push_back(shader_file("meshes/mesh_plain.frag"));
  return stages;
}

PixelBox pixels_of(const glm::dvec3& low_m, const glm::dvec3& high_m, const MeshViewMatrices& matrices,
                   const Camera& camera, double margin_px) {
  const PixelBox all{.width = camera.width_px, .height = camera.height_px};
  glm::dvec2 low(std::numeric_limits<double>::infinity()), high = -low;
  for (int corner = 0; corner < 8; ++corner) {
    const auto side = [&](int axis) { return ((corner >> axis) & 1) != 0 ? high_m[axis] : low_m[axis]; };
    const glm::dvec4 clip = matrices.to_clip * glm::dvec4(side(0), side(1), side(2), 1.0);
    if (clip.w < near_m) return all;
    low = glm::min(low, glm::dvec2(clip) / clip.w);
    high = glm::max(high, glm::dvec2(clip) / clip.w);
  }
  const glm::dvec2 size(camera.width_px, camera.height_px);
  const glm::dvec2 first = glm::clamp((0.5 + 0.5 * low) * size - margin_px, glm::dvec2(0.0), size);
  const glm::dvec2 last = glm::clamp((0.5 + 0.5 * high) * size + margin_px, glm::dvec2(0.0), size);
  PixelBox box{.left = static_cast<int>(std::floor(first.x)),
               .bottom = static_cast<int>(std::floor(first.y))};
  box.width = static_cast<int>(std::ceil(last.x)) - box.left;
  box.height = static_cast<int>(std::ceil(last.y)) - box.bottom;
  return box;
}

PixelBox around(const PixelBox& a, const PixelBox& b) {
  if (a.width == 0 || a.height == 0) return b;
  if (b.width == 0 || b.height == 0) return a;
  const int left = std::min(a.left, b.left), bottom = std::min(a.bottom, b.bottom);
  return {.left = left,
          .bottom = bottom,
          .width = std::max(a.left + a.width, b.left + b.width) - left,
          .height = std::max(a.bottom + a.height, b.bottom + b.height) - bottom};
}

}  // namespace offing::present
