// Names of the frames of a sequence, from their pattern and back.
#include "host/io/frame_name.h"

#include <charconv>
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

FrameName FrameName::in(const std::filesystem::path& folder) const {
  FrameName name = *this;
  name.before_ = (folder / before_).string();
  return name;
}

std::string FrameName::prefix() const {
  return before_.substr(before_.rfind('/') + 1);  // npos + 1 is 0
}

std::optional<int> FrameName::frame_of(std::string_view file_name) const {
  const std::string before = prefix();
  if (file_name.size() <= before.size() + after_.size() || !file_name.starts_with(before))
    return std::nullopt;
  const std::string_view digits =
      file_name.substr(before.size(), file_name.size() - before.size() - after_.size());
  int frame = 0;
  const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), frame);
  if (failure != std::errc() || end != digits.data() + digits.size() || frame < 0) return std::nullopt;
  if (of(frame).filename() != file_name) return std::nullopt;  // "7" is not frame 7 of "%04d"
  return frame;
}

}  // namespace offing
