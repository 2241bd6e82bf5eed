#pragma once

namespace offing {

/// Gives memory that was freed back to the system, as far as whole pages are free. Milliseconds: for after
/// something large is gone, not for each frame. Does nothing where the C library is not glibc.
void give_back_freed_memory();

}  // namespace offing
