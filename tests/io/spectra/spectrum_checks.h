#pragma once

#include <complex>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "host/base/wave_spectrum.h"

namespace offing::test {

/// Expects everything that host/base/wave_spectrum.h promises of a WaveSpectrum.
void expect_contract(const WaveSpectrum& spectrum);

/// Circular moment of order n of row i, by the periodic rectangle rule: integral of D e^(i n theta) d theta.
std::complex<double> row_moment(const WaveSpectrum& spectrum, std::size_t i, int n);

/// Significant wave height 4 sqrt(m0), m.
double hs_m(const WaveSpectrum& spectrum);

/// Frequency of the largest energy, Hz.
double peak_frequency_hz(const WaveSpectrum& spectrum);

/// Where the waves come from on the whole, degrees clockwise from north, in [0, 360): direction of the first
/// moment of the energy.
double mean_from_deg(const WaveSpectrum& spectrum);

/// The smallest angle between two bearings, degrees.
double angle_between_deg(double a_deg, double b_deg);

/// Folder of the measured spectra, or nothing if OFFING_TEST_DATA is not set.
std::optional<std::filesystem::path> measured_spectra();

std::string read_text(const std::filesystem::path& path);
void write_text(const std::filesystem::path& path, const std::string& text);

}  // namespace offing::test
