// The form of the text that --help prints.
#include "host/command_line/help_format.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/Formatter.hpp>
#include <CLI/Option.hpp>

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

/// A name and what it means beside it.
std::string row(const std::string& name, const std::string& text) {
  std::string lines = "  " + name;
  const std::string margin(name_columns, ' ');
  if (!text.empty() && lines.size() >= name_columns) lines += '\n' + margin;
  if (lines.size() < name_columns) lines.resize(name_columns, ' ');
  for (const char character : text) {
    lines += character;
    if (character == '\n') lines += margin;
  }
  return lines + '\n';
}

using Options = std::vector<const CLI::Option*>;

std::string name_of(const CLI::Option& option) {
  const bool is_flag = option.nonpositional();
  std::string name = option.get_name(!is_flag, is_flag);
  if (is_flag && option.get_type_size() != 0 && !option.get_type_name().empty())
    name += ' ' + option.get_type_name();
  return option.get_required() ? name + " (required)" : name;
}

/// Nothing without options.
std::string section(const std::string& title, const Options& options) {
  std::string rows;
  for (const CLI::Option* option : options) rows += row(name_of(*option), wrapped(option->get_description()));
  return rows.empty() ? rows : '\n' + title + ":\n" + rows;
}

std::string sections_of_flags(const CLI::App& app) {
  std::string text;
  const std::vector<std::string> groups = app.get_groups();
  for (const std::string& group : groups) {
    if (group.empty()) continue;  // hidden
    const std::string flags = section(group_title(group), app.get_options([&](const CLI::Option* option) {
      return option->nonpositional() && option->get_group() == group;
    }));
    text += flags;
    if (!flags.empty() && group != groups.back()) text += '\n';
  }
  return text;
}

/// All of the layout: that of CLI11 2.6 is another than that of 2.3, down to the titles.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode) const override {
    std::string usage = "Usage: " + name, commands;
    if (!app->get_options([](const CLI::Option* option) { return option->nonpositional(); }).empty())
      usage += " [OPTIONS]";
    const Options positionals = app->get_options(
        [](const CLI::Option* option) { return option->get_positional() && !option->get_group().empty(); });
    for (const CLI::Option* option : positionals) usage += ' ' + make_option_usage(option);
    for (const CLI::App* command :
         app->get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); }))
      commands += row(command->get_display_name(true), command->get_description());
    if (!commands.empty()) {
      usage += app->get_require_subcommand_min() == 0 ? " [SUBCOMMAND]" : " SUBCOMMAND";
      commands = "\nSubcommands:\n" + commands;
    }
    const std::string footer = app->get_footer().empty() ? "" : app->get_footer() + '\n';
    return app->get_description() + '\n' + usage + '\n' + section("Positionals", positionals) +
           sections_of_flags(*app) + commands + '\n' + footer;
  }
};

}  // namespace

std::string group_title(const std::string& group) {
  return group == "OPTIONS" ? "Options" : group;
}

void format_help(CLI::App& app) {
  app.formatter(std::make_shared<HelpFormatter>());
}

}  // namespace offing
