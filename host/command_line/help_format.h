#pragma once

#include <CLI/App.hpp>

namespace offing {

/// Gives the help of a program and of the commands that are added to it from now on its form: what flags do
/// in a column of its own, wrapped between words, without what flags exclude. A line break in a description
/// begins a line.
void format_help(CLI::App& app);

}  // namespace offing
