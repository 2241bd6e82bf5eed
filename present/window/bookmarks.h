#pragma once

#include <cstddef>
#include <string>

#include "host/scene/model/scene.h"

namespace offing::present {

// Bookmarks of a scene count from 1, as the keys do that go to them.

/// Makes the camera's place and angles those of a bookmark, or of a new one behind the last where there are
/// not so many; says which. Throws Error(bad_input) where a scene takes no more.
std::string set_bookmark(scene::Scene& scene, const Camera& camera, std::size_t number);

/// Puts a camera where a bookmark is, with the picture's size as it is; says which it was. Throws
/// Error(bad_usage) where there are not so many.
std::string go_to_bookmark(const scene::Scene& scene, std::size_t number, Camera& camera);

}  // namespace offing::present
