#include "host/base/frame_name.h"

#include <regex>

#include <fmt/format.h>

#include "host/base/argument.h"

namespace offing {

FrameName::FrameName(std::string_view flag, std::string_view pattern, std::string_view example) {
  static const std::regex form("([^%]*)%0?([1-9]?)d([^%]*)");
  const std::string text(pattern);
  std::smatch parts;
  if (!std::regex_match(text, parts, form)) {
    throw bad_argument(flag, "a name with one %04d for the frame's number", pattern, example);
  }
  before_ = parts[1];
  digits_ = parts[2].length() == 0 ? 1 : std::stoi(parts[2]);
  after_ = parts[3];
}

std::filesystem::path FrameName::of(int frame) const {
  return fmt::format("{}{:0{}}{}", before_, frame, digits_, after_);
}

}  // namespace offing
