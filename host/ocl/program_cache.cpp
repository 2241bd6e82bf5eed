#include "host/ocl/program_cache.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include "host/base/log.h"
#include "host/ocl/private_folder.h"

namespace offing::ocl {
namespace {

namespace fs = std::filesystem;

// Raised when the layout of an entry changes; part of the name, so that versions live side by side.
constexpr std::uint32_t format_version = 1;
constexpr std::array<char, 8> magic{'O', 'F', 'F', 'P', 'R', 'O', 'G', '\n'};

// In front of each binary. Read and written on one machine only, so the byte order is the machine's.
struct EntryHeader {
  std::array<char, 8> magic;
  std::uint64_t key_low;
  std::uint64_t key_high;
  std::uint64_t binary_bytes;
  std::uint64_t checksum;  // XXH3 of the binary
};
static_assert(sizeof(EntryHeader) == 40);

XXH128_hash_t key_of(std::string_view identity) {
  return XXH3_128bits_withSeed(identity.data(), identity.size(), format_version);
}

EntryHeader header_of(std::string_view identity, const std::vector<std::uint8_t>& binary) {
  const XXH128_hash_t key = key_of(identity);
  return {magic, key.low64, key.high64, binary.size(), XXH3_64bits(binary.data(), binary.size())};
}

// <32 hexadecimal digits>.program.<process>.<count>.tmp, as store() names them.
bool is_temporary_name(std::string_view name) {
  constexpr std::size_t key_digits = 32;
  return name.size() > key_digits && name.find_first_not_of("0123456789abcdef") == key_digits &&
         name.substr(key_digits).starts_with(".program.") && name.ends_with(".tmp");
}

void report_unwritable(const fs::path& folder, const std::string& reason) {
  static std::atomic<bool> was_reported{false};
  if (was_reported.exchange(true)) return;
  spdlog::warn(
      "cannot store compiled kernels in {}: {}; each start compiles them again (set OFFING_CACHE_DIR)",
      folder.string(), reason);
}

// A new file that nobody else has opened, by a name with the number of this process; null if there is none.
std::FILE* create_temporary(const fs::path& entry, fs::path& temporary) {
  static std::atomic<unsigned> counter{0};
  for (;;) {
    temporary = fmt::format("{}.{}.{}.tmp", entry.string(), getpid(), counter++);
    const int descriptor =
        open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600);
    if (descriptor >= 0) return fdopen(descriptor, "wb");
    if (errno != EEXIST && errno != EINTR) return nullptr;
  }
}

// Removes what killed processes left half-written. No write takes an hour, so that those of living processes
// stay; what cannot be looked at or removed is left alone.
void remove_stale_temporaries(const fs::path& folder) {
  const auto oldest = fs::file_time_type::clock::now() - std::chrono::hours(1);
  std::error_code listing, ignored;
  for (fs::directory_iterator entry(folder, listing), end; !listing && entry != end;
       entry.increment(listing)) {
    if (!is_temporary_name(entry->path().filename().string())) continue;
    const fs::file_time_type written = entry->last_write_time(ignored);
    if (!ignored && written < oldest) fs::remove(entry->path(), ignored);
  }
}

}  // namespace

std::string joined_identity(std::initializer_list<std::string_view> parts) {
  std::string identity;
  for (const std::string_view part : parts) {
    identity += part;
    identity += '\0';
  }
  return identity;
}

std::string driver_identity(const DeviceInfo& info) {
  return joined_identity({info.platform, info.platform_version, info.name, info.vendor, info.device_version,
                          info.driver_version});
}

fs::path ProgramCache::default_folder() {
  if (const char* own = std::getenv("OFFING_CACHE_DIR")) return own;
  const char* xdg = std::getenv("XDG_CACHE_HOME");
  if (xdg != nullptr && *xdg == '/') return fs::path(xdg) / "offing";  // the XDG rules ignore relative paths
  const char* home = std::getenv("HOME");
  if (home != nullptr && *home == '/') return fs::path(home) / ".cache" / "offing";
  return {};
}

ProgramCache::ProgramCache(fs::path folder) : folder_(std::move(folder)) {}

fs::path ProgramCache::entry_path(std::string_view identity) const {
  const XXH128_hash_t key = key_of(identity);
  return folder_ / fmt::format("{:016x}{:016x}.program", key.high64, key.low64);
}

std::optional<std::vector<std::uint8_t>> ProgramCache::load(std::string_view identity) const {
  if (folder_.empty() || !trouble_with_folder(folder_).empty()) return std::nullopt;
  const fs::path path = entry_path(identity);
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) return std::nullopt;
  const auto file_bytes = static_cast<std::uint64_t>(std::max<std::streamoff>(file.tellg(), 0));
  EntryHeader header{};
  std::vector<std::uint8_t> binary;
  file.seekg(0);
  if (file_bytes > sizeof header && file.read(reinterpret_cast<char*>(&header), sizeof header) &&
      header.binary_bytes == file_bytes - sizeof header) {
    binary.resize(header.binary_bytes);
    file.read(reinterpret_cast<char*>(binary.data()), static_cast<std::streamsize>(binary.size()));
  }
  const EntryHeader expected = header_of(identity, binary);
  if (!file || binary.empty() || std::memcmp(&header, &expected, sizeof header) != 0) {
    spdlog::warn("compiled kernel {} is damaged: rebuilding it", path.string());
    return std::nullopt;
  }
  return binary;
}

void ProgramCache::store(std::string_view identity, const std::vector<std::uint8_t>& binary) const {
  if (folder_.empty() || binary.empty()) return;
  if (const std::string trouble = make_private_folder(folder_); !trouble.empty()) {
    return report_unwritable(folder_, trouble);
  }
  remove_stale_temporaries(folder_);
  const fs::path path = entry_path(identity);
  fs::path temporary;
  std::FILE* const file = create_temporary(path, temporary);
  if (file == nullptr) return report_unwritable(folder_, std::strerror(errno));
  const EntryHeader header = header_of(identity, binary);
  const bool is_written = std::fwrite(&header, sizeof header, 1, file) == 1 &&
                          std::fwrite(binary.data(), 1, binary.size(), file) == binary.size();
  std::error_code error;
  if (std::fclose(file) != 0 || !is_written) {
    fs::remove(temporary, error);
    return report_unwritable(folder_, "the file cannot be written");
  }
  fs::rename(temporary, path, error);
  if (error) {
    const std::string reason = error.message();
    fs::remove(temporary, error);
    report_unwritable(folder_, reason);
  }
}

}  // namespace offing::ocl
