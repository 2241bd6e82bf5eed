#include <CLI/App.hpp>

#include "host/base/process.h"
#include "host/cli/commands.h"
#include "host/cli/common/global_options.h"
#include "host/command_line/parse_arguments.h"

namespace {

namespace cli = offing::cli;

int run(int argc, char** argv, const offing::CancelToken& cancel) {
  cli::GlobalOptions options{.device = {}, .cancel = cancel};
  offing::configure_log(options.verbosity);
  CLI::App app;
  cli::add_commands(app, options);
  offing::parse_arguments(app, argc, argv);
  offing::finish_output();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return offing::run_program([&](const offing::CancelToken& cancel) { return run(argc, argv, cancel); });
}
