#pragma once

#include "host/base/cancel_token.h"
#include "present/view_options.h"

namespace offing::present {

/// Shows the scene of the options in a window until it is closed, Esc is pressed or the token is cancelled;
/// with a recording, until its last frame is written. Throws Error(no_device) where no window can be had.
void show_window(const ViewOptions& options, const CancelToken& cancel);

}  // namespace offing::present
