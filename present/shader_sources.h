#pragma once

#include <span>
#include <string_view>

namespace offing::present {

/// One file under present/shaders/, embedded at build.
struct ShaderSource {
  std::string_view name;  ///< "water.frag"
  std::string_view text;  ///< the file, unchanged
};

/// Every embedded file: stages (.vert, .frag) and what several of them share (.glsl).
std::span<const ShaderSource> shader_sources();

}  // namespace offing::present
