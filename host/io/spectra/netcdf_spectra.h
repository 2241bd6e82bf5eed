#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "host/base/wave_spectrum.h"

namespace offing::spectra {

/// Spectra of WAVEWATCH III, SWAN and wavespectra in NetCDF, classic or NetCDF-4: one spectrum a time and place that holds
/// data, times slowest.
///
/// The density is the variable efth (WAVEWATCH III), density, energy or VaDens (SWAN), with dimensions
/// frequency and direction and any others (time, station, points, latitude, longitude ...), in any order.
/// Units are read, not guessed: m2 s or m2/Hz by rad or degree, or the same of J/m2 (divided by 1025 kg/m^3
/// x 9.81 m/s^2); frequency in Hz or rad/s; direction in degrees or radians. Its standard_name says whether
/// waves come from there or go there; a "to" direction is clockwise from north, unless the file's
/// Directional_convention is cartesian. efth without a standard_name goes to. SWAN's packed density times
/// scale_density, _FillValue, scale_factor and add_offset are applied. A frequency with a missing density is
/// left out of its record; places with fewer than two remain out.
///
/// The header of a classic file is checked before libnetcdf sees it; what NetCDF-4 files do to libhdf5 is
/// beyond Offing, so open none that you do not trust.
///
/// wavespectra writes efth (time, freq, dir), mostly without attributes of the axes. What its axes and efth
/// leave open is what wavespectra reads: Hz, degrees that waves come from, m^2/Hz/degree.
///
/// energy_1d or ef without directions gives non-directional spectra; SWAN's theta_1d and spread_1d beside it
/// leave their conventions open and are not read, which is logged as a warning. Throws Error(bad_input)
/// naming file and variable. Source: WAVEWATCH III manual (ww3_ounp); SWAN user manual (NetCDF output); CF
/// conventions 1.5; wavespectra 4.9, read_wavespectra.
std::vector<WaveSpectrum> parse_netcdf(std::span<const std::byte> bytes, std::string_view file_name);

}  // namespace offing::spectra
