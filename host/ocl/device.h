#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/ocl/event.h"

// Opaque OpenCL handles, declared as the OpenCL headers declare them, so that only host/ocl includes those
// headers.
typedef struct _cl_device_id* cl_device_id;
typedef struct _cl_context* cl_context;
typedef struct _cl_command_queue* cl_command_queue;

namespace offing::ocl {

/// Kinds of OpenCL devices.
enum class DeviceType { cpu, gpu, accelerator, other };

/// What a device reports, after the corrections of quirks.h.
struct DeviceInfo {
  int index = 0;  ///< position in list_devices(), stable while the installed drivers stay the same
  std::string name;
  std::string vendor;
  std::string platform;
  std::string platform_version;
  std::string device_version;  ///< CL_DEVICE_VERSION, "OpenCL 3.0 ..."
  std::string c_version;       ///< CL_DEVICE_OPENCL_C_VERSION
  std::string driver_version;
  DeviceType type = DeviceType::other;
  std::uint64_t global_memory_bytes = 0;           ///< usable, after quirks
  std::uint64_t reported_global_memory_bytes = 0;  ///< as the driver says
  std::uint64_t max_allocation_bytes = 0;          ///< largest single buffer
  std::uint64_t local_memory_bytes = 0;            ///< a work-group
  std::uint32_t compute_units = 0;
  std::uint32_t native_float_width = 0;  ///< lanes of one float vector register; 1 on most GPUs, 0 unknown
  std::size_t max_work_group_size = 0;
  std::uint32_t base_address_alignment_bytes = 0;
  bool has_gl_sharing = false;
  bool has_host_unified_memory = false;
};

std::string_view to_string(DeviceType type);

/// All devices of all platforms, in driver order. Throws Error(no_device) when there is no platform or no
/// device.
std::vector<DeviceInfo> list_devices();

/// The device that `selector` names: an index, a type (cpu, gpu, accelerator), or a part of the name or
/// platform (case ignored). An empty selector falls back to OFFING_DEVICE, then to the first GPU, else the
/// first CPU, else any. Throws Error(no_device) that lists what exists when nothing or more than the selector
/// meant fits.
DeviceInfo select_device(std::string_view selector = {});

/// The one of `devices` (not empty) that `selector` means, by the rules of select_device() but without the
/// environment. Throws Error(no_device) that names the selector and lists the candidates.
const DeviceInfo& choose_device(const std::vector<DeviceInfo>& devices, std::string_view selector);

/// Whether the device keeps the times of its work, which events then give.
enum class Profiling { off, on };

namespace detail {
struct DeviceState;
}

/// An open device: its context and one in-order queue. A cheap shared handle; objects made from it are
/// confined to the thread that uses its queue.
class Device {
 public:
  /// Opens the device of select_device(selector).
  static Device open(std::string_view selector = {}, Profiling profiling = Profiling::off);
  static Device open(const DeviceInfo& info, Profiling profiling = Profiling::off);
  /// Opens the device so that it shares buffers with the OpenGL context that `share_properties` (pairs of
  /// property and value of cl_khr_gl_sharing) names, or without sharing where either side has none.
  static Device open_shared(const DeviceInfo& info, Profiling profiling,
                            std::span<const std::intptr_t> share_properties);

  const DeviceInfo& info() const;

  /// Submits what is queued without waiting.
  void flush() const;
  /// An event that is done when everything queued so far is.
  Event mark() const;
  /// Waits until everything queued is done. Throws Error(device) if a command failed.
  void finish() const;

  cl_device_id id() const;
  cl_context context() const;
  cl_command_queue queue() const;
  bool is_profiling() const;
  /// Whether ImportedBuffer can be used.
  bool shares_gl() const;
  const std::shared_ptr<detail::DeviceState>& state() const { return state_; }

 private:
  explicit Device(std::shared_ptr<detail::DeviceState> state);
  std::shared_ptr<detail::DeviceState> state_;
};

}  // namespace offing::ocl
