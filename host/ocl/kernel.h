#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include "host/ocl/buffer.h"
#include "host/ocl/event.h"

typedef struct _cl_event* cl_event;
typedef struct _cl_kernel* cl_kernel;

namespace offing::ocl {

/// Global and local work sizes. Zeros behind the first number stand for 1, so that {{rows}, {16}} is
/// one-dimensional. A local size of {} is for kernels that ask for nothing but their global id: the driver
/// chooses one, or the kernel runs in parts.
struct LaunchShape {
  std::array<std::size_t, 3> global{1};
  std::array<std::size_t, 3> local{};
};

/// A __local pointer argument of this many bytes.
struct LocalMemory {
  std::size_t bytes = 0;
};

/// A kernel with checked arguments. Copies share it: one launches at a time.
class Kernel {
 public:
  Kernel() = default;

  /// Sets all arguments and queues the kernel. Arguments are Buffer<T> (for __global pointers), LocalMemory,
  /// or plain 4- and 8-byte scalars and structs from kernels/shared. Throws Error(bad_usage) that names
  /// kernel and argument if their number or size or kind differs from the kernel's; Error(device) or
  /// Error(out_of_memory) if the driver refuses.
  template <class... Args>
  Event launch(const LaunchShape& shape, const Args&... args) const {
    begin_launch(sizeof...(Args));
    int index = 0;
    (set_argument(index++, args), ...);
    return enqueue(shape);
  }

  const std::string& name() const;

 private:
  friend class Program;
  struct State;
  /// Owns `kernel`, which is a kernel of this name on this device.
  Kernel(std::shared_ptr<detail::DeviceState> device, cl_kernel kernel, std::string name);

  template <class T>
  void set_argument(int index, const Buffer<T>& buffer) const {
    set_memory(index, buffer.handle());
  }
  void set_argument(int index, const LocalMemory& local) const;
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void set_argument(int index, const T& value) const {
    constexpr bool is_integer = std::is_integral_v<T> || std::is_enum_v<T>;
    set_value(index, sizeof(T), &value,
              is_integer ? ValueKind::integer
                         : (std::is_floating_point_v<T> ? ValueKind::floating : ValueKind::structure));
  }

  enum class ValueKind { integer, floating, structure };

  void begin_launch(std::size_t argument_count) const;
  void set_memory(int index, cl_mem memory) const;
  void set_value(int index, std::size_t bytes, const void* value, ValueKind kind) const;
  Event enqueue(const LaunchShape& shape) const;
  /// The work-items from `first_column` of the first dimension on; null where the device does not profile.
  cl_event enqueue_part(std::size_t first_column, const LaunchShape& shape) const;

  std::shared_ptr<State> state_;
};

}  // namespace offing::ocl
