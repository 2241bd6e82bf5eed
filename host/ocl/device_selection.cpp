#include "host/ocl/device_selection.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <string>

#include <fmt/format.h>

#include "host/base/error.h"

namespace offing::ocl {
namespace {

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

}  // namespace offing::ocl
