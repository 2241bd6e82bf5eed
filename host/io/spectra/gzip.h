#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace offing::spectra {

/// Without the .gz of a compressed file.
std::filesystem::path unpacked_name(const std::filesystem::path& path);

bool is_gzip(std::string_view bytes);

/// What a gzip file (RFC 1952) holds, of all its members. Throws Error(bad_input) that names the file if it
/// is damaged, cut short, or unpacks to more than `most_bytes`: a thousand times the packed size is possible.
std::string unpack_gzip(std::string_view bytes, std::string_view file_name, std::size_t most_bytes);

}  // namespace offing::spectra
