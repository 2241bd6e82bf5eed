#pragma once

#include <filesystem>

#include "host/base/wave_spectrum.h"
#include "host/io/png_image.h"

namespace offing::cli {

/// A record as a picture of 1240 x 620 pixels. Left: energy against frequency, with periods on the upper
/// axis. Right: the directional density E(f) D(f, theta) as a compass rose, north up, radius = frequency, at
/// the direction of travel; or a word that the record has no directions. Above: station, time, Hs and Tp.
/// Throws Error(bad_input) if the record's arrays do not match each other.
RgbImage draw_spectrum_plot(const WaveSpectrum& record);

/// Writes that picture as PNG, atomically. Throws Error(file) if it cannot be written.
void write_spectrum_plot(const std::filesystem::path& path, const WaveSpectrum& record);

}  // namespace offing::cli
