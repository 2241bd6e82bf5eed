#pragma once

#include <CLI/App.hpp>

namespace offing {

/// Gives the help of a program and of the commands that are added to it from now on its form: what flags do
/// in a column of its own, wrapped between words, without what flags exclude. A line break in a description
/// begins a line.
void format_help(CLI::App& app);

/// Reads the arguments of main() and runs the callbacks of `app`, which has the program's name. False if they
/// asked for help, version or --print-commands (command_tree.h) instead, which is printed. Throws Error(bad_usage) for what the parser finds
/// wrong, with the nearest known option or command as the hint; what the callbacks throw passes through.
bool parse_arguments(CLI::App& app, int argc, const char* const* argv);

}  // namespace offing
