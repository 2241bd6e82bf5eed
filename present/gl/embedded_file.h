#pragma once

#include <string_view>

namespace offing::present {

/// A file of the sources, embedded at build (kernels/embed_sources.cmake).
struct EmbeddedFile {
  std::string_view name;  ///< "water/water.frag"
  std::string_view text;  ///< the file, unchanged
};

}  // namespace offing::present
