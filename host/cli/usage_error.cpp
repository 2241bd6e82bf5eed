#include "host/cli/usage_error.h"

#include <vector>

#include <CLI/Option.hpp>
#include <fmt/format.h>

#include "host/scene/nearest_name.h"

namespace offing::cli {

namespace {

/// The command that the arguments reached.
const CLI::App& innermost(const CLI::App& app) {
  const CLI::App* at = &app;
  while (!at->get_subcommands().empty()) {
    at = at->get_subcommands().front();
  }
  return *at;
}

/// "offing ocean bake".
std::string full_name(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return parent ? full_name(*parent) + ' ' + command.get_name() : std::string("offing");
}

std::vector<std::string> known_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      names.push_back("--" + name);
    }
  }
  for (const CLI::App* subcommand : command.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(subcommand->get_name());
  }
  return names;
}

}  // namespace

Error usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = innermost(app);
  const std::string help = fmt::format("`{} --help` lists what it takes", full_name(command));
  const std::vector<std::string> extras = command.remaining();
  // A misspelt command is left over, and then the one that is required is missing.
  const bool is_unknown_word = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr ||
                               dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
  if (!is_unknown_word || extras.empty()) {
    return Error(ErrorKind::bad_usage, fmt::format("{}: {}", full_name(command), error.what()), help);
  }
  const std::vector<std::string> names = known_names(command);
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  const std::string_view near = scene::nearest_name(extras.front(), candidates);
  return Error(ErrorKind::bad_usage,
               fmt::format("{}: expected options and commands that it knows, got \"{}\"", full_name(command),
                           extras.front().substr(0, 60)),
               near.empty() ? help : fmt::format("did you mean {}?", near));
}

}  // namespace offing::cli
