#pragma once

#include "host/cli/common/global_options.h"

namespace offing::cli {

/// `offing devices [--json]`: what OpenCL offers on this machine, and which device a command takes by
/// default. `options` must outlive the application.
void add_devices_command(CLI::App& app, GlobalOptions& options);

}  // namespace offing::cli
