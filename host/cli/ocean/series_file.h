#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "host/cli/ocean/query_text.h"
#include "host/io/atomic_file.h"
#include "host/io/spectra/netcdf_output.h"

namespace offing::cli {

/// A NetCDF file of answers with the names of the CF conventions (1.8, time series at points): each column of
/// answer_columns() is a variable (time, point), but the time (time) and the place (point). 32-bit floats
/// hold what the device answered, places and times are doubles. Whole or not at all.
class SeriesFile {
 public:
  /// How many answers there are in a time, and what the file says of them.
  struct Facts {
    std::size_t points = 1;
    std::string time_origin;  ///< ISO 8601: where times count from
    double depth_m = 0.0;
    double min_wavelength_m = 0.0;
    std::string scene_hash;
  };

  /// Throws Error(file).
  SeriesFile(const std::string& path, Existing existing, const Facts& facts);

  /// Answers come by time, and at each time in the order of the points.
  void add(const QueryAnswer& answer);
  /// Writes what was added, all of one time.
  void flush();
  /// Publishes the file.
  void finish();

 private:
  std::size_t points_;
  std::size_t first_ = 0;                     // answer that the next flush begins with
  std::vector<std::vector<double>> columns_;  // added since the last flush
  AtomicFile file_;
  std::unique_ptr<spectra::NetcdfOutput> output_;
};

}  // namespace offing::cli
