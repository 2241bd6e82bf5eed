#pragma once

#include <string>

#include "host/scene/model/scene.h"

namespace offing::present {

/// What an edit between two scenes did, in a few words: "Wind: speed", "add boat". Moves of the camera are no
/// edits.
std::string edit_words(const scene::Scene& before, const scene::Scene& after);

}  // namespace offing::present
