#include "host/command_line/parse_arguments.h"

#include <string>
#include <string_view>
#include <vector>

#include <CLI/Config.hpp>
#include <CLI/Option.hpp>
#include <fmt/format.h>

#include "host/base/error.h"
#include "host/command_line/command_tree.h"
#include "host/command_line/print_results.h"
#include "host/scene/file/nearest_name.h"

namespace offing {
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
  return parent ? full_name(*parent) + ' ' + command.get_name() : command.get_name();
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

/// "offing ocean bake" for the name of a command that is found below another one; empty if there is none.
std::string command_below(const CLI::App& command, std::string_view name) {
  for (const CLI::App* subcommand : command.get_subcommands([](const CLI::App*) { return true; })) {
    if (subcommand->get_name() == name) return full_name(*subcommand);
    if (std::string found = command_below(*subcommand, name); !found.empty()) return found;
  }
  return {};
}

/// What the parser says, in the words of our own errors where it knows only its own.
std::string told(const CLI::ParseError& error) {
  const std::string_view text = error.what();
  // "--seeds: 1 required K missing".
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr && text.ends_with(" missing")) {
    return fmt::format("{}: expected a value, found none", text.substr(0, text.find(':')));
  }
  return std::string(text);
}

Error usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = innermost(app);
  const std::string help = fmt::format("`{} --help` lists its commands and options", full_name(command));
  const std::vector<std::string> extras = command.remaining();
  // A misspelt command is left over, and then the one that is required is missing.
  const bool is_unknown_word = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr ||
                               dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
  if (!is_unknown_word || extras.empty()) {
    const bool is_excluded = dynamic_cast<const CLI::ExcludesError*>(&error) != nullptr;
    return Error(ErrorKind::bad_usage, fmt::format("{}: {}", full_name(command), told(error)),
                 is_excluded ? "remove one of them" : help);
  }
  const std::vector<std::string> names = known_names(command);
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  std::string near(scene::nearest_name(extras.front(), candidates));
  if (near.empty()) near = command_below(app, extras.front());
  return Error(ErrorKind::bad_usage,
               fmt::format("{}: expected a known command or option, got \"{}\"", full_name(command),
                           extras.front().substr(0, 60)),
               near.empty() ? help : fmt::format("did you mean {}?", near));
}

/// The option of this name, such as "--times", of a command or of those that it belongs to; null without one.
const CLI::Option* option_of(const CLI::App& command, const std::string& name) {
  for (const CLI::App* at = &command; at != nullptr; at = at->get_parent()) {
    if (const CLI::Option* option = at->get_option_no_throw(name)) return option;
  }
  return nullptr;
}

/// Throws Error(bad_usage) for an argument that is empty, also after the = of "--times=": the parser would
/// take some for a flag that is not given.
void refuse_empty(const CLI::App& app, int argc, const char* const* argv) {
  const CLI::App* command = &app;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i], before = argv[i - 1];
    std::string flag;
    if (argument.empty()) {
      const CLI::Option* option = before.starts_with('-') ? option_of(*command, before) : nullptr;
      if (option != nullptr && option->get_items_expected_max() > 0) flag = before;
    } else if (argument.starts_with("--") && argument.find('=') == argument.size() - 1) {
      flag = argument.substr(0, argument.size() - 1);
      if (option_of(*command, flag) == nullptr) continue;
    } else {
      for (const CLI::App* below : command->get_subcommands([](const CLI::App*) { return true; })) {
        if (below->get_name() == argument) command = below;
      }
      continue;
    }
    if (flag.empty()) {
      throw Error(
          ErrorKind::bad_usage,
          fmt::format("{}: expected no empty argument, got \"\" as argument {}", full_name(*command), i),
          "leave it out; an unset shell variable gives an empty argument");
    }
    throw Error(
        ErrorKind::bad_usage, fmt::format("{}: expected a value, got \"\"", flag),
        fmt::format("give {} a value, or leave it out; an unset shell variable gives an empty argument",
                    flag));
  }
}

}  // namespace

bool parse_arguments(CLI::App& app, int argc, const char* const* argv) {
  if (argc == 2 && argv[1] == std::string_view("--print-commands")) {
    print_json(command_tree(app));
    return false;
  }
  refuse_empty(app, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
      app.exit(error);  // prints the help or the version that was asked for
      return false;
    }
    throw usage_error(app, error);
  }
  return true;
}

}  // namespace offing
