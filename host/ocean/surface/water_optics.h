#pragma once

#include <array>

namespace offing::ocean {

/// Jerlov's types of sea water: I to III of the open sea, 1C to 9C of coasts, the clearest first.
enum class WaterType {
  oceanic_1,
  oceanic_1a,
  oceanic_1b,
  oceanic_2,
  oceanic_3,
  coastal_1,
  coastal_3,
  coastal_5,
  coastal_7,
  coastal_9
};

/// What water does to light below its surface, at red, green and blue (615, 550 and 465 nm).
struct WaterOptics {
  /// Diffuse attenuation of light on its way down, 1/m.
  std::array<double, 3> attenuation_perm;
  /// Of the light that enters deep water, the share that turns upward below its surface.
  std::array<double, 3> reflectance;
};

/// Attenuation by Jerlov 1976 (Marine optics, table XXVII). Reflectance is a third of backscattering over
/// attenuation (Morel & Prieur 1977): molecules scatter as Morel 1974 has it, and particles, the same at all
/// wavelengths, so much that waters have the colours that they are known by.
WaterOptics water_optics(WaterType type);

/// Below this depth a bed sends up less than half a step of 8 bits of what it would without water above it.
double visible_depth_m(const WaterOptics& optics);

}  // namespace offing::ocean
