#pragma once

#include <span>

#include "present/gl/embedded_file.h"

namespace offing::present {

/// Every embedded file: stages (.vert, .frag) and what several of them share (.glsl).
std::span<const EmbeddedFile> shader_sources();

}  // namespace offing::present
