#pragma once

#include <CLI/App.hpp>

namespace offing {

/// Reads the arguments of main() and runs the callbacks of `app`, which has the program's name. False if they
/// asked for help, version or --print-commands (command_tree.h) instead, which is printed. Throws Error(bad_usage)
/// for an empty argument and for what the parser finds wrong, with the nearest known option or command as the hint;
/// what the callbacks throw passes through.
bool parse_arguments(CLI::App& app, int argc, const char* const* argv);

}  // namespace offing
