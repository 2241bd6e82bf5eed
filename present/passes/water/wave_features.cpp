#include "present/passes/water/wave_features.h"

#include <algorithm>

#include <fmt/format.h>

#include "kernels/shared/gerstner_params.h"
#include "kernels/shared/shoal_params.h"
#include "kernels/shared/swash_params.h"
#include "present/passes/water/water_uniforms.h"

namespace offing::present {

WaveFeatures wave_features(const world::World& world, const RingWaves& rings) {
  const world::WorldWakes* wakes = world.wakes();
  return {
      .cascades = static_cast<int>(world.parameters().ocean.cascades.size()),
      .wakes = wakes != nullptr ? std::min(static_cast<int>(wakes->maps()->count()), glsl::most_wakes) : 0,
      .has_rings = rings.count() > 0,
      .has_shoals = world.shoals() != nullptr};
}

std::vector<ShaderPart> water_uniforms(const std::string& block, const std::string& members) {
  const ShaderPart sizes{
      "sizes of uniforms",
      fmt::format("#define GERSTNER_WAVES {}\n#define SHOAL_STEPS {}\n#define SWASH_WAVES {}\n",
                  GERSTNER_WAVES, SHOAL_STEPS, SWASH_WAVES)};
  return {sizes, shader_file("view_uniforms.h"), shader_file("water/water_uniforms.h"),
          uniform_block(block, members)};
}

std::vector<ShaderPart> wave_shaders(const WaveFeatures& features) {
  const ShaderPart compiled_for{
      "features of waves",
      fmt::format("#define CASCADES {}\n#define WAKES {}\n#define HAS_RINGS {:d}\n#define HAS_SHOALS {:d}\n"
                  "#define SHOAL_STEEPEST {:f}\n#define SWASH_SKEW {:f}\n",
                  features.cascades, features.wakes, features.has_rings, features.has_shoals, SHOAL_STEEPEST,
                  SWASH_SKEW)};
  std::vector<ShaderPart> parts{compiled_for};
  if (features.has_rings) parts.push_back(uniform_block("Rings", "RingUniforms rings;"));
  if (features.has_shoals) parts.push_back(uniform_block("Shoals", "ShoalUniforms shoals;"));
  for (const char* name : {"water/water.glsl", "water/rings.glsl", "water/wakes.glsl", "water/shoals.glsl",
                           "water/swash.glsl"}) {
    parts.push_back(shader_file(name));
  }
  return parts;
}

}  // namespace offing::present
