#include "host/io/point_file.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/world_limits.h"

namespace offing {
namespace {

constexpr std::size_t longest_line = 4095;
constexpr std::size_t shown_characters = 60;
constexpr const char* mend =
    "write a line for each point, its x and z in m, such as 12.5,-40; a first line x_m,z_m may name them";

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

bool read_number(std::string_view text, double& value) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() && std::abs(value) <= farthest_point_m;
}

}  // namespace

PointFile::PointFile(std::filesystem::path path) : path_(std::move(path)), buffer_(longest_line + 1) {
  errno = 0;
  file_.open(path_, std::ios::binary);
  std::error_code ignored;
  if (!file_ || std::filesystem::is_directory(path_, ignored)) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: cannot be read: {}", path_.string(),
                            file_ ? "it is a folder" : std::strerror(errno)),
                "give a file of points with lines x_m,z_m");
  }
}

bool PointFile::read_line(std::string_view& line) {
  while (file_.getline(buffer_.data(), static_cast<std::streamsize>(buffer_.size()))) {
    ++line_number_;
    // What was taken, less the end of the line where there is one.
    const auto length = static_cast<std::size_t>(file_.gcount()) - (file_.eof() ? 0 : 1);
    line = trimmed({buffer_.data(), length});
    if (line.find('\0') != std::string_view::npos) {
      throw Error(ErrorKind::bad_input,
                  fmt::format("{}:{}: expected text, found a byte of value 0", path_.string(), line_number_),
                  "save the points as plain text in UTF-8 or ASCII");
    }
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    if (line_number_ == 1 && line.starts_with(byte_order_mark)) line.remove_prefix(byte_order_mark.size());
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
              mend);
}

/// Whether the first line names columns; takes note of them.
bool PointFile::read_header(std::string_view line) {
  const std::vector<std::string_view> fields = fields_of(line);
  const auto find = [&](std::string_view name) {
    std::size_t column = 0;
    while (column < fields.size() && fields[column] != name) ++column;
    return column;
  };
  const std::array<std::size_t, 2> found{find("x_m"), find("z_m")};
  if (found[0] == fields.size() || found[1] == fields.size()) return false;
  columns_ = found;
  has_header_ = true;
  return true;
}

std::array<double, 2> PointFile::read_place(std::string_view line) const {
  const std::vector<std::string_view> fields = fields_of(line);
  std::array<double, 2> place{};
  const bool has_columns =
      has_header_ ? fields.size() > std::max(columns_[0], columns_[1]) : fields.size() == 2;
  if (!has_columns || !read_number(fields[columns_[0]], place[0]) ||
      !read_number(fields[columns_[1]], place[1])) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}:{}: expected x_m,z_m as two numbers within [{:g}, {:g}], found \"{}\"",
                            path_.string(), line_number_, -farthest_point_m, farthest_point_m,
                            line.substr(0, shown_characters)),
                mend);
  }
  return place;
}

std::vector<std::array<double, 2>> PointFile::next(std::size_t most) {
  std::vector<std::array<double, 2>> places;
  std::string_view line;
  while (places.size() < most && read_line(line)) {
    if (places_ == 0 && !has_header_ && read_header(line)) continue;
    places.push_back(read_place(line));
    ++places_;
  }
  if (places_ == 0) {
    throw Error(ErrorKind::bad_input, fmt::format("{}: expected points, found none", path_.string()), mend);
  }
  return places;
}

bool PointFile::can_rewind() {
  return file_.tellg() != std::ifstream::pos_type(-1);
}

void PointFile::rewind() {
  file_.clear();
  file_.seekg(0);
  line_number_ = 0;
  places_ = 0;
  has_header_ = false;
  columns_ = {0, 1};
}

}  // namespace offing
