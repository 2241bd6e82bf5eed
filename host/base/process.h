#pragma once

#include <functional>

#include "host/base/work.h"

/// How a program runs and ends: exit codes, signals, files that are not whole yet.
namespace offing {

/// Marks a file that is not whole yet, so that a signal that ends the process at once still removes it: no
/// destructor runs then. The first 256 at a time are marked, others stay where they are. `path` must stay as
/// it is, and where it is, until it is unmarked.
void mark_unfinished(const char* path) noexcept;
void unmark_unfinished(const char* path) noexcept;

/// Removes all marked files, for a process that ends next: whoever unmarks one of them waits for that. Safe
/// to call in a signal handler.
void remove_unfinished_files() noexcept;

/// Throws Error(file) if what was printed to standard output did not arrive.
void finish_output();

/// What main() of every program returns: the status of `work`, or, for whatever it throws, the exit code of
/// an error that is reported on stderr.
///
/// From here on the first SIGINT, SIGTERM, SIGHUP or write to a pipe that nobody reads cancels the token that
/// `work` gets, which lives as long as the process. A process that is still there a second later ends at
/// once, and so it does at a second signal: unfinished files (mark_unfinished()) are removed. SIGHUP is left
/// alone where it was ignored (nohup); a broken pipe ends the program without a message.
int run_program(const std::function<int(const CancelToken&)>& work);

}  // namespace offing
