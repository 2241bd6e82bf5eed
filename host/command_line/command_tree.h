// The commands and options of a program as data, for man pages, completions and docs/reference.
#pragma once

#include <CLI/App.hpp>
#include <nlohmann/json.hpp>

namespace offing {

/// Program, version, and each command with its options, outer commands first. An option that sets a row of a
/// schema has the row's unit, range and choices as fields; of others there is only the help text.
nlohmann::ordered_json command_tree(const CLI::App& app);

}  // namespace offing
