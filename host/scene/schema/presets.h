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

  std::string_view name;   ///< of the sea, that of the flag --preset; its last word is that of a button
  std::string_view label;  ///< for people
  ParameterGroup group;
  std::array<Value, 12> values;  ///< those without a key are none
};

/// All presets. Those of the sea are the forces of the Beaufort scale: wind by 0.836 B^1.5 m/s and the
/// probable height of waves on the open sea (WMO 1970), at the period of a fully developed sea. Those of
/// clouds and layers are the genera, those of bodies hulls with their load and engine.
std::span<const Preset> presets();

/// The preset of the sea of this name. Throws Error(bad_usage) that names `subject` and these presets.
const Preset& find_preset(std::string_view name, std::string_view subject);

/// Sets the values of a preset, in an element of its group's section where there are several. Those of a body
/// that are values of a mesh go to its hull, if it has one.
void apply(const Preset& preset, Scene& scene, ElementIndex element = {});

}  // namespace offing::scene
