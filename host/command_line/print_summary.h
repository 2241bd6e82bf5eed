#pragma once

#include <utility>

#include <fmt/format.h>

#include "host/base/log.h"

namespace offing {

/// Prints to standard output what a command made, such as the size of the file it wrote; nothing with
/// --quiet. Results, which are what a command is run for, are printed without asking.
template <class... Arguments>
void print_summary(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
  if (spdlog::should_log(spdlog::level::info)) fmt::print(text, std::forward<Arguments>(arguments)...);
}

}  // namespace offing
