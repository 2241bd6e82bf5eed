// Lists the devices of all drivers and chooses one by what a person calls it.
#include "host/ocl/device_list.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <mutex>
#include <utility>

#include <fmt/format.h>
#include <sys/resource.h>

#include "host/base/error.h"
#include "host/ocl/opencl.h"
#include "host/ocl/quirks.h"
#include "host/ocl/status.h"

namespace offing::ocl {
namespace {

/// A device as the driver knows it, beside what it reports.
struct ListedDevice {
  cl_device_id id = nullptr;
  DeviceInfo info;
};

// Drivers pad some strings with blanks and zero bytes.
std::string trimmed(std::string text) {
  while (!text.empty() && (text.back() == '\0' || text.back() == ' ')) text.pop_back();
  text.erase(0, text.find_first_not_of(' '));
  return text;
}

std::string platform_text(cl_platform_id platform, cl_platform_info what) {
  std::size_t bytes = 0;
  check(clGetPlatformInfo(platform, what, 0, nullptr, &bytes), "clGetPlatformInfo", "an OpenCL platform");
  std::string text(bytes, '\0');
  check(clGetPlatformInfo(platform, what, bytes, text.data(), nullptr), "clGetPlatformInfo",
        "an OpenCL platform");
  return trimmed(std::move(text));
}

std::string device_text(cl_device_id device, cl_device_info what) {
  std::size_t bytes = 0;
  check(clGetDeviceInfo(device, what, 0, nullptr, &bytes), "clGetDeviceInfo", "an OpenCL device");
  std::string text(bytes, '\0');
  check(clGetDeviceInfo(device, what, bytes, text.data(), nullptr), "clGetDeviceInfo", "an OpenCL device");
  return trimmed(std::move(text));
}

template <class T>
T device_value(cl_device_id device, cl_device_info what) {
  T value{};
  check(clGetDeviceInfo(device, what, sizeof value, &value, nullptr), "clGetDeviceInfo", "an OpenCL device");
  return value;
}

DeviceType device_type(cl_device_type bits) {
  if (bits & CL_DEVICE_TYPE_GPU) return DeviceType::gpu;
  if (bits & CL_DEVICE_TYPE_CPU) return DeviceType::cpu;
  if (bits & CL_DEVICE_TYPE_ACCELERATOR) return DeviceType::accelerator;
  return DeviceType::other;
}

bool is_usable(cl_device_id device) {
  return device_value<cl_bool>(device, CL_DEVICE_AVAILABLE) &&
         device_value<cl_bool>(device, CL_DEVICE_COMPILER_AVAILABLE);
}

DeviceInfo describe(cl_platform_id platform, cl_device_id device) {
  DeviceInfo info;
  info.name = device_text(device, CL_DEVICE_NAME);
  info.vendor = device_text(device, CL_DEVICE_VENDOR);
  info.platform = platform_text(platform, CL_PLATFORM_NAME);
  info.platform_version = platform_text(platform, CL_PLATFORM_VERSION);
  info.device_version = device_text(device, CL_DEVICE_VERSION);
  info.c_version = device_text(device, CL_DEVICE_OPENCL_C_VERSION);
  info.driver_version = device_text(device, CL_DRIVER_VERSION);
  info.type = device_type(device_value<cl_device_type>(device, CL_DEVICE_TYPE));
  info.reported_global_memory_bytes = device_value<cl_ulong>(device, CL_DEVICE_GLOBAL_MEM_SIZE);
  info.max_allocation_bytes = device_value<cl_ulong>(device, CL_DEVICE_MAX_MEM_ALLOC_SIZE);
  info.local_memory_bytes = device_value<cl_ulong>(device, CL_DEVICE_LOCAL_MEM_SIZE);
  info.compute_units = device_value<cl_uint>(device, CL_DEVICE_MAX_COMPUTE_UNITS);
  info.native_float_width = device_value<cl_uint>(device, CL_DEVICE_NATIVE_VECTOR_WIDTH_FLOAT);
  info.max_work_group_size = device_value<std::size_t>(device, CL_DEVICE_MAX_WORK_GROUP_SIZE);
  info.base_address_alignment_bytes =
      device_value<cl_uint>(device, CL_DEVICE_MEM_BASE_ADDR_ALIGN) / 8;  // bits
  info.has_host_unified_memory = device_value<cl_bool>(device, CL_DEVICE_HOST_UNIFIED_MEMORY) == CL_TRUE;
  const std::string extensions = fmt::format(" {} ", device_text(device, CL_DEVICE_EXTENSIONS));
  info.has_gl_sharing = extensions.find(" cl_khr_gl_sharing ") != std::string::npos;
  info.global_memory_bytes = quirks::usable_global_memory_bytes(info);
  return info;
}

// Drivers open libraries, caches and pipes to compilers, and blame none of this where they cannot: PoCL 3.1
// fails with 12 where it has to compile, and works with 16.
void require_open_files() {
  constexpr rlim_t fewest = 16;
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur >= fewest) return;
  throw Error(ErrorKind::no_device,
              fmt::format("no OpenCL device: drivers need {} open files, this process may have {}", fewest,
                          limit.rlim_cur),
              "raise the limit with ulimit -n 1024");
}

std::vector<cl_platform_id> platforms() {
  cl_uint count = 0;
  const int status = clGetPlatformIDs(0, nullptr, &count);
  if (status != CL_SUCCESS || count == 0) {
    throw Error(
        ErrorKind::no_device,
        fmt::format("no OpenCL platform: expected at least one driver, found none ({})", status_name(status)),
        "install an OpenCL driver: your GPU vendor's, or pocl-opencl-icd for the CPU");
  }
  std::vector<cl_platform_id> ids(count);
  check(clGetPlatformIDs(count, ids.data(), nullptr), "clGetPlatformIDs", "the OpenCL platforms");
  return ids;
}

std::vector<cl_device_id> devices_of(cl_platform_id platform) {
  cl_uint count = 0;
  // A platform without devices answers CL_DEVICE_NOT_FOUND; a broken one must not hide the others.
  if (clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, 0, nullptr, &count) != CL_SUCCESS || count == 0) return {};
  std::vector<cl_device_id> ids(count);
  if (clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, count, ids.data(), nullptr) != CL_SUCCESS) return {};
  return ids;
}

