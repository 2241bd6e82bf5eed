#pragma once

#include <array>
#include <span>
#include <string_view>

#include "host/scene/model/scene.h"
#include "host/scene/schema/parameter.h"

namespace offing::scene {

/// Values that go together, under one name.
struct Preset {
  /// A key and what it is set to.
  struct Value {
    std::string_view key = {};
    std::string_view text = {};  ///< as a flag has it; empty: no value of the scene's own
  };

  std::string_view name;   ///< of the flag --preset
  std::string_view label;  ///< for people
  ParameterGroup group;
  std::array<Value, 5> values;
};

/// All presets. Those of the sea are the forces of the Beaufort scale: wind by 0.836 B^1.5 m/s and the
/// probable height of waves on the open sea (WMO 1970), at the period of a fully developed sea.
std::span<const Preset> presets();

/// The preset of this name. Throws Error(bad_usage) that names `subject` and the presets.
const Preset& find_preset(std::string_view name, std::string_view subject);

/// Sets the values of a preset.
void apply(const Preset& preset, Scene& scene);

}  // namespace offing::scene
