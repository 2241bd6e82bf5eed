#include "present/panels/value_search.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string>

#include <fmt/format.h>

#include "present/panels/parameter_widget.h"

namespace offing::present {
namespace {

std::string lower_case(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool has_words(const std::string& text, std::string_view wanted) {
  std::istringstream words(lower_case(std::string(wanted)));
  bool has_any = false;
  for (std::string word; words >> word; has_any = true) {
    if (text.find(word) == std::string::npos) return false;
  }
  return has_any;
}

std::string name_text(std::string_view panel, const scene::Parameter& row) {
  return lower_case(fmt::format("{} {} {}", panel, words_of(row), row.key));
}

}  // namespace

bool is_found(std::string_view wanted, std::string_view panel, const scene::Parameter& row) {
  return has_words(name_text(panel, row), wanted);
}

bool is_found_alike(std::string_view wanted, std::string_view panel, const scene::Parameter& row) {
  constexpr std::size_t least_letters = 4, most_ending = 3;
  std::istringstream words{std::string(wanted)};
  std::string stems;
  for (std::string word; words >> word;) {
    const std::size_t ending =
        word.size() > least_letters ? std::min(word.size() - least_letters, most_ending) : 0;
    stems += word.substr(0, word.size() - ending) + ' ';
  }
  return has_words(name_text(panel, row), stems);
}

bool is_found_in_help(std::string_view wanted, std::string_view panel, const scene::Parameter& row) {
  return has_words(name_text(panel, row) + ' ' + lower_case(std::string(row.help)), wanted);
}

}  // namespace offing::present
