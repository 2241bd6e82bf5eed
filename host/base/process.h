#pragma once

#include <functional>

#include "host/base/cancel_token.h"

namespace offing {

/// Throws Error(file) if what was printed to standard output did not arrive.
void finish_output();

/// What main() of every program returns: the status of `work`, or, for whatever it throws, the exit code of
/// an error that is reported on stderr.
///
/// From here on the first SIGINT or SIGTERM cancels the token that `work` gets, which lives as long as the
/// process; the second one ends the process at once.
int run_program(const std::function<int(const CancelToken&)>& work);

}  // namespace offing
