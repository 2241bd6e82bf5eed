#pragma once

#include <string_view>

namespace offing::scene {

/// Version of Offing, "1.2.3", as stored in what it writes.
std::string_view version();

}  // namespace offing::scene
