#pragma once

#include <CLI/App.hpp>

#include "host/cli/common/global_options.h"

namespace offing::cli {

/// `offing highlights`: the animated projectors of a scene's highlights, for other programs.
void add_highlights_command(CLI::App& app, GlobalOptions& options);

}  // namespace offing::cli
