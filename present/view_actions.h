#pragma once

#include "present/key_bindings.h"
#include "present/panels.h"

namespace offing::present {

/// Does what a key asks of the view alone: panels, time and what is shown. False for all other actions.
bool change_view(ViewAction action, ViewState& state);

}  // namespace offing::present
