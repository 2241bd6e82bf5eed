#pragma once

#include <functional>

#include "host/base/cancel_token.h"

namespace offing {

/// The first Ctrl-C or kill cancels the token, which ends work after the step at hand; the second one ends
/// the process at once. `token` must live as long as the process.
void cancel_on_signals(CancelToken& token);

/// Throws Error(file) if what was printed to standard output did not arrive.
void finish_output();

/// What main() of every program returns: the status of `work`, or, for whatever it throws, the exit code of
/// an error that is reported on stderr.
int run_program(const std::function<int()>& work);

}  // namespace offing
