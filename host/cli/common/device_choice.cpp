#include "host/cli/common/device_choice.h"

#include <cstdlib>

#include <fmt/format.h>

#include "host/base/error.h"

namespace offing::cli {

namespace {

constexpr std::string_view all = "all";

/// Where "all" was asked for, nothing if it was not.
const char* place_of_all(std::string_view selector) {
  if (!selector.empty()) {
    return selector == all ? "--device" : nullptr;
  }
  const char* preferred = std::getenv("OFFING_DEVICE");
  return preferred != nullptr && preferred == all ? "OFFING_DEVICE" : nullptr;
}

}  // namespace

ocl::DeviceInfo choose_one_device(std::string_view selector) {
  if (const char* place = place_of_all(selector)) {
    throw Error(ErrorKind::bad_usage, fmt::format("{}: expected one device, got \"{}\"", place, all),
                "name a device by index, type or part of its name; only `offing ocean bake` uses all");
  }
  return ocl::select_device(selector);
}

std::vector<ocl::DeviceInfo> choose_devices(std::string_view selector) {
  return place_of_all(selector) ? ocl::list_devices() : std::vector{ocl::select_device(selector)};
}

}  // namespace offing::cli
