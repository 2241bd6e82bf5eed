#pragma once

#include <compare>
#include <string>
#include <vector>

#include "host/world/world.h"
#include "present/gl/shader_program.h"
#include "present/passes/water/ring_waves.h"

namespace offing::present {

/// The waves that a shader of the water is compiled for (ShaderVariants).
struct WaveFeatures {
  int cascades = 0;
  int wakes = 0;  ///< windows, at most glsl::most_wakes
  bool has_rings = false;
  bool has_shoals = false;

  auto operator<=>(const WaveFeatures&) const = default;
};

/// Those of a world with a sea, whose rings are these.
WaveFeatures wave_features(const world::World& world, const RingWaves& rings);

/// The structs of the uniforms of water, and a block of this name with these members.
std::vector<ShaderPart> water_uniforms(const std::string& block, const std::string& members);

/// The shaders of waves, compiled for them: water.glsl, rings.glsl, wakes.glsl, shoals.glsl,
/// swash.glsl. Put them
/// after water_uniforms() with a member `WaveUniforms waves`.
std::vector<ShaderPart> wave_shaders(const WaveFeatures& features);

}  // namespace offing::present
