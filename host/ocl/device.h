#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "host/ocl/device_list.h"
#include "host/ocl/event.h"

// Opaque OpenCL handles, declared as the OpenCL headers declare them, so that only host/ocl includes those
// headers.
typedef struct _cl_device_id* cl_device_id;
typedef struct _cl_context* cl_context;
typedef struct _cl_command_queue* cl_command_queue;

namespace offing::ocl {

/// Whether the device keeps the times of its work, which events then give.
enum class Profiling { off, on };

namespace detail {
struct DeviceState;
}

/// An open device: its context and one in-order queue. A cheap shared handle; objects made from it are
/// confined to the thread that uses its queue.
class Device {
 public:
  /// Opens the device of select_device(selector).
  static Device open(std::string_view selector = {}, Profiling profiling = Profiling::off);
  static Device open(const DeviceInfo& info, Profiling profiling = Profiling::off);
  /// Opens the device so that it shares buffers with the OpenGL context that `share_properties` (pairs of
  /// property and value of cl_khr_gl_sharing) names, or without sharing where either side has none.
  static Device open_shared(const DeviceInfo& info, Profiling profiling,
                            std::span<const std::intptr_t> share_properties);
  /// A context and an in-order queue of the caller's, which stay open while this object or what was made from
  /// it lives. Throws Error(bad_usage) for a queue of another context or one that runs commands out of order.
  static Device adopt(cl_context context, cl_command_queue queue);

  const DeviceInfo& info() const;

  /// Submits what is queued without waiting.
  void flush() const;
  /// An event that is done when everything queued so far is.
  Event mark() const;
  /// Waits until everything queued is done. Throws Error(device) if a command failed.
  void finish() const;

  cl_device_id id() const;
  cl_context context() const;
  cl_command_queue queue() const;
  bool is_profiling() const;
  /// Whether ImportedBuffer can be used.
  bool shares_gl() const;
  const std::shared_ptr<detail::DeviceState>& state() const { return state_; }

 private:
  explicit Device(std::shared_ptr<detail::DeviceState> state);
  std::shared_ptr<detail::DeviceState> state_;
};

}  // namespace offing::ocl
