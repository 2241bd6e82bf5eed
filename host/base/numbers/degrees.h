#pragma once

#include <numbers>

namespace offing {

inline constexpr double radians_per_degree = std::numbers::pi / 180.0;

}  // namespace offing
