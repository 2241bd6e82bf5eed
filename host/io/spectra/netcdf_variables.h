#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace offing::spectra {

/// The values of these variables of a NetCDF file, which have one dimension or none; nothing for those that
/// it does not have. Throws Error(bad_input) naming file and variable.
std::vector<std::optional<std::vector<double>>> read_netcdf_variables(std::span<const std::byte> bytes,
                                                                      std::string_view file_name,
                                                                      std::span<const std::string> names);

/// A variable of any dimensions: numbers, or texts.
struct NetcdfArray {
  std::vector<std::string> dimensions;  ///< names, slowest first
  std::vector<std::size_t> lengths;
  std::vector<double> values;      ///< NaN where a value is missing; empty for texts
  std::vector<std::string> texts;  ///< strings, or rows of characters along the last dimension
};

/// The same for variables of any dimensions with up to 2^22 numbers or 4096 texts.
std::vector<std::optional<NetcdfArray>> read_netcdf_arrays(std::span<const std::byte> bytes,
                                                           std::string_view file_name,
                                                           std::span<const std::string> names);

}  // namespace offing::spectra
