#include <csignal>
#include <cstdio>
#include <iostream>
#include <new>
#include <string>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

#include "host/base/error.h"
#include "host/cli/devices_command.h"
#include "host/cli/error_report.h"
#include "host/cli/global_options.h"
#include "host/cli/ocean_command.h"
#include "host/scene/version.h"

namespace {

using offing::Error;
using offing::ErrorKind;
namespace cli = offing::cli;

// A signal handler can reach nothing but a global.
offing::CancelToken* cancel_on_signal = nullptr;

extern "C" void request_cancel(int) {
  cancel_on_signal->cancel();
}

/// The first Ctrl-C or kill asks to stop after the frame at hand, the second one ends the process at once.
void cancel_on_signals(offing::CancelToken& token) {
  cancel_on_signal = &token;
  struct sigaction action {};
  action.sa_handler = request_cancel;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

void build(CLI::App& app, cli::GlobalOptions& options) {
  app.description("Offing: oceans calibrated in metres, computed on any OpenCL device");
  app.set_version_flag("--version", "offing " + std::string(offing::scene::version()));
  app.set_help_flag("-h,--help", "print this help");
  app.get_formatter()->column_width(34);
  app.require_subcommand(1);
  cli::add_ocean_command(app, options);
  cli::add_devices_command(app, options);
  app.footer(R"(
Examples:
  offing devices
  offing ocean bake --wind-speed-mps 15 --size 512 --frames 0:47 --fps 24 --preview -o out
  offing ocean bake --spectrum-file 41010.data_spec --record 0 --frames 0:9 --combined -o out
  offing ocean stats scenes/storm.toml --seeds 20

Exit codes: 0 done, 1 failed, 2 wrong usage or input, 3 no usable device, 130 interrupted.)");
}

Error output_error() {
  return Error(ErrorKind::file, "standard output: cannot be written",
               "check the disk or the pipe it goes to");
}

/// Throws Error(file) if what was printed did not arrive.
void finish_output() {
  std::cout.flush();
  if (!std::cout || std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    throw output_error();
  }
}

int run(int argc, char** argv) {
  cli::GlobalOptions options;
  cancel_on_signals(options.cancel);
  offing::configure_log(options.verbosity);
  CLI::App app;
  build(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
      const int code = app.exit(error);  // prints the help or the version that was asked for
      finish_output();
      return code;
    }
    throw cli::usage_error(app, error);
  }
  finish_output();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const Error& error) {
    cli::report(error);
    return exit_code(error.kind());
  } catch (const std::bad_alloc&) {
    cli::report(Error(ErrorKind::out_of_memory, "memory: this needs more than the machine has",
                      "choose a smaller --size or fewer --cascades"));
    return exit_code(ErrorKind::out_of_memory);
  } catch (const std::exception& error) {
    if (std::ferror(stdout) != 0) {  // printing throws std::system_error where the output is full
      cli::report(output_error());
      return exit_code(ErrorKind::file);
    }
    cli::report(Error(ErrorKind::device, fmt::format("unexpected fault: {}", error.what()),
                      "run again with --verbose and report what it says"));
    return 1;
  }
}
