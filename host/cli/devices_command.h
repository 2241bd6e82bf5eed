#pragma once

#include <CLI/App.hpp>

namespace offing::cli {

/// `offing devices [--json]`: what OpenCL offers on this machine, and which device a command takes by
/// default.
void add_devices_command(CLI::App& app);

}  // namespace offing::cli
