#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "host/ocl/device.h"
#include "host/terrain/analysis/sight_limits.h"
#include "host/terrain/analysis/viewshed.h"
#include "host/terrain/field/height_field.h"

namespace offing::terrain {

/// One of several observers of a map.
struct Observer {
  ViewshedParameters parameters;
  SightLimits limits;
};

/// Calls take(index, seen) for each observer in order. seen [rows][columns] is what Viewshed finds, and
/// `outside` beyond the radius and the limits; take() may change it. Meanwhile the device looks from the next
/// observer. `heights_m` are those of the field, which is on the device. Throws what require_valid() throws
/// before it looks from any.
void look_from_each(const ocl::Device& device, const HeightField& field, std::span<const float> heights_m,
                    std::span<const Observer> observers, std::uint8_t outside,
                    const std::function<void(std::size_t, std::span<std::uint8_t>)>& take);

}  // namespace offing::terrain
