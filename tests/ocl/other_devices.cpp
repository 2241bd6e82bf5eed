#include "tests/ocl/other_devices.h"

#include <filesystem>

namespace offing::test {

std::string OtherDevice::prefix() const {
  std::string text;
  for (const auto& [variable, value] : environment) text += variable + "=" + value + " ";
  return text;
}

OtherDevice rusticl() {
  const bool is_there = std::filesystem::exists("/etc/OpenCL/vendors/rusticl.icd");
  return {.name = "rusticl",
          .environment = {{"RUSTICL_ENABLE", "llvmpipe"}, {"OFFING_DEVICE", "rusticl"}},
          .shapes = {"workgroup"},
          .missing = is_there
                         ? ""
                         : "rusticl is not installed (Debian: mesa-opencl-icd libclc-15 libllvmspirvlib15)."};
}

OtherDevice intel() {
  // The loader takes the library itself in place of a folder of .icd files. It needs a newer TBB than
  // Debian's, which programs that read volumes have loaded before.
  const std::string folder = OFFING_PEERS "/lib", library = folder + "/libintelocl.so";
  return {.name = "intel",
          .environment = {{"OCL_ICD_VENDORS", library},
                          {"LD_PRELOAD", folder + "/libtbb.so.12"},
                          {"OFFING_DEVICE", "Intel"}},
          .shapes = {"simd", "workgroup"},
          .missing = std::filesystem::exists(library)
                         ? ""
                         : library +
                               " is not there: ./dev test --slow installs the PyPI packages "
                               "intel-opencl-rt and intel-cmplr-lib-rt."};
}

std::vector<OtherDevice> other_devices() {
  return {rusticl(), intel()};
}

std::string missing_devices() {
  std::string text;
  for (const OtherDevice& device : other_devices()) {
    if (!device.is_installed()) text += (text.empty() ? "" : " ") + device.missing;
  }
  return text;
}

}  // namespace offing::test
