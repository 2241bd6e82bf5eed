#pragma once

namespace offing::spectra {

/// SWAN's defaults for the density of sea water and for gravity, which turn energy in J/m^2 into variance.
inline constexpr double energy_of_variance_jpm4 = 1025.0 * 9.81;

}  // namespace offing::spectra
