#include "host/ocl/event.h"

#include <utility>

#include "host/base/error.h"
#include "host/ocl/opencl.h"
#include "host/ocl/status.h"

namespace offing::ocl {
namespace {

// Waits for the command and asks its clock.
double event_time_s(cl_event event, cl_profiling_info what) {
  if (event == nullptr) {
    throw Error(ErrorKind::bad_usage, "Event: the command was not profiled",
                "open the device with Profiling::on");
  }
  check(clWaitForEvents(1, &event), "clWaitForEvents", "a queued command");
  cl_ulong time_ns = 0;
  const int status = clGetEventProfilingInfo(event, what, sizeof time_ns, &time_ns, nullptr);
  check(status, "clGetEventProfilingInfo", "a kernel's event");
  return static_cast<double>(time_ns) * 1e-9;
}

}  // namespace

Event::Event(cl_event event, cl_event first) : event_(event), first_(first) {}

Event::Event(Event&& other) noexcept
    : event_(std::exchange(other.event_, nullptr)), first_(std::exchange(other.first_, nullptr)) {}

Event& Event::operator=(Event&& other) noexcept {
  std::swap(event_, other.event_);
  std::swap(first_, other.first_);
  return *this;
}

Event::~Event() {
  for (const cl_event event : {event_, first_}) {
    if (event != nullptr) clReleaseEvent(event);
  }
}

void Event::wait() const {
  if (event_ != nullptr) check(clWaitForEvents(1, &event_), "clWaitForEvents", "a queued command");
}

double Event::duration_s() const {
  const cl_event first = first_ == nullptr ? event_ : first_;
  return event_time_s(event_, CL_PROFILING_COMMAND_END) - event_time_s(first, CL_PROFILING_COMMAND_START);
}

double Event::end_s() const {
  return event_time_s(event_, CL_PROFILING_COMMAND_END);
}

}  // namespace offing::ocl
