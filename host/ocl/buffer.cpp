#include "host/ocl/buffer.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <sys/mman.h>

#include "host/base/error.h"
#include "host/base/host_memory.h"
#include "host/ocl/device_state.h"
#include "host/ocl/opencl.h"
#include "host/ocl/quirks.h"
#include "host/ocl/status.h"

namespace offing::ocl {
namespace {

constexpr std::size_t page_bytes = 4096;
constexpr std::size_t huge_page_bytes = std::size_t{2} << 20;

}  // namespace

/// Page-aligned zeroed host memory whose pages are present; from 2 MiB on it asks for huge pages, which spare
/// the address translation of large strided transforms up to a third of their time.
class HostPages {
 public:
  /// At least `bytes`, rounded up to whole pages. data() is null if the memory is not there.
  explicit HostPages(std::size_t bytes);
  HostPages(const HostPages&) = delete;
  HostPages& operator=(const HostPages&) = delete;
  ~HostPages();

  void* data() const { return data_; }

  /// What `bytes` rounds up to.
  static std::size_t rounded(std::size_t bytes);

 private:
  void* data_ = nullptr;
};

std::size_t HostPages::rounded(std::size_t bytes) {
  return (std::max<std::size_t>(bytes, 1) + page_bytes - 1) / page_bytes * page_bytes;
}

HostPages::HostPages(std::size_t bytes) {
  const std::size_t size = rounded(bytes);
  const bool is_large = size >= huge_page_bytes;
  // Untouched pages cost nothing until the first write, and then the kernel kills the process instead of
  // refusing.
  if (is_large && size > available_host_memory_bytes()) return;
  if (posix_memalign(&data_, is_large ? huge_page_bytes : page_bytes, size) != 0) {
    data_ = nullptr;
    return;
  }
  if (is_large) madvise(data_, size, MADV_HUGEPAGE);  // a wish: without huge pages all works, only slower
  std::memset(data_, 0, size);
}

HostPages::~HostPages() {
  std::free(data_);
}

namespace detail {
namespace {

bool uses_host_pages(const DeviceInfo& info) {
  return info.type == DeviceType::cpu && info.has_host_unified_memory && !quirks::forbids_host_pointers(info);
}

std::string description(std::string_view name, std::size_t bytes, const DeviceInfo& info) {
  return fmt::format("buffer \"{}\" of {} bytes on {}", name, bytes, info.name);
}

[[noreturn]] void throw_out_of_memory(std::string_view call, std::string_view name, std::size_t bytes,
                                      const DeviceInfo& info) {
  throw Error(ErrorKind::out_of_memory,
              fmt::format("{}: {} does not fit: the device has {} MiB and allows {} MiB per buffer", call,
                          description(name, bytes, info), info.global_memory_bytes >> 20,
                          info.max_allocation_bytes >> 20),
              out_of_memory_hint);
}

[[noreturn]] void throw_out_of_host_memory(std::string_view name, std::size_t bytes, const DeviceInfo& info) {
  throw Error(ErrorKind::out_of_memory,
              fmt::format("{} does not fit: {} MiB of this machine's memory are left to this process",
                          description(name, bytes, info), available_host_memory_bytes() >> 20),
              out_of_memory_hint);
}

}  // namespace

std::size_t checked_bytes(std::size_t count, std::size_t element_bytes, std::string_view name) {
  if (count > std::numeric_limits<std::size_t>::max() / 2 / element_bytes) {
    throw Error(ErrorKind::out_of_memory,
                fmt::format("buffer \"{}\" of {} elements of {} bytes exceeds the address space", name, count,
                            element_bytes),
                out_of_memory_hint);
  }
  return count * element_bytes;
}

void release_pages(HostPages* pages) {
  delete pages;
}

Memory::Memory(const Device& device, std::size_t bytes, std::string_view name)
    : device_(device.state()), pages_(nullptr, release_pages), bytes_(bytes), name_(name) {
  const DeviceInfo& info = device_->info;
  const std::size_t size = HostPages::rounded(bytes);
  if (size > info.max_allocation_bytes) throw_out_of_memory("clCreateBuffer", name_, bytes_, info);
  cl_mem_flags flags = CL_MEM_READ_WRITE;
  if (uses_host_pages(info)) {
    pages_.reset(new HostPages(size));
    if (pages_->data() == nullptr) throw_out_of_host_memory(name_, bytes_, info);
    // A driver that asks for more than a page gets its own memory instead of undefined behaviour.
    const auto address = reinterpret_cast<std::uintptr_t>(pages_->data());
    if (address % std::max<std::size_t>(info.base_address_alignment_bytes, 1) != 0) pages_.reset();
  }
  if (pages_) flags |= CL_MEM_USE_HOST_PTR;
  int status = CL_SUCCESS;
  memory_ = clCreateBuffer(device_->context.get(), flags, size, pages_ ? pages_->data() : nullptr, &status);
  if (is_out_of_memory(status) || status == CL_INVALID_BUFFER_SIZE) {
    throw_out_of_memory("clCreateBuffer", name_, bytes_, info);
  }
  check(status, "clCreateBuffer", description(name_, bytes_, info));
  if (!pages_) touch();
}

Memory Memory::adopt(const Device& device, cl_mem memory, std::string_view name) {
  const auto value_of = [&](cl_mem_info query, auto value) {
    check(clGetMemObjectInfo(memory, query, sizeof value, &value, nullptr), "clGetMemObjectInfo", name);
    return value;
  };
  if (value_of(CL_MEM_CONTEXT, cl_context{}) != device.context()) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("buffer \"{}\": expected one of the device's context, got one of another", name),
                "open the device by the context of the buffer (Device::adopt(), offing_adopt_device())");
  }
  if (value_of(CL_MEM_TYPE, cl_mem_object_type{}) != CL_MEM_OBJECT_BUFFER) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("buffer \"{}\": expected a buffer, got an image or a pipe", name),
                "make it by clCreateBuffer()");
  }
  Memory adopted;
  adopted.bytes_ = value_of(CL_MEM_SIZE, std::size_t{});
  adopted.name_ = name;
  check(clRetainMemObject(memory), "clRetainMemObject", name);
  adopted.memory_ = memory;
  adopted.device_ = device.state();
  return adopted;
}

