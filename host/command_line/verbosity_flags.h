#pragma once

#include <CLI/App.hpp>

#include "host/base/log.h"

namespace offing {

/// Where the help lists what every command understands.
inline constexpr const char* general_group = "General";

/// Adds --quiet and --verbose to a command, and has the log follow them. `verbosity` must outlive it.
void add_verbosity_flags(CLI::App& command, Verbosity& verbosity);

}  // namespace offing
