#include "host/ocl/disk_cache.h"

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

// In front of each entry's content. Read and written on one machine only, so the byte order is the machine's.
struct EntryHeader {
  std::array<char, 8> magic;
  std::uint64_t key_low;
  std::uint64_t key_high;
  std::uint64_t content_bytes;
  std::uint64_t checksum;  // XXH3 of the content
};
static_assert(sizeof(EntryHeader) == 40);

XXH128_hash_t key_of(std::string_view identity) {
  return XXH3_128bits_withSeed(identity.data(), identity.size(), format_version);
}

EntryHeader header_of(std::string_view identity, const std::vector<std::uint8_t>& content) {
  const XXH128_hash_t key = key_of(identity);
  return {magic, key.low64, key.high64, content.size(), XXH3_64bits(content.data(), content.size())};
}

// What a name of entry_path() has behind its 32 hexadecimal digits; empty for other names.
std::string_view behind_key(std::string_view name) {
  constexpr std::size_t key_digits = 32;
  const bool is_entry = name.size() > key_digits && name.find_first_not_of("0123456789abcdef") == key_digits;
  return is_entry ? name.substr(key_digits) : std::string_view();
}

// <key>.<ending>.<process>.<count>.tmp, as store() names them.
bool is_temporary_name(std::string_view name, std::string_view ending) {
  return behind_key(name).starts_with(fmt::format(".{}.", ending)) && name.ends_with(".tmp");
}

void report_unwritable(const fs::path& folder, const CacheKind& kind, const std::string& reason) {
  static std::atomic<bool> was_reported{false};
  if (was_reported.exchange(true)) return;
  spdlog::warn("cannot store {}s in {}: {}; each start makes them again (set OFFING_CACHE_DIR)", kind.noun,
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
void remove_stale_temporaries(const fs::path& folder, std::string_view ending) {
  const auto oldest = fs::file_time_type::clock::now() - std::chrono::hours(1);
  std::error_code listing, ignored;
  for (fs::directory_iterator entry(folder, listing), end; !listing && entry != end;
       entry.increment(listing)) {
    if (!is_temporary_name(entry->path().filename().string(), ending)) continue;
    const fs::file_time_type written = entry->last_write_time(ignored);
    if (!ignored && written < oldest) fs::remove(entry->path(), ignored);
  }
}

// Removes entries that were not used for longest until the others take no more than the kind allows. `kept`
// stays.
void remove_old_entries(const fs::path& folder, const CacheKind& kind, const fs::path& kept) {
  if (kind.most_bytes == std::numeric_limits<std::uint64_t>::max()) return;
  struct Entry {
    fs::path path;
    fs::file_time_type used;
    std::uint64_t bytes;
  };
  std::vector<Entry> entries;
  std::uint64_t bytes = 0;
  std::error_code listing, error;
  for (fs::directory_iterator entry(folder, listing), end; !listing && entry != end;
       entry.increment(listing)) {
    if (behind_key(entry->path().filename().string()) != fmt::format(".{}", kind.ending)) continue;
    const fs::file_time_type used = entry->last_write_time(error);
    if (error) continue;
    const std::uint64_t its_bytes = entry->file_size(error);
    if (error) continue;
    bytes += its_bytes;
    if (entry->path() != kept) entries.push_back({entry->path(), used, its_bytes});
  }
  std::ranges::sort(entries, {}, &Entry::used);
  for (const Entry& entry : entries) {
    if (bytes <= kind.most_bytes) return;
    fs::remove(entry.path, error);
    // Another program may have removed it first.
    if (!error) bytes -= entry.bytes;
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

std::string identity_of_bytes(std::span<const std::byte> bytes) {
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

fs::path DiskCache::default_folder() {
  if (const char* own = std::getenv("OFFING_CACHE_DIR")) return own;
  const char* xdg = std::getenv("XDG_CACHE_HOME");
  if (xdg != nullptr && *xdg == '/') return fs::path(xdg) / "offing";  // the XDG rules ignore relative paths
  const char* home = std::getenv("HOME");
  if (home != nullptr && *home == '/') return fs::path(home) / ".cache" / "offing";
  return {};
}

DiskCache::DiskCache(fs::path folder, const CacheKind& kind) : folder_(std::move(folder)), kind_(kind) {}

fs::path DiskCache::entry_path(std::string_view identity) const {
  const XXH128_hash_t key = key_of(identity);
  return folder_ / fmt::format("{:016x}{:016x}.{}", key.high64, key.low64, kind_.ending);
}

std::optional<std::vector<std::uint8_t>> DiskCache::load(std::string_view identity) const {
  if (folder_.empty() || !trouble_with_folder(folder_).empty()) return std::nullopt;
  const fs::path path = entry_path(identity);
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) return std::nullopt;
  const auto file_bytes = static_cast<std::uint64_t>(std::max<std::streamoff>(file.tellg(), 0));
  EntryHeader header{};
  std::vector<std::uint8_t> content;
  file.seekg(0);
  if (file_bytes > sizeof header && file.read(reinterpret_cast<char*>(&header), sizeof header) &&
      header.content_bytes == file_bytes - sizeof header) {
    content.resize(header.content_bytes);
    file.read(reinterpret_cast<char*>(content.data()), static_cast<std::streamsize>(content.size()));
  }
  const EntryHeader expected = header_of(identity, content);
  if (!file || content.empty() || std::memcmp(&header, &expected, sizeof header) != 0) {
    spdlog::warn("{} {} is damaged: rebuilding it", kind_.noun, path.string());
    return std::nullopt;
  }
  if (kind_.most_bytes < std::numeric_limits<std::uint64_t>::max()) {
    std::error_code ignored;
    fs::last_write_time(path, fs::file_time_type::clock::now(), ignored);
  }
  return content;
}

void DiskCache::store(std::string_view identity, const std::vector<std::uint8_t>& content) const {
  if (folder_.empty() || content.empty()) return;
  if (const std::string trouble = make_private_folder(folder_); !trouble.empty()) {
    return report_unwritable(folder_, kind_, trouble);
  }
  remove_stale_temporaries(folder_, kind_.ending);
  const fs::path path = entry_path(identity);
  fs::path temporary;
  std::FILE* const file = create_temporary(path, temporary);
  if (file == nullptr) return report_unwritable(folder_, kind_, std::strerror(errno));
  const EntryHeader header = header_of(identity, content);
  const bool is_written = std::fwrite(&header, sizeof header, 1, file) == 1 &&
                          std::fwrite(content.data(), 1, content.size(), file) == content.size();
  std::error_code error;
  if (std::fclose(file) != 0 || !is_written) {
    fs::remove(temporary, error);
    return report_unwritable(folder_, kind_, "the file cannot be written");
  }
  fs::rename(temporary, path, error);
  if (error) {
    const std::string reason = error.message();
    fs::remove(temporary, error);
    return report_unwritable(folder_, kind_, reason);
  }
  remove_old_entries(folder_, kind_, path);
}

}  // namespace offing::ocl
