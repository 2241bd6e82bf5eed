#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>

/// Memory of this machine: what is left of it, and giving it back.
namespace offing {

/// Memory without a limit.
constexpr std::uint64_t unlimited_bytes = std::numeric_limits<std::uint64_t>::max();

/// All memory of this machine; 0 if the system does not say.
std::uint64_t total_host_memory_bytes();

/// Host memory that can still be used without swapping or breaking a memory limit of this process (`ulimit
/// -v`, `ulimit -d`) or of its control groups; unlimited_bytes if the system does not say. File pages that
/// the kernel would give back at once count as free: a long bake fills a container's limit with the files it
/// wrote.
std::uint64_t available_host_memory_bytes();

/// Throws Error(out_of_memory) with both figures where this much is not available: the kernel would kill the
/// process later, in the middle of its work. `what` begins the message, "terrain.posts: 16384 x 16384 posts".
void require_host_memory(double bytes, const std::string& what, const std::string& hint);

/// What the control group of this folder (files memory.max, memory.current and memory.stat of cgroup v2) lets
/// its processes still use; unlimited_bytes where it has no limit.
std::uint64_t available_in_group_bytes(const std::filesystem::path& group);

/// Gives memory that was freed back to the system, as far as whole pages are free. Milliseconds: for after
/// something large is gone, not for each frame. Does nothing where the C library is not glibc.
void give_back_freed_memory();

/// Keeps arrays of a mebibyte and more out of the heap from now on, in pages of their own that go back to the
/// system with them: for a program that makes and drops large things for hours. It pays with fresh pages for
/// each such array, so that those of every frame are better kept. Does nothing where the C library is not
/// glibc.
void keep_large_arrays_apart();

}  // namespace offing
