#pragma once

namespace offing {

/// Gives memory that was freed back to the system, as far as whole pages are free. Milliseconds: for after
/// something large is gone, not for each frame. Does nothing where the C library is not glibc.
void give_back_freed_memory();

/// Keeps arrays of a mebibyte and more out of the heap from now on, in pages of their own that go back to the
/// system with them: for a program that makes and drops large things for hours. It pays with fresh pages for
/// each such array, so that those of every frame are better kept. Does nothing where the C library is not
/// glibc.
void keep_large_arrays_apart();

}  // namespace offing
