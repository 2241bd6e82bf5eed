#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>

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

}  // namespace offing
