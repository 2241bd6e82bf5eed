#pragma once

typedef struct _cl_event* cl_event;

namespace offing::ocl {

/// A queued command: when it is done and, on a device opened with Profiling::on, how long it ran.
class Event {
 public:
  Event() = default;
  /// Owns both. `first`: of the part of the command that began before, if it has two.
  explicit Event(cl_event event, cl_event first = nullptr);
  Event(Event&& other) noexcept;
  Event& operator=(Event&& other) noexcept;
  ~Event();

  /// Waits for the command. Throws Error(device) if it failed.
  void wait() const;
  /// Waits for the command, then gives its run time on the device in seconds; throws Error(bad_usage) without
  /// profiling.
  double duration_s() const;
  /// Waits for the command, then gives the time of its end by the device's clock, in seconds from any start;
  /// errors as duration_s().
  double end_s() const;

 private:
  cl_event event_ = nullptr;
  cl_event first_ = nullptr;
};

}  // namespace offing::ocl
