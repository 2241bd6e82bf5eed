#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstring>
#include <exception>
#include <new>
#include <string>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/c/offing.h"

/// What all calls of the C interface share: their status, the use of handles, and structs with a size.
namespace offing::c {

/// Remembers why a call of this thread failed; returns its status.
OffingStatus fail(OffingStatus status, const char* error, const char* hint) noexcept;
OffingStatus status_of(ErrorKind kind);

/// Sends warnings to stderr, at the first call of a process: spdlog's default logger writes to stdout, which
/// is the program's. A logger that the program has set stays.
void log_to_stderr();

/// Thrown for a handle that another thread is using.
class Busy : public Error {
 public:
  explicit Busy(const char* what)
      : Error(ErrorKind::bad_usage, fmt::format("{}: another thread is in a call with it", what),
              "make one for each thread, or let calls with it take turns by a lock of your own") {}
};

/// Runs the work of a call. An exception becomes the call's status and the thread's last failure.
template <class Work>
OffingStatus run(const Work& work) noexcept {
  try {
    log_to_stderr();
    work();
    return OFFING_OK;
  } catch (const Busy& error) {
    return fail(OFFING_BUSY, error.what(), error.hint().c_str());
  } catch (const Error& error) {
    return fail(status_of(error.kind()), error.what(), error.hint().c_str());
  } catch (const std::bad_alloc&) {
    return fail(OFFING_FAILED, "out of memory", "ask for fewer points at a time, or smaller maps");
  } catch (const std::exception& error) {
    return fail(OFFING_FAILED, error.what(), "");
  }
}

/// Base of the handles that one thread at a time may use.
struct OneAtATime {
  std::atomic<bool> is_in_use = false;
};

/// A call's use of such a handle. Throws Busy while another call uses it.
class Use {
 public:
  Use(OneAtATime* handle, const char* name) : handle_(handle) {
    if (handle == nullptr) {
      throw Error(ErrorKind::bad_usage, fmt::format("{}: expected a pointer, got NULL", name),
                  "pass what offing.h asks for");
    }
    if (handle->is_in_use.exchange(true, std::memory_order_acquire)) throw Busy(name);
  }
  Use(const Use&) = delete;
  Use& operator=(const Use&) = delete;
  ~Use() { handle_->is_in_use.store(false, std::memory_order_release); }

 private:
  OneAtATime* handle_;
};

/// Throws Error(bad_usage) for NULL.
void require(const void* argument, const char* name);

/// Throws Error(bad_usage) unless an array's `count` is the expected one.
void require_count(const char* name, std::size_t count, std::size_t expected);

/// A copy of a caller's struct, whose first member is its size. Members that the caller's version lacks are
/// zero, and all members are for NULL.
template <class Struct>
Struct read_struct(const Struct* given, const char* name) {
  Struct whole{};
  if (given == nullptr) return whole;
  if (given->size < sizeof(std::size_t)) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("{}: expected size to be that of the struct, got {}", name, given->size),
                "set size to sizeof the struct before the call");
  }
  std::memcpy(&whole, given, std::min(given->size, sizeof whole));
  whole.size = sizeof whole;
  return whole;
}

/// Writes the members of a caller's struct that its version has, but for its size.
template <class Struct>
void write_struct(Struct* target, const char* name, const Struct& values) {
  require(target, name);
  const std::size_t size = target->size;
  if (size < sizeof(std::size_t)) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("{}: expected size to be that of the struct, got {}", name, size),
                "set size to sizeof the struct before the call");
  }
  std::memcpy(target, &values, std::min(size, sizeof values));
  target->size = size;
}

/// A text in an array of a struct, cut to fit, ended by 0.
template <std::size_t Size>
void write_text(char (&target)[Size], const std::string& text) {
  const std::size_t length = std::min(text.size(), Size - 1);
  std::memcpy(target, text.data(), length);
  target[length] = '\0';
}

}  // namespace offing::c
