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

}  // namespace offing::spectra
