#include <vector>

#include "host/c/handles.h"
#include "host/ocl/device_list.h"

using offing::c::require;
using offing::c::run;

namespace {

OffingDeviceInfo info_of(const offing::ocl::DeviceInfo& device) {
  OffingDeviceInfo info{};
  info.size = sizeof info;
  info.index = device.index;
  offing::c::write_text(info.name, device.name);
  offing::c::write_text(info.vendor, device.vendor);
  offing::c::write_text(info.platform, device.platform);
  offing::c::write_text(info.driver, device.driver_version);
  offing::c::write_text(info.type, std::string(to_string(device.type)));
  info.memory_bytes = device.global_memory_bytes;
  info.compute_units = static_cast<int>(device.compute_units);
  return info;
}

}  // namespace

OffingStatus offing_list_devices(OffingDeviceInfo* devices, size_t capacity, size_t* count) {
  return run([&] {
    require(count, "count");
    *count = 0;
    const std::vector<offing::ocl::DeviceInfo> found = offing::ocl::list_devices();
    *count = found.size();
    if (capacity == 0 || found.empty()) return;
    require(devices, "devices");
    // An older program's structs are smaller, so that its array has other steps than ours.
    const std::size_t step = devices->size;
    auto* const bytes = reinterpret_cast<unsigned char*>(devices);
    for (std::size_t i = 0; i < std::min(capacity, found.size()); ++i)
      offing::c::write_struct(reinterpret_cast<OffingDeviceInfo*>(bytes + i * step), "devices",
                              info_of(found[i]));
  });
}

OffingStatus offing_open_device(const char* selector, OffingDevice** device) {
  return run([&] {
    require(device, "device");
    *device = new OffingDevice{offing::ocl::Device::open(selector == nullptr ? "" : selector)};
  });
}

OffingStatus offing_adopt_device(void* context, void* queue, OffingDevice** device) {
  return run([&] {
    require(context, "context");
    require(queue, "queue");
    require(device, "device");
    *device = new OffingDevice{
        offing::ocl::Device::adopt(static_cast<cl_context>(context), static_cast<cl_command_queue>(queue))};
  });
}

OffingStatus offing_get_device_info(const OffingDevice* device, OffingDeviceInfo* info) {
  return run([&] {
    require(device, "device");
    offing::c::write_struct(info, "info", info_of(device->device.info()));
  });
}

const char* offing_device_name(const OffingDevice* device) {
  return device == nullptr ? "" : device->device.info().name.c_str();
}

void* offing_device_context(const OffingDevice* device) {
  return device == nullptr ? nullptr : device->device.context();
}

void* offing_device_queue(const OffingDevice* device) {
  return device == nullptr ? nullptr : device->device.queue();
}

OffingStatus offing_finish_device(const OffingDevice* device) {
  return run([&] {
    require(device, "device");
    device->device.finish();
  });
}

void offing_close_device(OffingDevice* device) {
  delete device;
}
