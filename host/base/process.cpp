#include "host/base/process.h"

#include <array>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <new>
#include <string_view>

#include <fmt/format.h>
#include <unistd.h>

#include "host/base/error.h"

namespace offing {
namespace {

// A signal handler can take no lock: each slot is claimed, and given back, in one exchange.
constinit std::array<std::atomic<const char*>, 256> slots{};
static_assert(std::atomic<const char*>::is_always_lock_free);
constinit std::atomic<bool> is_ending{false};

void exchange_in_one_slot(const char* expected, const char* wanted) {
  for (std::atomic<const char*>& slot : slots) {
    const char* found = expected;
    if (slot.compare_exchange_strong(found, wanted)) break;
  }
  // The handler may be reading the path, which must stay until it ends the process.
  while (is_ending) pause();
}

// Signals may come until the process ends, and their handler can reach nothing but a global.
constinit CancelToken stop;
constinit std::atomic<bool> is_reported{false}, is_pipe_broken{false};

// A launch of a kernel, a driver's compiler, a library or a read from a pipe may take any time: work that
// has not ended by itself after this is ended.
constexpr unsigned grace_s = 1;

// No destructor runs: other threads may be anywhere.
[[noreturn]] void end_at_once() {
  remove_unfinished_files();
  if (!is_pipe_broken && !is_reported.exchange(true)) {
    constexpr std::string_view text =
        "error: stopped at the user's request\nhint: run the same command again\n";
    // Nobody is left to report a failure to.
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
  }
  _exit(exit_code(ErrorKind::cancelled));
}

// Does only what is safe in a signal handler.
extern "C" void request_stop(int number) {
  if (number == SIGPIPE) {
    is_pipe_broken = true;
    if (stop.cancelled()) return;  // what is printed until the end breaks it again
  }
  if (stop.cancelled()) end_at_once();  // the second signal, or the alarm
  stop.cancel();
  alarm(grace_s);
}

void handle_signals() {
  struct sigaction action {};
  action.sa_handler = request_stop;
  action.sa_flags = SA_RESTART;
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGALRM}) sigaddset(&action.sa_mask, number);
  struct sigaction before {};
  sigaction(SIGHUP, nullptr, &before);
  const bool survives_terminal = before.sa_handler == SIG_IGN;  // started by nohup
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGALRM}) {
    if (number != SIGHUP || !survives_terminal) sigaction(number, &action, nullptr);
  }
  // A write beyond the limit of file sizes is to fail, not to end the process half-way.
  std::signal(SIGXFSZ, SIG_IGN);
}

Error output_error() {
  return Error(ErrorKind::file, "standard output: cannot be written",
               "check the disk or the pipe it goes to");
}

// LLVM, within a driver, deletes its temporary files at a signal: what it was building then fails, which is
// no fault of the driver.
int until_stopped(const std::function<int(const CancelToken&)>& work) {
  try {
    return work(stop);
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::build_failed) stop.throw_if_cancelled();
    throw;
  }
}

int report_and_code(const Error& error) {
  // Whoever read the output has had enough, as `head` has.
  if (is_pipe_broken) return exit_code(ErrorKind::cancelled);
  if (!is_reported.exchange(true)) report(error);
  return exit_code(error.kind());
}

}  // namespace

void mark_unfinished(const char* path) noexcept {
  exchange_in_one_slot(nullptr, path);
}

void unmark_unfinished(const char* path) noexcept {
  exchange_in_one_slot(path, nullptr);
}

void remove_unfinished_files() noexcept {
  is_ending = true;
  for (std::atomic<const char*>& slot : slots) {
    if (const char* path = slot.exchange(nullptr)) unlink(path);
  }
}

void finish_output() {
  std::cout.flush();
  if (!std::cout || std::fflush(stdout) != 0 || std::ferror(stdout) != 0) throw output_error();
}

int run_program(const std::function<int(const CancelToken&)>& work) {
  handle_signals();
  try {
    return until_stopped(work);
  } catch (const Error& error) {
    return report_and_code(error);
  } catch (const std::bad_alloc&) {
    return report_and_code(
        Error(ErrorKind::out_of_memory, "memory: this needs more than the machine has",
              "ask for less at once: a smaller --size, fewer --cascades, a part of the mesh"));
  } catch (const std::exception& error) {
    // Printing throws std::system_error where the output is full.
    if (std::ferror(stdout) != 0) return report_and_code(output_error());
    return report_and_code(Error(ErrorKind::device, fmt::format("unexpected fault: {}", error.what()),
                                 "run again with --verbose and report what it says"));
  }
}

}  // namespace offing
