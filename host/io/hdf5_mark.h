#pragma once

#include <filesystem>
#include <string_view>

namespace offing {

/// Whether a file, or its bytes, are HDF5, and so perhaps NetCDF-4.
bool is_hdf5_file(const std::filesystem::path& path);
bool is_hdf5(std::string_view bytes);

}  // namespace offing
