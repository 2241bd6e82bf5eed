#pragma once

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/ocl/device_list.h"

/// Compiled programs, kept between runs.
namespace offing::ocl {

/// The parts of an entry's identity as one string; '\0' keeps neighbours apart.
std::string joined_identity(std::initializer_list<std::string_view> parts);
/// Everything about a device and its driver that shapes what is compiled for it.
std::string driver_identity(const DeviceInfo& info);

/// A folder of compiled programs, one file each, named by a 128-bit hash of all that shapes the binary.
///
/// Processes may share a folder: an entry is written to a name of its own and renamed into place, so a reader
/// sees a whole entry or none. It is made for its owner alone; one of another user, or in which others may
/// write, is not used: drivers run what it holds. Nothing about the cache is fatal: a damaged or foreign
/// entry counts as absent, and a folder that cannot be written is reported once. Half-written entries of
/// killed processes go with the first store() an hour later.
class ProgramCache {
 public:
  /// $OFFING_CACHE_DIR, else $XDG_CACHE_HOME/offing, else ~/.cache/offing. Empty = off: OFFING_CACHE_DIR is
  /// empty, or there is no home.
  static std::filesystem::path default_folder();

  /// An empty folder turns the cache off.
  explicit ProgramCache(std::filesystem::path folder = default_folder());

  /// `identity` is everything that shapes the binary: source, options, platform, device, versions.
  std::optional<std::vector<std::uint8_t>> load(std::string_view identity) const;
  void store(std::string_view identity, const std::vector<std::uint8_t>& binary) const;

  /// Where the entry of `identity` lies.
  std::filesystem::path entry_path(std::string_view identity) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace offing::ocl
