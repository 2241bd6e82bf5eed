#include "present/frame_name.h"

#include <regex>

#include <fmt/format.h>

#include "host/base/argument.h"
#include "present/picture_file.h"

namespace offing::present {

FrameName::FrameName(std::string_view pattern) {
  static const std::regex form("([^%]*)%0?([1-9]?)d([^%]*)");
  const std::string text(pattern);
  std::smatch parts;
  if (!std::regex_match(text, parts, form)) {
    throw bad_argument("--record", "a name with one %04d for the frame's number", pattern, "out_%04d.png");
  }
  before_ = parts[1];
  digits_ = parts[2].length() == 0 ? 1 : std::stoi(parts[2]);
  after_ = parts[3];
  require_picture_name(text);
}

std::filesystem::path FrameName::of(int frame) const {
  return fmt::format("{}{:0{}}{}", before_, frame, digits_, after_);
}

}  // namespace offing::present
