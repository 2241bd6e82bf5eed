#pragma once

#include <cstddef>
#include <vector>

#include "host/base/keyframes.h"
#include "host/scene/schema/parameter.h"

namespace offing::scene {

/// Of one value.
inline constexpr std::size_t most_keyframes = 10'000;

/// One keyframe of a value as it was written.
struct WrittenKeyframe {
  WrittenValue time, value;
  Place time_place, value_place;
};

/// Checks keyframes and stores them for a row that can have them, of the last element of a repeated section;
/// its constant value becomes that of the first one. At most most_keyframes keys, times within +-1e8 s.
/// Throws Error(bad_input) for a row that cannot have any, no keys or too many, times that do not increase,
/// and values as store() does.
void store_track(Scene& scene, const Parameter& parameter, const std::vector<WrittenKeyframe>& written,
                 Interpolation interpolation, const Place& place);

}  // namespace offing::scene
