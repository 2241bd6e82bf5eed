#pragma once

#include <filesystem>

#include "host/base/wave_spectrum.h"
#include "host/cli/common/direction_text.h"
#include "host/io/png_image.h"
#include "host/ocean/spectrum/sea_spectrum.h"

namespace offing::cli {

/// A record as a picture of 1240 x 620 pixels. Left: energy against frequency, with periods on the upper
/// axis. Right: the directional density E(f) D(f, theta) as a compass rose, north up, radius = frequency, at
/// the direction of travel or, as the text tells them then, at that where waves come from; or a word that the
/// record has no directions. Above: station, time, and Hs and Tp of `state`. Throws Error(bad_input) if the
/// record's arrays do not match each other.
RgbImage draw_spectrum_plot(const WaveSpectrum& record, const ocean::SeaState& state,
                            DirectionStyle style = DirectionStyle::travel);

/// Writes that picture as PNG, atomically. Throws Error(file) if it cannot be written.
void write_spectrum_plot(const std::filesystem::path& path, const WaveSpectrum& record,
                         const ocean::SeaState& state, DirectionStyle style, Existing existing);

}  // namespace offing::cli
