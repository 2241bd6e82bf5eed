#include "host/io/number_table.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/base/error.h"
#include "host/io/file_mark.h"

namespace offing {
namespace {

constexpr std::size_t longest_line = 4095;
constexpr std::size_t shown_characters = 60;
constexpr std::size_t no_field = std::numeric_limits<std::size_t>::max();

std::string_view trimmed(std::string_view text) {
  constexpr const char* blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  while (true) {
    const std::size_t comma = line.find(',');
    fields.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

bool read_number(std::string_view text, double farthest, double& value) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() && std::abs(value) <= farthest;
}

/// As words go in sentences.
std::string count_text(std::size_t count) {
  constexpr std::array<std::string_view, 7> words = {"no", "one", "two", "three", "four", "five", "six"};
  return count < words.size() ? std::string(words[count]) : fmt::format("{}", count);
}

/// 0, 1, 2 ...
std::vector<std::size_t> in_order(std::size_t count) {
  std::vector<std::size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  return numbers;
}

}  // namespace

NumberTable::NumberTable(std::filesystem::path path, NumberColumns columns)
    : path_(std::move(path)),
      columns_(std::move(columns)),
      buffer_(longest_line + 1),
      fields_(in_order(columns_.names.size())) {
  errno = 0;
  file_.open(path_, std::ios::binary);
  std::error_code ignored;
  if (!file_ || std::filesystem::is_directory(path_, ignored)) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: cannot be read: {}", path_.string(),
                            file_ ? "it is a folder" : std::strerror(errno)),
                fmt::format("give a file with lines {}", fmt::join(columns_.names, ",")));
  }
}

bool NumberTable::read_line(std::string_view& line) {
  while (file_.getline(buffer_.data(), static_cast<std::streamsize>(buffer_.size()))) {
    ++line_number_;
    // What was taken, less the end of the line where there is one.
    const auto length = static_cast<std::size_t>(file_.gcount()) - (file_.eof() ? 0 : 1);
    line = trimmed({buffer_.data(), length});
    if (line.find('\0') != std::string_view::npos) {
      throw Error(ErrorKind::bad_input,
                  fmt::format("{}:{}: expected text, found a byte of value 0", path_.string(), line_number_),
                  "save it as plain text in UTF-8 or ASCII");
    }
    if (line_number_ == 1) line = without_byte_order_mark(line);
    if (!line.empty() && line.front() != '#') return true;
  }
  if (file_.bad()) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: cannot be read beyond line {}", path_.string(), line_number_),
                "check the disk or the program that writes it");
  }
  if (file_.eof()) return false;
  throw Error(ErrorKind::bad_input,
              fmt::format("{}:{}: expected a line of at most {} characters, found a longer one",
                          path_.string(), line_number_ + 1, longest_line),
              hint());
}

std::string NumberTable::hint() const {
  return fmt::format("write a line {}, such as {}; a first line {} may name them", columns_.meaning,
                     columns_.example, fmt::join(columns_.names, ","));
}

/// Whether the first line names columns; takes note of them.
bool NumberTable::read_header(std::string_view line) {
  const std::vector<std::string_view> fields = fields_of(line);
  std::vector<std::size_t> found;
  for (const std::string& name : columns_.names) {
    const auto field = std::find(fields.begin(), fields.end(), name);
    if (field == fields.end()) return false;
    found.push_back(static_cast<std::size_t>(field - fields.begin()));
  }
  fields_ = found;
  optional_fields_.clear();
  for (const std::string& name : columns_.optional) {
    const auto field = std::find(fields.begin(), fields.end(), name);
    optional_fields_.push_back(field == fields.end() ? no_field
                                                     : static_cast<std::size_t>(field - fields.begin()));
  }
  has_header_ = true;
  return true;
}

void NumberTable::read_row(std::string_view line, std::vector<double>& numbers) const {
  const std::vector<std::string_view> fields = fields_of(line);
  const std::size_t last = *std::max_element(fields_.begin(), fields_.end());
  bool is_row = has_header_ ? fields.size() > last : fields.size() == fields_.size();
  for (std::size_t i = 0; is_row && i < fields_.size(); ++i) {
    numbers.push_back(0.0);
    is_row = read_number(fields[fields_[i]], columns_.farthest, numbers.back());
  }
  for (std::size_t i = 0; is_row && i < columns_.optional.size(); ++i) {
    numbers.push_back(std::numeric_limits<double>::quiet_NaN());
    const std::size_t field = has_header_ ? optional_fields_[i] : no_field;
    if (field >= fields.size() || fields[field].empty()) continue;
    if (read_number(fields[field], columns_.farthest, numbers.back())) continue;
    throw Error(ErrorKind::bad_input,
                fmt::format("{}:{}: {}: expected a number within [{:g}, {:g}], found \"{}\"", path_.string(),
                            line_number_, columns_.optional[i], -columns_.farthest, columns_.farthest,
                            fields[field].substr(0, shown_characters)),
                "write a number, or leave the field empty for the value of the flag");
  }
  if (is_row) return;
  throw Error(
      ErrorKind::bad_input,
      fmt::format("{}:{}: expected {} as {} numbers within [{:g}, {:g}], found \"{}\"", path_.string(),
                  line_number_, fmt::join(columns_.names, ","), count_text(fields_.size()),
                  -columns_.farthest, columns_.farthest, line.substr(0, shown_characters)),
      hint());
}

std::vector<double> NumberTable::next(std::size_t most) {
  std::vector<double> numbers;
  lines_.clear();
  std::string_view line;
  while (lines_.size() < most && read_line(line)) {
    if (rows_ == 0 && !has_header_ && read_header(line)) continue;
    read_row(line, numbers);
    lines_.push_back(line_number_);
    ++rows_;
  }
  if (rows_ == 0) {
    throw Error(ErrorKind::bad_input, fmt::format("{}: expected points, found none", path_.string()), hint());
  }
  return numbers;
}

std::string NumberTable::place_of(std::size_t row) const {
  return fmt::format("{}:{}", path_.string(), lines_[row]);
}

bool NumberTable::can_rewind() {
  return file_.tellg() != std::ifstream::pos_type(-1);
}

void NumberTable::rewind() {
  file_.clear();
  file_.seekg(0);
  line_number_ = 0;
  rows_ = 0;
  has_header_ = false;
  optional_fields_.clear();
  fields_ = in_order(columns_.names.size());
}

}  // namespace offing
