#pragma once

#include <filesystem>
#include <string_view>

/// The marks that files begin with.
namespace offing {

/// A text without the mark of UTF-8 that Windows programs write at its begin.
constexpr std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view mark = "\xef\xbb\xbf";
  if (text.starts_with(mark)) text.remove_prefix(mark.size());
  return text;
}

/// Whether a file, or its bytes, are HDF5, and so perhaps NetCDF-4.
bool is_hdf5_file(const std::filesystem::path& path);
bool is_hdf5(std::string_view bytes);

}  // namespace offing
