#pragma once

#include <string>

#include <CLI/App.hpp>

namespace offing {

/// What help writes above a group of options: CLI11 2.6 calls its own OPTIONS, 2.3 Options.
std::string group_title(const std::string& group);

/// Gives the help of a program and of the commands that are added to it from now on its form: what flags do
/// in a column of its own, wrapped between words, without what flags exclude. A line break in a description
/// begins a line.
void format_help(CLI::App& app);

}  // namespace offing
