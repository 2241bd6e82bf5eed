#pragma once

#include "present/gl/gl_objects.h"

namespace offing::present {

/// Side of the tile that foam_texture() covers, m.
inline constexpr float foam_tile_m = 9.0f;

/// Values of foam_texture() are within this of 0.
inline constexpr double foam_value_limit = 4.0;

/// A repeating picture of how foam breaks up into threads and cells, with mip levels: values of a standard
/// normal distribution, as 0 ... 1 for -foam_value_limit ... foam_value_limit, and their squares, as 0 ... 1
/// for 0 ... foam_value_limit^2. A mip level's squares tell the variance that it hides (Olano and Baker
/// 2010).
GlTexture foam_texture();

}  // namespace offing::present
