#pragma once

#include <array>
#include <vector>

#include "kernels/shared/clouds.h"

namespace offing::clouds {

/// Heights of the surface of a billboard over its billboard, from noise:
/// [CLOUD_TEXTURE_SIZE][CLOUD_TEXTURE_SIZE] row-major, of no unit, about 0 ... 1.
using BillboardHeights = std::vector<float>;

/// Round lumps that carry smaller ones, with creases between: a cauliflower. `texture` says which one.
BillboardHeights lumpy_heights(int texture);

/// Wisps that the wind has drawn out.
BillboardHeights wispy_heights(int texture);

}  // namespace offing::clouds
