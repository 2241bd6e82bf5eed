#pragma once

#include <string>

#include "host/scene/model/scene.h"

namespace offing::present {

/// What the edit that made `after` of `before` did, in a few words: "Wind: speed", "add boat". Camera moves
/// are not edits.
std::string edit_words(const scene::Scene& before, const scene::Scene& after);

}  // namespace offing::present
