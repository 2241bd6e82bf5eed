#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/ocl/device_list.h"

/// What takes long to compute, kept between runs: compiled programs, and results that depend on nothing else.
namespace offing::ocl {

/// The parts of an entry's identity as one string; '\0' keeps neighbours apart.
std::string joined_identity(std::initializer_list<std::string_view> parts);
/// Everything about a device and its driver that shapes what is compiled for it.
std::string driver_identity(const DeviceInfo& info);

/// A 128-bit hash of bytes, for identities of what depends on much.
std::string identity_of_bytes(std::span<const std::byte> bytes);

/// What a cache keeps.
struct CacheKind {
  std::string_view ending;   ///< of its files, without the dot
  std::string_view noun;     ///< in messages
  std::uint64_t most_bytes;  ///< of all its files; those that were not used for longest go first
};
inline constexpr CacheKind compiled_programs{"program", "compiled kernel",
                                             std::numeric_limits<std::uint64_t>::max()};

/// A folder of entries, one file each, named by a 128-bit hash of all that shapes their content. Caches of
/// several kinds share it.
///
/// Processes may share a folder: an entry is written to a name of its own and renamed into place, so a reader
/// sees a whole entry or none. It is made for its owner alone; one of another user, or in which others may
/// write, is not used: drivers run what it holds. Nothing about the cache is fatal: a damaged or foreign
/// entry counts as absent, and a folder that cannot be written is reported once. Half-written entries of
/// killed processes go with the first store() an hour later.
class DiskCache {
 public:
  /// $OFFING_CACHE_DIR, else $XDG_CACHE_HOME/offing, else ~/.cache/offing. Empty = off: OFFING_CACHE_DIR is
  /// empty, or there is no home.
  static std::filesystem::path default_folder();

  /// An empty folder turns the cache off.
  explicit DiskCache(std::filesystem::path folder = default_folder(),
                     const CacheKind& kind = compiled_programs);

  /// `identity` is everything that shapes the content: of programs source, options, platform, device,
  /// versions.
  std::optional<std::vector<std::uint8_t>> load(std::string_view identity) const;
  void store(std::string_view identity, const std::vector<std::uint8_t>& content) const;

  /// Whether anything can be kept.
  bool is_on() const { return !folder_.empty(); }
  /// Where the entry of `identity` lies.
  std::filesystem::path entry_path(std::string_view identity) const;

 private:
  std::filesystem::path folder_;
  CacheKind kind_;
};

}  // namespace offing::ocl
