// Finds options of a command line that are not rows of a schema.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/App.hpp>

namespace offing::test {

/// What a walk over all commands of a program has found.
struct OptionReport {
  std::vector<std::string> numbers;  ///< each option that takes a number, with what its row says
  std::vector<std::string> faults;
};

/// `texts` are the options whose values no row describes, by their names without dashes: names of files and
/// of devices, and texts of several numbers.
OptionReport report_options(const CLI::App& program, const std::set<std::string_view>& texts);

}  // namespace offing::test
