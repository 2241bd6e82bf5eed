#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/parameter_check.h"

namespace offing {

/// What a table has, and how its errors explain it.
struct NumberColumns {
  std::vector<std::string> names;          ///< with units, such as x_m
  std::string meaning;                     ///< of a line: "for each point, its x and z in m"
  std::string example;                     ///< a line
  std::vector<std::string> optional = {};  ///< that a header line may name; NaN where there are none
  double farthest = farthest_point_m;      ///< from 0 that a number may be
};

/// Reads columns of numbers from comma-separated text, block by block, so that a file may be larger than
/// memory. With a header line the named columns count, in any order, and others are left alone; without one
/// there are just these. Empty lines and lines that begin with # are passed over.
class NumberTable {
 public:
  /// Throws Error(bad_input) if there is no such file or it cannot be read.
  NumberTable(std::filesystem::path path, NumberColumns columns);

  /// The next rows [rows][columns, and then the optional ones], `most` at most; none at the end. Throws
  /// Error(bad_input) with file and line for what is not numbers within farthest_point_m, and at the end of a
  /// file without any.
  std::vector<double> next(std::size_t most);
  /// "points.csv:7": where a row of the last block stands.
  std::string place_of(std::size_t row) const;
  /// Whether it can be read again: pipes and terminals cannot. Asked before the first next().
  bool can_rewind();
  /// Back to the first row; only where can_rewind() says so.
  void rewind();

 private:
  bool read_line(std::string_view& line);
  bool read_header(std::string_view line);
  void read_row(std::string_view line, std::vector<double>& numbers) const;
  std::string hint() const;

  std::filesystem::path path_;
  NumberColumns columns_;
  std::ifstream file_;
  std::vector<char> buffer_;
  std::size_t line_number_ = 0;
  std::size_t rows_ = 0;                      // read so far
  std::vector<std::size_t> lines_;            // of the last block
  std::vector<std::size_t> fields_;           // of the columns
  std::vector<std::size_t> optional_fields_;  // of each optional one, or none
  bool has_header_ = false;
};

}  // namespace offing
