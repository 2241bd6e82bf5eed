#include "host/base/process.h"

#include <csignal>
#include <cstdio>
#include <iostream>
#include <new>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/error_report.h"

namespace offing {
namespace {

// Signals may come until the process ends, and their handler can reach nothing but a global.
constinit CancelToken stop;

extern "C" void request_stop(int) {
  stop.cancel();
}

void handle_signals() {
  struct sigaction action {};
  action.sa_handler = request_stop;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
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
  report(error);
  return exit_code(error.kind());
}

}  // namespace

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
