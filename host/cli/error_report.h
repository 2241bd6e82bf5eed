#pragma once

#include <string>
#include <string_view>

#include <CLI/App.hpp>

#include "host/base/error.h"

namespace offing::cli {

/// Prints an error to stderr as its two lines, `error: ...` and `hint: ...`.
void report(const Error& error);

/// One printable line: control characters, as hostile file names hold them, become \xNN.
std::string one_line(std::string_view text);

/// What the command line parser found wrong, with the nearest known option or command as the hint.
Error usage_error(const CLI::App& app, const CLI::ParseError& error);

}  // namespace offing::cli
