#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/utc_time.h"

namespace offing::spectra {

/// What the columns of an NDBC spectral text file hold. Historical files do not say: their name does.
enum class NdbcQuantity { unstated, energy, alpha1, alpha2, r1, r2 };

/// One value at one frequency; no value if the file has its mark for missing data.
struct NdbcSample {
  double frequency_hz;
  std::optional<double> value;
};

struct NdbcRow {
  UtcTime time;
  std::size_t line_number;
  std::vector<NdbcSample> samples;  ///< frequencies strictly increasing
};

/// An NDBC spectral text file as it stands: realtime ("value (frequency)" pairs, .data_spec, .swdir ...) or
/// historical (frequencies in the header; with or without minutes, years of two or four digits).
struct NdbcTable {
  NdbcQuantity quantity = NdbcQuantity::unstated;
  std::vector<NdbcRow> rows;  ///< in file order
};

/// Values of 999 and above are missing, as is "MM", as is a whole row of 99 (older files).
/// Throws Error(bad_input) with file and line.
NdbcTable parse_ndbc_table(std::string_view text, std::string_view file_name);

}  // namespace offing::spectra
