#include "present/passes/water/wave_features.h"

#include <fmt/format.h>

#include "kernels/shared/shoal_params.h"

namespace offing::present {

WaveFeatures wave_features(const world::World& world, const RingWaves& rings) {
  const world::WorldWakes* wakes = world.wakes();
  return {.cascades = static_cast<int>(world.parameters().ocean.cascades.size()),
          .wakes = wakes != nullptr ? static_cast<int>(wakes->maps()->count()) : 0,
          .has_rings = rings.count() > 0,
          .has_shoals = world.shoals() != nullptr};
}

std::vector<ShaderPart> wave_shaders(const WaveFeatures& features) {
  const ShaderPart compiled_for{
      "features of waves",
      fmt::format("#define CASCADES {}\n#define WAKES {}\n#define HAS_RINGS {:d}\n#define HAS_SHOALS {:d}\n"
                  "#define SHOAL_STEPS {}\n#define SHOAL_STEEPEST {:f}\n",
                  features.cascades, features.wakes, features.has_rings, features.has_shoals, SHOAL_STEPS,
                  SHOAL_STEEPEST)};
  return {compiled_for, shader_file("water/water.glsl"), shader_file("water/rings.glsl"),
          shader_file("water/wakes.glsl"), shader_file("water/shoals.glsl")};
}

}  // namespace offing::present
