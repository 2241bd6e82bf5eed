#pragma once

#include <string>

#include "host/base/wave_spectrum.h"
#include "host/cli/common/direction_text.h"
#include "host/ocean/spectrum/sea_spectrum.h"

namespace offing::cli {

/// A record as text: its figures, and a line a frequency with energy, mean direction and a bar. At most 80
/// columns.
std::string spectrum_text(const WaveSpectrum& record, const ocean::SeaState& state, DirectionStyle style);

}  // namespace offing::cli