/// What list_devices() lists, with the driver's ids. Devices without a compiler or not available are left
/// out. Throws Error(no_device) when there is no platform or no device.
std::vector<ListedDevice> enumerate_devices() {
  // PoCL 3.1 sets itself up in the first call and offers no devices to threads that ask meanwhile.
  static std::mutex turn;
  const std::lock_guard lock(turn);
  require_open_files();
  quirks::prepare_environment();
  std::vector<ListedDevice> listed;
  std::string empty_platforms;
  for (cl_platform_id platform : platforms()) {
    const std::size_t before = listed.size();
    for (cl_device_id device : devices_of(platform)) {
      if (!is_usable(device)) continue;
      DeviceInfo info = describe(platform, device);
      info.index = static_cast<int>(listed.size());
      listed.push_back({device, std::move(info)});
    }
    if (listed.size() == before) {
      empty_platforms += (empty_platforms.empty() ? "" : ", ") + platform_text(platform, CL_PLATFORM_NAME);
    }
  }
  if (listed.empty()) {
    throw Error(ErrorKind::no_device,
                fmt::format("no OpenCL device: the installed platforms ({}) offer none", empty_platforms),
                "install a driver for your GPU, or pocl-opencl-icd for the CPU");
  }
  return listed;
}

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

std::string listing(const std::vector<const DeviceInfo*>& devices) {
  std::string text;
  for (const DeviceInfo* device : devices) {
    text += fmt::format("{}{}: {} ({}, {})", text.empty() ? "" : "; ", device->index, device->name,
                        to_string(device->type), device->platform);
  }
  return text;
}