// Many GPU drivers reserve memory at the first use only. Using it here lets the error name the buffer.
void Memory::touch() {
  const cl_uint zero = 0;
  int status = clEnqueueFillBuffer(device_->queue.get(), memory_, &zero, sizeof zero, 0, sizeof zero, 0,
                                   nullptr, nullptr);
  if (status == CL_SUCCESS) status = clFinish(device_->queue.get());
  if (status == CL_SUCCESS) return;
  release();
  if (is_out_of_memory(status) || status == CL_OUT_OF_RESOURCES) {
    throw_out_of_memory("clEnqueueFillBuffer", name_, bytes_, device_->info);
  }
  throw_status(status, "clEnqueueFillBuffer", description(name_, bytes_, device_->info));
}

Memory::Memory(Memory&& other) noexcept {
  *this = std::move(other);
}

Memory& Memory::operator=(Memory&& other) noexcept {
  std::swap(device_, other.device_);
  std::swap(pages_, other.pages_);
  std::swap(memory_, other.memory_);
  std::swap(bytes_, other.bytes_);
  std::swap(name_, other.name_);
  return *this;
}

void Memory::release() noexcept {
  if (memory_ == nullptr) return;
  // The driver keeps device memory until its last command is done, but our pages would go at once.
  if (pages_) clFinish(device_->queue.get());
  clReleaseMemObject(memory_);
  memory_ = nullptr;
}

Memory::~Memory() {
  release();
}

void Memory::check_range(std::size_t offset_bytes, std::size_t bytes, std::string_view action) const {
  if (offset_bytes <= bytes_ && bytes <= bytes_ - offset_bytes) return;
  throw Error(ErrorKind::bad_usage, fmt::format("{} of bytes [{}, {}) is outside buffer \"{}\" of {} bytes",
                                                action, offset_bytes, offset_bytes + bytes, name_, bytes_));
}

void Memory::write(std::size_t offset_bytes, std::size_t bytes, const void* source) {
  check_range(offset_bytes, bytes, "write");
  if (bytes == 0) return;
  check(clEnqueueWriteBuffer(device_->queue.get(), memory_, CL_TRUE, offset_bytes, bytes, source, 0, nullptr,
                             nullptr),
        "clEnqueueWriteBuffer", description(name_, bytes_, device_->info));
}

void Memory::read(std::size_t offset_bytes, std::size_t bytes, void* target) const {
  check_range(offset_bytes, bytes, "read");
  if (bytes == 0) return;
  check(clEnqueueReadBuffer(device_->queue.get(), memory_, CL_TRUE, offset_bytes, bytes, target, 0, nullptr,
                            nullptr),
        "clEnqueueReadBuffer", description(name_, bytes_, device_->info));
}

Event Memory::begin_read(void* target) const {
  if (bytes_ == 0) return {};
  cl_event event = nullptr;
  check(clEnqueueReadBuffer(device_->queue.get(), memory_, CL_FALSE, 0, bytes_, target, 0, nullptr, &event),
        "clEnqueueReadBuffer", description(name_, bytes_, device_->info));
  return Event(event);
}

Event Memory::begin_write(const void* source) {
  if (bytes_ == 0) return {};
  cl_event event = nullptr;
  check(clEnqueueWriteBuffer(device_->queue.get(), memory_, CL_FALSE, 0, bytes_, source, 0, nullptr, &event),
        "clEnqueueWriteBuffer", description(name_, bytes_, device_->info));
  return Event(event);
}

void Memory::fill(const void* pattern, std::size_t pattern_bytes) {
  if (bytes_ == 0) return;
  const std::string where = description(name_, bytes_, device_->info);
  check(clEnqueueFillBuffer(device_->queue.get(), memory_, pattern, pattern_bytes, 0, bytes_, 0, nullptr,
                            nullptr),
        "clEnqueueFillBuffer", where);
  check(clFinish(device_->queue.get()), "clFinish", where);
}

const void* Memory::map_read() const {
  if (bytes_ == 0) return nullptr;
  int status = CL_SUCCESS;
  const void* pointer = clEnqueueMapBuffer(device_->queue.get(), memory_, CL_TRUE, CL_MAP_READ, 0, bytes_, 0,
                                           nullptr, nullptr, &status);
  check(status, "clEnqueueMapBuffer", description(name_, bytes_, device_->info));
  return pointer;
}

void Memory::unmap(const void* pointer) const noexcept {
  if (pointer == nullptr) return;
  clEnqueueUnmapMemObject(device_->queue.get(), memory_, const_cast<void*>(pointer), 0, nullptr, nullptr);
}

}  // namespace detail

}  // namespace offing::ocl
