#pragma once

#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/base/log.h"

/// What commands print to standard output.
namespace offing {

/// Prints results as scripts take them. Bytes that are no UTF-8, as names of files may hold, are replaced.
void print_json(const nlohmann::ordered_json& json);

/// Prints to standard output what a command made, such as the size of the file it wrote; nothing with
/// --quiet. Results, which are what a command is run for, are printed without asking.
template <class... Arguments>
void print_summary(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
  if (spdlog::should_log(spdlog::level::info)) fmt::print(text, std::forward<Arguments>(arguments)...);
}

}  // namespace offing
