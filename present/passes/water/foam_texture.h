#pragma once

#include "present/gl/gl_objects.h"

namespace offing::present {

/// Side of the tile that foam_texture() covers, m.
inline constexpr float foam_tile_m = 9.0f;

/// A repeating picture of how foam breaks up into threads and cells, one channel with mip levels: values are
/// even between 0 and 1, so that a share c of them lies above 1 - c.
GlTexture foam_texture();

}  // namespace offing::present
