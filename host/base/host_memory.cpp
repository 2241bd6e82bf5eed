#include "host/base/host_memory.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "host/base/error.h"

namespace offing {
namespace {

namespace fs = std::filesystem;

// The number that follows `label` at the start of a line.
std::optional<std::uint64_t> number_after(const fs::path& file, std::string_view label) {
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(label)) return std::strtoull(line.c_str() + label.size(), nullptr, 10);
  }
  return std::nullopt;
}

std::optional<std::uint64_t> meminfo_bytes(std::string_view label) {
  const auto kibibytes = number_after("/proc/meminfo", label);
  return kibibytes ? std::optional(*kibibytes * 1024) : std::nullopt;
}

std::optional<std::uint64_t> number_in(const fs::path& file) {
  std::uint64_t value = 0;
  return std::ifstream(file) >> value ? std::optional(value) : std::nullopt;  // "max" is no number
}

// This process' group below the root of cgroup v2, as "/user.slice/..."; in a container mostly "/".
fs::path own_group() {
  std::ifstream groups("/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    constexpr std::string_view unified = "0::";
    if (line.starts_with(unified)) return line.substr(unified.size());
  }
  return "/";
}

// What a limit of this process (`ulimit -v`, `ulimit -d`) leaves beside `used_pages`.
std::uint64_t left_of_limit(decltype(RLIMIT_AS) resource, std::uint64_t used_pages) {
  rlimit limit{};
  if (getrlimit(resource, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unlimited_bytes;
  const std::uint64_t used = used_pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
  return limit.rlim_cur - std::min<std::uint64_t>(limit.rlim_cur, used);
}

std::uint64_t left_of_limits() {
  std::uint64_t size = 0, resident = 0, shared = 0, text = 0, libraries = 0, data = 0;
  if (!(std::ifstream("/proc/self/statm") >> size >> resident >> shared >> text >> libraries >> data))
    return unlimited_bytes;
  return std::min(left_of_limit(RLIMIT_AS, size), left_of_limit(RLIMIT_DATA, data));
}

}  // namespace

std::uint64_t total_host_memory_bytes() {
  return meminfo_bytes("MemTotal:").value_or(0);
}

std::uint64_t available_in_group_bytes(const fs::path& group) {
  const auto limit = number_in(group / "memory.max");
  if (!limit) return unlimited_bytes;
  const std::uint64_t used = number_in(group / "memory.current").value_or(0);
  const fs::path statistics = group / "memory.stat";
  const std::uint64_t given_back = number_after(statistics, "inactive_file ").value_or(0) +
                                   number_after(statistics, "active_file ").value_or(0);
  const std::uint64_t kept = used - std::min(used, given_back);
  return *limit - std::min(*limit, kept);
}

std::uint64_t available_host_memory_bytes() {
  std::uint64_t available =
      std::min(left_of_limits(), meminfo_bytes("MemAvailable:").value_or(unlimited_bytes));
  // Each group up to the root may have a limit; what another namespace hides has no files here.
  const fs::path root = "/sys/fs/cgroup";
  for (fs::path group = own_group().lexically_normal();; group = group.parent_path()) {
    available = std::min(available, available_in_group_bytes(root / group.relative_path()));
    if (!group.has_relative_path()) return available;
  }
}

void require_host_memory(double bytes, const std::string& what, const std::string& hint) {
  const auto available = static_cast<double>(available_host_memory_bytes());
  if (bytes <= available) return;
  constexpr double bytes_per_gb = 1e9;
  throw Error(ErrorKind::out_of_memory,
              fmt::format("{} need {:.2f} GB of memory, {:.2f} GB are free", what, bytes / bytes_per_gb,
                          available / bytes_per_gb),
              hint);
}

// By itself glibc gives back what lies at the end of its heap, and arrays that were large enough for pages of
// their own when they were allocated. The first such array that is freed raises that size, up to 32 MiB, so
// that from then on most arrays lie in the heap, where any small block behind them keeps them. After a pass
// through 30 scenes a window of the first one held 551 MB so, and 352 MB once they were given back; what was
// in use stayed the same from pass to pass.
void give_back_freed_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

void keep_large_arrays_apart() {
#ifdef __GLIBC__
  constexpr int mebibyte = 1 << 20;
  mallopt(M_MMAP_THRESHOLD, mebibyte);  // which also ends that the threshold grows by itself
#endif
}

}  // namespace offing
