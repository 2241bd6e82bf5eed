#pragma once

#include <string_view>

namespace offing {

/// Throws Error(bad_input) that names the parameter, its range and the value found, unless low <= value <=
/// high. NaN is outside every range; `name` carries section and unit: "ocean.depth_m".
void require_within(std::string_view name, double value, double low, double high);

}  // namespace offing
