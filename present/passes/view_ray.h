#pragma once

#include "host/base/camera.h"
#include "present/gl/shader_program.h"

namespace offing::present {

/// Sets the uniforms of view_ray.glsl on a program in use.
inline void set_view_rays(const ShaderProgram& program, const Camera& camera) {
  const CameraBasis axes = basis(camera);
  const glm::dvec2 extent = half_extent(camera);
  program.set("ray_forward", glm::vec3(axes.forward));
  program.set("ray_right", glm::vec3(extent.x * axes.right));
  program.set("ray_up", glm::vec3(extent.y * axes.up));
}

}  // namespace offing::present