const DeviceInfo* first_of(const std::vector<DeviceInfo>& devices, DeviceType type) {
  const auto found = std::find_if(devices.begin(), devices.end(),
                                  [type](const DeviceInfo& device) { return device.type == type; });
  return found == devices.end() ? nullptr : &*found;
}

const DeviceInfo* of_index(const std::vector<DeviceInfo>& devices, std::string_view selector) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(selector.data(), selector.data() + selector.size(), index);
  const bool is_index = error == std::errc() && end == selector.data() + selector.size();
  return is_index && index < devices.size() ? &devices[index] : nullptr;
}

bool contains(const std::string& text, const std::string& lower_part) {
  return lower(text).find(lower_part) != std::string::npos;
}

constexpr const char* choice_hint =
    "choose a device by its index, its type or a part of its name; offing devices lists them";

}  // namespace

std::string_view to_string(DeviceType type) {
  switch (type) {
    case DeviceType::cpu:
      return "cpu";
    case DeviceType::gpu:
      return "gpu";
    case DeviceType::accelerator:
      return "accelerator";
    case DeviceType::other:
      break;
  }
  return "other";
}

std::vector<DeviceInfo> list_devices() {
  std::vector<DeviceInfo> infos;
  for (ListedDevice& device : enumerate_devices()) infos.push_back(std::move(device.info));
  return infos;
}

const DeviceInfo& choose_device(const std::vector<DeviceInfo>& devices, std::string_view selector) {
  if (selector.empty()) {
    if (const DeviceInfo* gpu = first_of(devices, DeviceType::gpu)) return *gpu;
    if (const DeviceInfo* cpu = first_of(devices, DeviceType::cpu)) return *cpu;
    return devices.front();
  }
  if (const DeviceInfo* device = of_index(devices, selector)) return *device;

  const std::string part = lower(selector);
  std::vector<const DeviceInfo*> fitting;
  for (DeviceType type : {DeviceType::cpu, DeviceType::gpu, DeviceType::accelerator}) {
    if (part != to_string(type)) continue;
    if (const DeviceInfo* device = first_of(devices, type)) return *device;
  }
  for (const DeviceInfo& device : devices) {
    if (contains(device.name, part) || contains(device.platform, part)) fitting.push_back(&device);
  }
  if (fitting.size() == 1) return *fitting.front();
  if (!fitting.empty()) {
    throw Error(ErrorKind::no_device,
                fmt::format("device \"{}\" is ambiguous: it fits {}", selector, listing(fitting)),
                choice_hint);
  }
  std::vector<const DeviceInfo*> all;
  all.reserve(devices.size());
  for (const DeviceInfo& device : devices) all.push_back(&device);
  throw Error(ErrorKind::no_device,
              fmt::format("no OpenCL device fits \"{}\": found {}", selector, listing(all)), choice_hint);
}

DeviceInfo select_device(std::string_view selector) {
  const std::vector<DeviceInfo> devices = list_devices();
  const char* preferred = std::getenv("OFFING_DEVICE");
  if (!selector.empty() || preferred == nullptr) return choose_device(devices, selector);
  try {
    return choose_device(devices, preferred);
  } catch (const Error& error) {
    throw Error(error.kind(), fmt::format("OFFING_DEVICE: {}", error.what()), error.hint());
  }
}

DeviceInfo info_of(cl_device_id id) {
  for (const ListedDevice& listed : enumerate_devices()) {
    if (listed.id == id) return listed.info;
  }
  throw Error(ErrorKind::no_device, "device: expected one that the OpenCL loader lists, got another",
              "use a device with a compiler, as clGetDeviceIDs lists it");
}

cl_device_id id_of(const DeviceInfo& info) {
  for (const ListedDevice& device : enumerate_devices()) {
    if (device.info.index == info.index && device.info.name == info.name &&
        device.info.platform == info.platform) {
      return device.id;
    }
  }
  throw Error(ErrorKind::no_device,
              fmt::format("device {} \"{}\" of platform {} is gone", info.index, info.name, info.platform),
              "list the devices again: offing devices");
}

}  // namespace offing::ocl
