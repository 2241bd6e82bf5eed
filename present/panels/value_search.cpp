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

}  // namespace

bool is_found(std::string_view wanted, std::string_view panel, const scene::Parameter& row) {
  const std::string text = lower_case(fmt::format("{} {} {}", panel, words_of(row), row.key));
  std::istringstream words(lower_case(std::string(wanted)));
  bool has_any = false;
  for (std::string word; words >> word; has_any = true) {
    if (text.find(word) == std::string::npos) return false;
  }
  return has_any;
}

}  // namespace offing::present
