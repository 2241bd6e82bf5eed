#pragma once

#include <vector>

#include "host/ocean/spectrum/sea_spectrum.h"

namespace offing::ocean {

/// Seas that cross, such as wind waves and swells: their densities S add. All are in the water of the first.
/// Throws Error(bad_usage) for none.
SeaSpectrum sum_of(std::vector<SeaSpectrum> seas);

}  // namespace offing::ocean
