#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "host/io/hydrodynamics/hydrodynamic_table.h"

namespace offing::hydrodynamics {

/// What WAMIT's numbers are divided by, which its files do not say.
struct WamitUnits {
  double density_kgpm3 = 1025.0, gravity_mps2 = 9.81;
  double length_m = 1.0;  ///< ULEN
};

/// A text and the name of its file.
struct WamitText {
  std::string_view text, name;
};

/// WAMIT's numeric output for one body (manual of WAMIT 7, chapter 4): .1 with lines PER I J A [B], .3 with
/// PER BETA I Mod Pha Re Im, .hst with I J C. Periods in s, 0 for an infinite frequency and below 0 for none;
/// angles in degrees; amplitudes of e^(+i omega t). Elements that are not there are 0. Moments and rotations
/// are about the origin, which is on the still water. Throws Error(bad_input) naming file and line.
HydrodynamicFile parse_wamit(const WamitText& radiation, const WamitText& excitation,
                             const std::optional<WamitText>& restoring, const WamitUnits& units);

}  // namespace offing::hydrodynamics
