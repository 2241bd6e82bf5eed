#pragma once

#include <memory>
#include <vector>

#include "host/base/camera.h"
#include "host/bodies/hull_map.h"
#include "host/world/world.h"
#include "present/gl/shader_program.h"
#include "present/gl/texture_array.h"

namespace offing::present {

/// The floating hulls of a world as hull_mask.glsl reads them: inside of them no water is drawn.
class HullMask {
 public:
  /// Copies hulls that are new, and passes on where they are at the time of the world's last at().
  void bind(const ShaderProgram& program, int unit, const world::World& world, const Camera& camera);

 private:
  std::vector<std::shared_ptr<const bodies::HullMap>> maps_;  // as they are in the texture
  TextureArray texture_;
};

}  // namespace offing::present
