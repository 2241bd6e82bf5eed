#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "host/base/wave_spectrum.h"

namespace offing::spectra {

/// A text with the name that errors show.
struct NamedText {
  std::string_view text;
  std::string_view file_name;
};

/// The four files that hold the directions of an NDBC spectrum. alpha1 and alpha2 are degrees clockwise from
/// north where waves come *from*; r1 and r2 are in 0 to 1, or in hundredths (historical files): a file in
/// which any value exceeds 1.5 is in hundredths.
struct NdbcCompanions {
  std::optional<NamedText> alpha1;
  std::optional<NamedText> alpha2;
  std::optional<NamedText> r1;
  std::optional<NamedText> r2;

  bool has_directions() const { return alpha1 && r1; }
};

/// NDBC spectral densities, m^2/Hz: realtime .data_spec or historical text. One spectrum a row that holds
/// data, in file order (realtime files start with the newest).
///
/// A frequency whose density is marked missing is left out of its record; records with fewer than two remain
/// out as a whole. Rows of companions are matched by time, their values by frequency. Where alpha1, r1,
/// alpha2 and r2 are known, spreading is maximum_entropy_spreading(); with alpha1 and r1 alone,
/// cosine_power_spreading(); elsewhere that of the nearest frequency. Records without any direction are
/// non-directional.
///
/// Throws Error(bad_input) with file and line, also if no record holds data.
/// Source: NDBC Technical Document 96-01 (1996), and the file descriptions on ndbc.noaa.gov.
std::vector<WaveSpectrum> parse_ndbc(std::string_view text, std::string_view file_name,
                                     const NdbcCompanions& companions = {});

/// Where the companions of `path` would be.
struct NdbcCompanionPaths {
  std::filesystem::path alpha1;
  std::filesystem::path alpha2;
  std::filesystem::path r1;
  std::filesystem::path r2;
};

/// Realtime: `<station>.data_spec` goes with .swdir .swdir2 .swr1 .swr2. Historical: `<station>w<year>.txt`
/// goes with the letters d (alpha1), i (alpha2), j (r1) and k (r2) in place of the w. Nothing for other
/// names.
std::optional<NdbcCompanionPaths> ndbc_companion_paths(const std::filesystem::path& path);

}  // namespace offing::spectra
