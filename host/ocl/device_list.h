#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

// An opaque OpenCL handle, declared as the OpenCL headers declare it, so that only host/ocl includes those
// headers.
typedef struct _cl_device_id* cl_device_id;

/// The OpenCL devices of this machine: what they report, and which one a name means.
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

/// What a listed device of this handle reports. Throws Error(no_device) where none has it.
DeviceInfo info_of(cl_device_id id);

/// The driver's handle of a listed device. Throws Error(no_device) where it is gone.
cl_device_id id_of(const DeviceInfo& info);

}  // namespace offing::ocl
