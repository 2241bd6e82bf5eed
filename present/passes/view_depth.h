#pragma once

namespace offing::present {

/// Distance of the near plane along the line of sight. Depth is reversed: near_m over that distance, 1 there
/// and 0 at infinity.
inline constexpr double near_m = 0.05;

}  // namespace offing::present
