#include "host/ocl/quirks.h"

#include <cstdlib>
#include <string_view>

namespace offing::ocl::quirks {
namespace {

bool is_oclgrind(const DeviceInfo& info) {
  return info.platform == "Oclgrind";
}

}  // namespace

void prepare_environment() {}

std::uint64_t usable_global_memory_bytes(const DeviceInfo& info) {
  return info.reported_global_memory_bytes;
}

// Oclgrind 21.10 copies a CL_MEM_USE_HOST_PTR buffer once and then reports reads of it as uninitialised
// (https://github.com/jrprice/Oclgrind). OFFING_HOST_POINTERS=0 forbids them everywhere, to tell such a bug
// apart.
bool forbids_host_pointers(const DeviceInfo& info) {
  const char* allowed = std::getenv("OFFING_HOST_POINTERS");
  return is_oclgrind(info) || (allowed != nullptr && std::string_view(allowed) == "0");
}

// Oclgrind 21.10 aborts on the noalias metadata that `restrict` leaves in inlined helpers
// (https://github.com/jrprice/Oclgrind); without the word the kernels mean the same.
std::string build_options(const DeviceInfo& info) {
  return is_oclgrind(info) ? " -Drestrict=" : "";
}

}  // namespace offing::ocl::quirks
