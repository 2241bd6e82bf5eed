#include "host/command_line/parse_arguments.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <CLI/Option.hpp>
#include <fmt/format.h>

#include "host/base/error.h"
#include "host/command_line/command_tree.h"
#include "host/command_line/print_results.h"
#include "host/scene/file/nearest_name.h"

namespace offing {
namespace {

constexpr std::size_t name_columns = 34, text_columns = 76;

/// The text with line breaks between words, so that no line is longer than text_columns but by one word.
std::string wrapped(std::string_view text) {
  std::string lines;
  std::size_t length = 0;
  while (!text.empty()) {
    const std::size_t end = text.find_first_of(" \n");
    const std::string_view word = text.substr(0, end);
    if (length > 0 && length + 1 + word.size() > text_columns) {
      lines += '\n';
      length = 0;
    } else if (length > 0) {
      lines += ' ';
      ++length;
    }
    lines += word;
    length += word.size();
    if (end == std::string_view::npos) break;
    if (text[end] == '\n') {
      lines += '\n';
      length = 0;
    }
    text.remove_prefix(end + 1);
  }
  return lines;
}

class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter() { column_width(name_columns); }

  std::string make_option_opts(const CLI::Option* option) const override {
    const bool has_value =
        option->nonpositional() && option->get_type_size() != 0 && !option->get_type_name().empty();
    return (has_value ? ' ' + option->get_type_name() : std::string()) +
           (option->get_required() ? " (required)" : "");
  }

  std::string make_option_desc(const CLI::Option* option) const override {
    return wrapped(option->get_description());
  }
};

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
  const std::string help = fmt::format("`{} --help` lists what it takes", full_name(command));
  const std::vector<std::string> extras = command.remaining();
  // A misspelt command is left over, and then the one that is required is missing.
  const bool is_unknown_word = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr ||
                               dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
  if (!is_unknown_word || extras.empty()) {
    return Error(ErrorKind::bad_usage, fmt::format("{}: {}", full_name(command), told(error)), help);
  }
  const std::vector<std::string> names = known_names(command);
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  std::string near(scene::nearest_name(extras.front(), candidates));
  if (near.empty()) near = command_below(app, extras.front());
  return Error(ErrorKind::bad_usage,
               fmt::format("{}: expected options and commands that it knows, got \"{}\"", full_name(command),
                           extras.front().substr(0, 60)),
               near.empty() ? help : fmt::format("did you mean {}?", near));
}

}  // namespace

void format_help(CLI::App& app) {
  app.formatter(std::make_shared<HelpFormatter>());
}

bool parse_arguments(CLI::App& app, int argc, const char* const* argv) {
  if (argc == 2 && argv[1] == std::string_view("--print-commands")) {
    print_json(command_tree(app));
    return false;
  }
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
