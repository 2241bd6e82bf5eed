#pragma once

#include <exception>
#include <future>
#include <new>
#include <string>
#include <system_error>
#include <thread>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"

/// Work on threads of its own, whose faults are Errors whatever they are: a window reports them and goes on.
namespace offing::present {

inline Error no_thread_error(const std::string& subject, const std::system_error& error) {
  return Error(ErrorKind::out_of_memory,
               fmt::format("{}: cannot start a thread: {}", subject, error.code().message()),
               "close other programs, or raise the limits of processes and memory (ulimit -u, -v)");
}

/// What no code expects: on a thread of its own it would end the program.
inline Error unexpected_error(const std::string& subject, const std::exception& error) {
  return Error(ErrorKind::device, fmt::format("{}: unexpected error: {}", subject, error.what()),
               "undo the last edit, and report this message");
}

/// A thread that runs this work. Throws Error(out_of_memory) where the system gives none.
template <class Work>
std::thread start_thread(const std::string& subject, Work work) {
  try {
    return std::thread(std::move(work));
  } catch (const std::system_error& error) {
    throw no_thread_error(subject, error);
  }
}

/// Runs work on a thread of its own, which the future waits for. The future throws nothing but Errors:
/// `no_memory` for std::bad_alloc. Throws Error(out_of_memory) where the system gives no thread.
template <class Work>
std::future<std::invoke_result_t<Work&>> run_in_background(const std::string& subject, const Error& no_memory,
                                                           Work work) {
  auto guarded = [subject, no_memory, work = std::move(work)]() mutable {
    try {
      return work();
    } catch (const Error&) {
      throw;
    } catch (const std::bad_alloc&) {
      throw no_memory;
    } catch (const std::exception& error) {
      throw unexpected_error(subject, error);
    }
  };
  try {
    return std::async(std::launch::async, std::move(guarded));
  } catch (const std::system_error& error) {
    throw no_thread_error(subject, error);
  }
}

}  // namespace offing::present
