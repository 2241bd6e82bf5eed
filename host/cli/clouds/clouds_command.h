#pragma once

#include <CLI/App.hpp>

#include "host/cli/common/global_options.h"

namespace offing::cli {

/// `offing clouds`: clouds of scenes as files of other programs, and what such files hold.
void add_clouds_command(CLI::App& app, GlobalOptions& options);

}  // namespace offing::cli
