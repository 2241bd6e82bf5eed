#pragma once

#include <filesystem>
#include <string_view>

namespace offing {

/// Whether files that a file leads to (buffers of a glTF, sources of a VRT, companions of a spectrum, links)
/// may lie anywhere, or only in the folder of that file or below it.
enum class Trust { trusted, untrusted };

/// What a raster may lead to.
struct FileTrust {
  Trust trust = Trust::trusted;
  bool is_named_by_scene = false;  ///< and not by a person: then it may not be a VRT
};

/// Whether a name is an address of a server or of one of GDAL's own file systems ("/vsicurl/...").
bool is_address(std::string_view name);

/// Throws Error(bad_input) unless `file`, with all links followed, lies in `folder` or below it. A file that
/// is not there is judged by its name.
void require_below(const std::filesystem::path& folder, const std::filesystem::path& file);

/// The same for a file that `leader` leads to, with the leader's folder. Does nothing for Trust::trusted.
void require_beside(const std::filesystem::path& leader, const std::filesystem::path& file, Trust trust);

}  // namespace offing
