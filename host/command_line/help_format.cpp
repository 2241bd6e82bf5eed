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

/// All of the layout: that of CLI11 2.6 is another than that of 2.3, down to the titles.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode) const override {
    return app->get_description() + '\n' + make_usage(app, name) + make_positionals(app) +
           option_groups(app) + subcommands(app) + '\n' +
           (app->get_footer().empty() ? "" : app->get_footer() + '\n');
  }

  std::string make_usage(const CLI::App* app, std::string name) const override {
    std::string line = "Usage: " + name;
    if (!app->get_options([](const CLI::Option* option) { return option->nonpositional(); }).empty())
      line += " [OPTIONS]";
    for (const CLI::Option* option : positionals(app)) line += ' ' + make_option_usage(option);
    if (!commands(app).empty())
      line += app->get_require_subcommand_min() == 0 ? " [SUBCOMMAND]" : " SUBCOMMAND";
    return line + '\n';
  }

  std::string make_positionals(const CLI::App* app) const override {
    Options shown;
    for (const CLI::Option* option : positionals(app)) {
      if (!option->get_group().empty()) shown.push_back(option);
    }
    return shown.empty() ? std::string() : make_group("Positionals", true, shown);
  }

  std::string option_groups(const CLI::App* app) const {
    std::string text;
    const std::vector<std::string> groups = app->get_groups();
    for (const std::string& group : groups) {
      const Options options = app->get_options(
          [&](const CLI::Option* option) { return option->nonpositional() && option->get_group() == group; });
      if (group.empty() || options.empty()) continue;
      text += make_group(group_title(group), false, options);
      if (group != groups.back()) text += '\n';
    }
    return text;
  }

  std::string make_group(std::string group, bool is_positional, Options options) const override {
    std::string text = '\n' + group + ":\n";
    for (const CLI::Option* option : options) {
      text += row(make_option_name(option, is_positional) + make_option_opts(option),
                  wrapped(option->get_description()));
    }
    return text;
  }

  static std::string subcommands(const CLI::App* app) {
    std::string text;
    for (const CLI::App* command : commands(app))
      text += row(command->get_display_name(true), command->get_description());
    return text.empty() ? text : "\nSubcommands:\n" + text;
  }

  std::string make_option_opts(const CLI::Option* option) const override {
    const bool has_value =
        option->nonpositional() && option->get_type_size() != 0 && !option->get_type_name().empty();
    return (has_value ? ' ' + option->get_type_name() : std::string()) +
           (option->get_required() ? " (required)" : "");
  }

 private:
  static Options positionals(const CLI::App* app) {
    return app->get_options([](const CLI::Option* option) { return option->get_positional(); });
  }
  static std::vector<const CLI::App*> commands(const CLI::App* app) {
    return app->get_subcommands([](const CLI::App* command) {
      return !command->get_name().empty() && !command->get_group().empty();
    });
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
