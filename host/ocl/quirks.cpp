#include "host/ocl/quirks.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <system_error>

#include <unistd.h>

#include "host/base/host_memory.h"
#include "host/ocl/disk_cache.h"
#include "host/ocl/private_folder.h"

namespace offing::ocl::quirks {
namespace {

namespace fs = std::filesystem;

bool is_oclgrind(const DeviceInfo& info) {
  return info.platform == "Oclgrind";
}

bool is_pocl(const DeviceInfo& info) {
  return info.platform == "Portable Computing Language";
}

bool is_nvidia(const DeviceInfo& info) {
  return info.platform == "NVIDIA CUDA";
}

bool is_intel_cpu(const DeviceInfo& info) {
  return info.platform == "Intel(R) OpenCL" && info.type == DeviceType::cpu;
}

const char* variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr || *value == '\0' ? nullptr : value;
}

bool can_write(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  return !error && access(folder.c_str(), W_OK | X_OK) == 0;
}

// A folder of our own in the temporary directory; empty if somebody else sits on its name.
fs::path private_temporary_folder() {
  std::error_code error;
  const fs::path folder = fs::temp_directory_path(error) / ("offing-pocl-" + std::to_string(geteuid()));
  return make_private_folder(folder).empty() ? folder : fs::path();
}

// Where PoCL keeps what it compiles (lib/CL/pocl_cache.c, pocl_cache_init_topdir).
fs::path pocl_cache_folder() {
  if (const char* own = variable("POCL_CACHE_DIR")) return own;
  if (const char* xdg = variable("XDG_CACHE_HOME")) return fs::path(xdg) / "pocl" / "kcache";
  if (const char* home = variable("HOME")) return fs::path(home) / ".cache" / "pocl" / "kcache";
  return "/tmp/pocl/kcache";
}

// PoCL 3.1 offers no device at all where it cannot make its cache folder, as under a read-only home
// (lib/CL/pocl_cache.c, pocl_cache_init_topdir). It then gets one beside our
// own cache, else in the temporary directory.
void give_pocl_a_cache() {
  if (variable("POCL_CACHE_DIR") != nullptr || can_write(pocl_cache_folder())) return;
  const fs::path own = DiskCache::default_folder();
  fs::path folder = own.empty() ? fs::path() : own / "pocl";
  if (folder.empty() || !make_private_folder(folder).empty()) folder = private_temporary_folder();
  if (!folder.empty()) setenv("POCL_CACHE_DIR", folder.c_str(), 1);
}

}  // namespace

void prepare_environment() {
  static const bool is_prepared = [] {
    give_pocl_a_cache();
    return true;
  }();
  static_cast<void>(is_prepared);
}

// PoCL 3.1 removes and writes files in its cache that other processes read and remove at the same time
// (lib/CL/pocl_file_util.c, pocl_write_file; https://github.com/pocl/pocl/issues/1480 shows the same of
// later versions). Of six processes that build one program at once, one in 75 failed with
// CL_BUILD_PROGRAM_FAILURE or a segmentation fault.
BuildTurn::BuildTurn(const DeviceInfo& info) {
  if (!is_pocl(info)) return;
  static std::atomic<bool> was_in_vain = false;
  lock_.emplace(pocl_cache_folder(), std::chrono::seconds(was_in_vain ? 1 : 60));
  if (!lock_->is_held()) was_in_vain = true;
}

// Drivers for the CPU report less memory than they can use: PoCL 3.1 three quarters of what NUMA node 0
// showed at start, which in a virtual machine with hot-plugged memory is a fraction (3.6 of 24 GiB measured;
// POCL_MEMORY_LIMIT only lowers it), Mesa 22.3 llvmpipe a constant 2 GiB. Both really take buffers over host
// memory up to the machine's size. The largest single buffer stays what the driver says: PoCL refuses more
// with CL_INVALID_BUFFER_SIZE.
std::uint64_t usable_global_memory_bytes(const DeviceInfo& info) {
  if (info.type != DeviceType::cpu || !info.has_host_unified_memory) return info.reported_global_memory_bytes;
  if (variable("POCL_MEMORY_LIMIT") != nullptr) return info.reported_global_memory_bytes;
  return std::max(info.reported_global_memory_bytes, total_host_memory_bytes());
}

// Oclgrind 21.10 copies a CL_MEM_USE_HOST_PTR buffer without telling its checkers, which then report each
// read of it as uninitialised (https://github.com/jrprice/Oclgrind). OFFING_HOST_POINTERS=0 forbids such
// buffers everywhere, so that a new driver's trouble with them can be told apart.
bool forbids_host_pointers(const DeviceInfo& info) {
  const char* allowed = variable("OFFING_HOST_POINTERS");
  return is_oclgrind(info) || (allowed != nullptr && std::string_view(allowed) == "0");
}

// PoCL compiles a kernel anew for each local size (0.1 to 1 s), and chooses another one for nearly each
// global size: every new size of a map, mesh or image then waits for its compiler.
std::size_t usual_group_size(const DeviceInfo& info) {
  return is_pocl(info) ? 64 : 0;
}

// Oclgrind 21.10 aborts on what its compiler makes of `restrict` parameters in inlined helpers
// (https://github.com/jrprice/Oclgrind). Without the word the kernels mean the same. It also compiles the
// builtin that prefetches, and then does not find it.
//
// NVIDIA's driver (580.159) has that builtin too, with a parameter that is in no address space that OpenCL C
// 1.2 can name: kernels in vectors do not build.
//
// Intel's OpenCL for the CPU (2026.22.10 and earlier) mixes up private values that live across a barrier: a
// negated value that is used before and after it is that of the work-group's last work-item for all of them
// (https://github.com/intel/llvm/issues/23220). The rows of several fields in one unrolled piece have such
// values; a loop over the fields keeps them in memory, where they are right.
//
// PoCL 7.1 reads local memory before the barrier that stands in front of the read, where an unrolled loop
// reads it: all transforms by work-groups were wrong there. PoCL 3.1 does not. Reads of volatile memory stay
// in their place.
std::string build_options(const DeviceInfo& info) {
  if (is_oclgrind(info)) return " -Drestrict= -DNO_PREFETCH";
  if (is_nvidia(info)) return " -DNO_PREFETCH";
  if (is_pocl(info)) return " -DFFT_EXCHANGE_IS_VOLATILE";
  if (is_intel_cpu(info)) return " -DFFT_FIELDS_IN_LOOP";
  return "";
}

// PoCL 7.1 (LLVM 21) gives a helper numbers that nobody wrote for a struct that another helper hands on to it
// by value, where the kernel has such a struct in a loop as well: clouds did not shade each other
// (clouds/light_entry.cl). PoCL 3.1 does not. Helpers that are inlined before anything else are right.
std::string source_preamble(const DeviceInfo& info) {
  if (!is_pocl(info) || info.driver_version.starts_with("3.")) return "";
  return "#undef inline\n#define inline __inline__ __attribute__((always_inline))\n";
}

}  // namespace offing::ocl::quirks
