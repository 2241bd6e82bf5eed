// The form of the text that --help prints.
#include "host/command_line/help_format.h"

#include <memory>
#include <string>
#include <string_view>

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

}  // namespace

void format_help(CLI::App& app) {
  app.formatter(std::make_shared<HelpFormatter>());
}

}  // namespace offing
