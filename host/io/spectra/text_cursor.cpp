#include "host/io/spectra/text_cursor.h"

#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "host/base/error.h"

namespace offing::spectra {
namespace {

constexpr std::string_view truncated_hint = "the file seems cut short: get or write it again";

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_sign(char c) {
  return c == '+' || c == '-';
}
bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

std::size_t digits_from(std::string_view text, std::size_t at) {
  while (at < text.size() && is_digit(text[at])) ++at;
  return at;
}

// Where the exponent that starts at `at` ends, or `at` if there is none. Without its letter it must have
// three digits, as Fortran then writes it, and no point after them: "40.98-171.12" is two numbers.
std::size_t exponent_end(std::string_view text, std::size_t at) {
  if (at >= text.size()) return at;
  const bool has_letter = std::string_view("eEdD").find(text[at]) != std::string_view::npos;
  std::size_t digits = at + (has_letter ? 1 : 0);
  const bool has_sign = digits < text.size() && is_sign(text[digits]);
  if (has_sign) ++digits;
  const std::size_t end = digits_from(text, digits);
  if (end == digits) return at;
  if (has_letter) return end;
  const bool is_bare_exponent = has_sign && end - digits == 3 && (end == text.size() || text[end] != '.');
  return is_bare_exponent ? end : at;
}

}  // namespace

std::string printable_name(std::string_view name) {
  return one_line(name);
}

std::optional<double> take_number(std::string_view& rest) {
  std::size_t begin = 0;
  while (begin < rest.size() && (is_space(rest[begin]) || rest[begin] == ',')) ++begin;
  const std::string_view text = rest.substr(begin);
  const std::size_t first = !text.empty() && is_sign(text[0]) ? 1 : 0;
  std::size_t mantissa_end = digits_from(text, first);
  std::size_t digit_count = mantissa_end - first;
  if (mantissa_end < text.size() && text[mantissa_end] == '.') {
    const std::size_t fraction_end = digits_from(text, mantissa_end + 1);
    digit_count += fraction_end - mantissa_end - 1;
    mantissa_end = fraction_end;
  }
  if (digit_count == 0) return std::nullopt;
  const std::size_t end = exponent_end(text, mantissa_end);

  // std::from_chars wants no '+' in front and an 'e' before the exponent; 128 characters hold any real
  // number.
  std::array<char, 128> buffer;
  std::size_t length = 0;
  if (end + 1 > buffer.size()) return std::nullopt;
  for (std::size_t i = text[0] == '+' ? 1 : 0; i < mantissa_end; ++i) buffer[length++] = text[i];
  bool exponent_is_negative = false;
  if (end > mantissa_end) {
    buffer[length++] = 'e';
    std::size_t i = mantissa_end + (is_sign(text[mantissa_end]) ? 0 : 1);
    for (; i < end; ++i) {
      exponent_is_negative |= text[i] == '-';
      buffer[length++] = text[i];
    }
  }
  double value = 0.0;
  const auto [parsed, status] = std::from_chars(buffer.data(), buffer.data() + length, value);
  if (status == std::errc::result_out_of_range && exponent_is_negative) {
    value = 0.0;
  } else if (status != std::errc() || parsed != buffer.data() + length || !std::isfinite(value)) {
    return std::nullopt;
  }
  rest = text.substr(end);
  return value;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

std::string_view take_cell(std::string_view& rest) {
  const std::size_t comma = rest.find(',');
  const std::string_view cell = rest.substr(0, comma);
  rest = comma == std::string_view::npos ? std::string_view() : rest.substr(comma + 1);
  return trimmed(cell);
}

std::string_view take_word(std::string_view& rest) {
  std::size_t begin = 0;
  while (begin < rest.size() && is_space(rest[begin])) ++begin;
  std::size_t end = begin;
  while (end < rest.size() && !is_space(rest[end])) ++end;
  const std::string_view word = rest.substr(begin, end - begin);
  rest = rest.substr(end);
  return word;
}

bool is_blank(std::string_view rest) {
  for (const char c : rest) {
    if (!is_space(c)) return false;
  }
  return true;
}

TextCursor::TextCursor(std::string_view text, std::string_view file_name)
    : remaining_(text), file_name_(printable_name(file_name)), text_size_(text.size()) {}

bool TextCursor::next_line() {
  line_ = rest_ = {};
  if (remaining_.empty()) return false;
  const std::size_t end = remaining_.find('\n');
  line_ = remaining_.substr(0, end);
  remaining_ = end == std::string_view::npos ? std::string_view() : remaining_.substr(end + 1);
  if (!line_.empty() && line_.back() == '\r') line_.remove_suffix(1);
  rest_ = line_;
  ++line_number_;
  return true;
}

bool TextCursor::next_filled_line() {
  while (next_line()) {
    if (!is_blank(line_)) return true;
  }
  return false;
}

void TextCursor::need_line(std::string_view expected) {
  if (!next_filled_line()) fail(expected, "the end of the file", truncated_hint);
}

double TextCursor::need_number(std::string_view expected) {
  while (is_blank(rest_)) need_line(expected);
  const std::optional<double> number = take_number(rest_);
  if (!number) {
    std::string_view rest = rest_;
    fail(expected, fmt::format("\"{}\"", printable(take_word(rest))), "write a finite number");
  }
  return *number;
}

std::size_t TextCursor::need_count(std::string_view expected) {
  const double count = need_number(expected);
  if (count < 1.0 || count > static_cast<double>(text_size_) / 2.0 || count != std::floor(count)) {
    fail(expected, fmt::format("{:g}", count), "the count does not fit the size of the file");
  }
  return static_cast<std::size_t>(count);
}

std::string TextCursor::place() const {
  return fmt::format("{}:{}", file_name_, line_number_);
}

void TextCursor::fail(std::string_view expected, std::string_view got, std::string_view hint) const {
  throw Error(ErrorKind::bad_input, fmt::format("{}: expected {}, got {}", place(), expected, got),
              std::string(hint));
}

}  // namespace offing::spectra
