#include <CLI/App.hpp>

#include "host/base/process.h"
#include "host/command_line/parse_arguments.h"
#include "mesh_tools/commands/mesh_commands.h"

namespace {

namespace mesh_tools = offing::mesh_tools;

int run(int argc, char** argv, const offing::CancelToken& cancel) {
  mesh_tools::Options options{.cancel = cancel};
  offing::configure_log(options.verbosity);
  CLI::App app;
  mesh_tools::add_commands(app, options);
  offing::parse_arguments(app, argc, argv);
  offing::finish_output();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return offing::run_program([&](const offing::CancelToken& cancel) { return run(argc, argv, cancel); });
}
