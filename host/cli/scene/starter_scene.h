#pragma once

#include <string>
#include <string_view>

namespace offing::cli {

/// The text of a scene to start from, which its comments explain: a sea with wind, camera and sun. `file` is
/// the name that the comments call it by.
std::string starter_scene(std::string_view file);

}  // namespace offing::cli
