#pragma once

#include <array>
#include <vector>

#include "host/base/cloud_volume.h"

namespace offing::clouds {

/// One a value of a field's density, in its order: the albedo that a shape has there, between the middles of
/// its cells, by the density that each has. Both volumes in the same axes; the shape tells albedos.
std::vector<std::array<float, 3>> field_albedo(const CloudVolume& shape, const CloudVolume& field);

}  // namespace offing::clouds
