#pragma once

namespace offing {

/// Marks a file that is not whole yet, so that a signal that ends the process at once still removes it: no
/// destructor runs then. The first 256 at a time are marked, others stay where they are. `path` must stay as
/// it is, and where it is, until it is unmarked.
void mark_unfinished(const char* path) noexcept;
void unmark_unfinished(const char* path) noexcept;

/// Removes all marked files, for a process that ends next: whoever unmarks one of them waits for that. Safe
/// to call in a signal handler.
void remove_unfinished_files() noexcept;

}  // namespace offing
