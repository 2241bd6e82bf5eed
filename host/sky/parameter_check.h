#pragma once

#include <string_view>

namespace offing::sky {

/// offing::require_within(); `name` carries section and unit.
void require_within(std::string_view name, double value, double low, double high);

}  // namespace offing::sky
