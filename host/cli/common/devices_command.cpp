#include "host/cli/common/devices_command.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/base/error.h"
#include "host/base/log.h"
#include "host/cli/common/device_choice.h"
#include "host/ocl/device.h"

namespace offing::cli {
namespace {

using ocl::DeviceInfo;

// What a command without --device takes; -1 where OFFING_DEVICE fits nothing, or all, which must not stop the
// listing.
int default_index() {
  try {
    return choose_one_device({}).index;
  } catch (const Error& error) {
    spdlog::warn("{}", error.what());
    return -1;
  }
}

nlohmann::ordered_json to_json(const DeviceInfo& device, int default_device) {
  return {{"index", device.index},
          {"name", device.name},
          {"type", ocl::to_string(device.type)},
          {"is_default", device.index == default_device},
          {"platform", device.platform},
          {"platform_version", device.platform_version},
          {"device_version", device.device_version},
          {"c_version", device.c_version},
          {"driver_version", device.driver_version},
          {"compute_units", device.compute_units},
          {"global_memory_bytes", device.global_memory_bytes},
          {"reported_global_memory_bytes", device.reported_global_memory_bytes},
          {"max_allocation_bytes", device.max_allocation_bytes},
          {"local_memory_bytes", device.local_memory_bytes},
          {"max_work_group_size", device.max_work_group_size},
          {"gl_sharing", device.has_gl_sharing}};
}

constexpr std::size_t column_count = 9;
using DeviceRow = std::array<std::string, column_count>;

std::string gibibytes(std::uint64_t bytes) {
  return fmt::format("{:.1f} GiB", static_cast<double>(bytes) / (1 << 30));
}

// "OpenCL 3.0" of "OpenCL 3.0 <what the vendor likes to add>".
std::string opencl_version(const DeviceInfo& device) {
  const std::size_t end = device.device_version.find(' ', device.device_version.find(' ') + 1);
  return device.device_version.substr(0, end);
}

DeviceRow table_row(const DeviceInfo& device, int default_device) {
  return {fmt::format("{}{}", device.index, device.index == default_device ? "*" : ""),
          std::string(ocl::to_string(device.type)),
          device.name,
          device.platform,
          opencl_version(device),
          device.driver_version,
          fmt::format("{}", device.compute_units),
          gibibytes(device.global_memory_bytes),
          device.has_gl_sharing ? "yes" : "no"};
}

void print_table(const std::vector<DeviceInfo>& devices, int default_device) {
  std::vector<DeviceRow> rows{
      {"index", "type", "name", "platform", "version", "driver", "units", "memory", "GL sharing"}};
  for (const DeviceInfo& device : devices) rows.push_back(table_row(device, default_device));
  std::array<std::size_t, column_count> widths{};
  for (const DeviceRow& row : rows) {
    for (std::size_t i = 0; i < column_count; ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  for (const DeviceRow& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < column_count; ++i) line += fmt::format("{:<{}}  ", row[i], widths[i]);
    line.erase(line.find_last_not_of(' ') + 1);
    fmt::print("{}\n", line);
  }
  fmt::print("* is the default. --device and OFFING_DEVICE take an index, a type or part of a name\n");
}

void run_devices_command(bool as_json) {
  const std::vector<DeviceInfo> devices = ocl::list_devices();
  const int default_device = default_index();
  if (!as_json) {
    print_table(devices, default_device);
    return;
  }
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const DeviceInfo& device : devices) list.push_back(to_json(device, default_device));
  fmt::print("{}\n", list.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
}

}  // namespace

void add_devices_command(CLI::App& app, GlobalOptions& options) {
  CLI::App* command = app.add_subcommand("devices", "list the OpenCL devices of this computer");
  const auto as_json = std::make_shared<bool>(false);
  command->add_flag("--json", *as_json, "print a JSON array with one object per device");
  add_global_options(*command, options, DeviceUse::none);
  command->callback([as_json] { run_devices_command(*as_json); });
}

}  // namespace offing::cli
