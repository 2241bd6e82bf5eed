#pragma once

#include <memory>
#include <vector>

#include "host/base/camera.h"
#include "host/bodies/hull_map.h"
#include "host/world/world.h"
#include "present/gl/shader_program.h"
#include "present/gl/texture_array.h"
#include "present/passes/water/water_uniforms.h"

namespace offing::present {

/// The floating hulls of a world as hull_mask.glsl reads them: inside of them no water is drawn.
class HullMask {
 public:
  /// Copies hulls that are new, and fills in where they are at the time of the world's last at().
  void prepare(const world::World& world, const Camera& camera, glsl::SurfaceUniforms& grid);
  /// Gives their maps to a program in use.
  void bind(const ShaderProgram& program, int unit) const;

 private:
  std::vector<std::shared_ptr<const bodies::HullMap>> maps_;  // as they are in the texture
  TextureArray texture_;
};

}  // namespace offing::present
