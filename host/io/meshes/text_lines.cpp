#include "host/io/meshes/text_lines.h"

#include <charconv>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/file_mark.h"

namespace offing::meshes {
namespace {

constexpr std::string_view blanks = " \t\r\v\f";

std::string_view without_leading_blanks(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(blanks);
  return begin == std::string_view::npos ? std::string_view() : text.substr(begin);
}

std::string quoted(std::string_view word) {
  return word.empty() ? "the end of the line" : '"' + printable(word) + '"';
}

/// std::from_chars wants no '+' in front.
std::string_view without_plus(std::string_view word) {
  return word.starts_with('+') && !word.starts_with("+-") ? word.substr(1) : word;
}

}  // namespace

TextLines::TextLines(std::string_view text, std::string_view file_name, std::size_t lines_before)
    : remaining_(lines_before == 0 ? without_byte_order_mark(text) : text),
      file_name_(file_name),
      line_number_(lines_before) {}

bool TextLines::next_line() {
  while (!remaining_.empty()) {
    const std::size_t end = remaining_.find('\n');
    rest_ = remaining_.substr(0, end);
    remaining_.remove_prefix(end == std::string_view::npos ? remaining_.size() : end + 1);
    ++line_number_;
    rest_ = without_leading_blanks(rest_.substr(0, rest_.find('#')));
    if (!rest_.empty()) return true;
  }
  rest_ = {};
  return false;
}

void TextLines::need_line(std::string_view expected) {
  if (!next_line()) fail(expected, "the end of the file");
}

std::string_view TextLines::word() {
  const std::string_view word = rest_.substr(0, rest_.find_first_of(blanks));
  rest_ = without_leading_blanks(rest_.substr(word.size()));
  return word;
}

double TextLines::number(std::string_view expected) {
  const std::string_view found = word(), digits = without_plus(found);
  double value = 0.0;
  const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  // Too large or too small for a double: the C function tells which, and makes 0 of the small ones.
  if (status == std::errc::result_out_of_range) value = std::strtod(std::string(digits).c_str(), nullptr);
  if (status == std::errc::invalid_argument || end != digits.data() + digits.size() ||
      !std::isfinite(value)) {
    fail(expected, quoted(found));
  }
  return value;
}

std::int64_t TextLines::whole(std::string_view expected) {
  const std::string_view found = word(), digits = without_plus(found);
  std::int64_t value = 0;
  const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (status != std::errc() || end != digits.data() + digits.size()) fail(expected, quoted(found));
  return value;
}

void TextLines::fail(std::string_view expected, std::string_view got) const {
  throw mesh_error(file_name_, line_number_, expected, got);
}

Error mesh_error(std::string_view file_name, std::size_t line_number, std::string_view expected,
                 std::string_view got) {
  const std::string place = line_number == 0 ? "" : fmt::format(":{}", line_number);
  return {ErrorKind::bad_input,
          fmt::format("{}{}: expected {}, got {}", one_line(file_name), place, expected, got),
          "export the mesh again, or correct the file there"};
}

}  // namespace offing::meshes
