#pragma once

#include <functional>
#include <string_view>

#include "present/panels/panels.h"

namespace offing::present {

/// Tells all texts that panels may show in letters of any language: names, files, messages. What else they
/// show is ASCII.
void for_shown_names(const ViewState& state, const SceneList& scenes,
                     const std::function<void(std::string_view)>& tell);

}  // namespace offing::present
