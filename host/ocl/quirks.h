#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "host/ocl/device_list.h"
#include "host/ocl/private_folder.h"

/// What drivers get wrong: one function a bug, each with the versions that show it. No other file tests for a
/// vendor.
namespace offing::ocl::quirks {

/// Sets the environment that drivers read once, at the first platform call; idempotent and thread-safe.
void prepare_environment();

/// While it lives, no other process of this user, nor another thread, builds programs for such a device.
/// Waits for its turn, a minute at most and a second after that was in vain; does nothing where drivers need
/// none.
class BuildTurn {
 public:
  explicit BuildTurn(const DeviceInfo& info);

 private:
  std::optional<FolderLock> lock_;
};

/// The device's memory that programs can really use; see the definition for whom the driver's figure is
/// wrong.
std::uint64_t usable_global_memory_bytes(const DeviceInfo& info);

/// True where buffers over host memory (CL_MEM_USE_HOST_PTR) must not be used.
bool forbids_host_pointers(const DeviceInfo& info);

/// The local size for launches that leave it to the driver, where the driver's own choice is a bad one; 0
/// elsewhere.
std::size_t usual_group_size(const DeviceInfo& info);

/// Build options that work around compiler bugs, each with a leading blank; empty for most devices.
std::string build_options(const DeviceInfo& info);

/// What stands before the source of a program to work around compiler bugs; empty for most devices.
std::string source_preamble(const DeviceInfo& info);

}  // namespace offing::ocl::quirks
