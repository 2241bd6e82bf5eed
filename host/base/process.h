#pragma once

#include <functional>

#include "host/base/cancel_token.h"

namespace offing {

/// Throws Error(file) if what was printed to standard output did not arrive.
void finish_output();

/// What main() of every program returns: the status of `work`, or, for whatever it throws, the exit code of
/// an error that is reported on stderr.
///
/// From here on the first SIGINT, SIGTERM, SIGHUP or write to a pipe that nobody reads cancels the token that
/// `work` gets, which lives as long as the process. A process that is still there a second later ends at
/// once, and so it does at a second signal: unfinished files (unfinished_file.h) are removed. SIGHUP is left
/// alone where it was ignored (nohup); a broken pipe ends the program without a message.
int run_program(const std::function<int(const CancelToken&)>& work);

}  // namespace offing
