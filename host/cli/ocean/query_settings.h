#pragma once

#include <cstdint>
#include <string_view>

#include "host/ocean/query/water_query.h"
#include "host/scene/schema/parameter.h"

namespace offing::cli {

/// Times first, first + step, ... `count` of them.
struct TimeRange {
  double first_s = 0.0, step_s = 0.0;
  std::int64_t count = 1;

  double time_s(std::int64_t index) const { return first_s + static_cast<double>(index) * step_s; }
};

/// "A:B:DT" in s: from A to B, both included where DT meets it. Throws Error(bad_usage), whose hint has the
/// example, unless A <= B, DT > 0, |A| and |B| are within largest_time_s and there are at most 1e7 of them.
TimeRange read_time_range(std::string_view flag, std::string_view text,
                          std::string_view example = "0:60:0.5");

/// The facts of --velocity-depth-m. Commands narrow its range to the depth of the water.
scene::Parameter velocity_depth_facts(std::string_view help);

/// "X,Z" in m. Throws Error(bad_usage) unless both are within farthest_point_m.
ocean::WaterPoint read_point(std::string_view flag, std::string_view text);

}  // namespace offing::cli
