#pragma once

#include <CLI/App.hpp>

#include "host/base/error.h"

namespace offing::cli {

/// What the command line parser found wrong, with the nearest known option or command as the hint.
Error usage_error(const CLI::App& app, const CLI::ParseError& error);

}  // namespace offing::cli
