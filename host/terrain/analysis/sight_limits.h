#pragma once

#include <cstdint>
#include <numbers>
#include <span>

#include "host/terrain/analysis/viewshed.h"
#include "host/terrain/field/post_grid.h"

namespace offing::terrain {

/// Where an observer looks, beside what hides what is there: within these angles, both ends included.
struct SightLimits {
  /// Clockwise from north, of the line in plan; from one to the other, so that 350 to 10 degrees are 20, and
  /// 300 to -90 are 330. Two that are 2 pi apart are the whole turn.
  double azimuth_from_rad = 0.0, azimuth_to_rad = 2.0 * std::numbers::pi;
  /// Of the line from the eye to the target, up from level.
  double lowest_rad = -0.5 * std::numbers::pi, highest_rad = 0.5 * std::numbers::pi;
};

/// What a byte of a viewshed says of a post that is beyond the radius or the limits, where that is asked for.
inline constexpr std::uint8_t sight_outside = 128;

/// Throws Error(bad_input) that names the angle unless they are finite and lowest_rad is below highest_rad.
void require_valid(const SightLimits& limits);

/// Sets the bytes [rows][columns] of posts that are beyond the radius or the limits to `outside`. The
/// observer's own post, where there is one, is within every azimuth. Throws what require_valid() throws, for
/// the parameters too.
void mark_outside(const PostGrid& grid, std::span<const float> heights_m,
                  const ViewshedParameters& parameters, const SightLimits& limits, std::uint8_t outside,
                  std::span<std::uint8_t> seen);

}  // namespace offing::terrain
