#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <vector>

namespace offing {

/// Reads places of the water plane from comma-separated text, block by block, so that a file may be larger
/// than memory. With a header line the columns `x_m` and `z_m` count and others are left alone; without one
/// there are just these two. Empty lines and lines that begin with # are passed over.
class PointFile {
 public:
  /// Throws Error(bad_input) if there is no such file or it cannot be read.
  explicit PointFile(std::filesystem::path path);

  /// The next places (x, z), m, `most` at most; none at the end. Throws Error(bad_input) with file and line
  /// for what is not two numbers within farthest_point_m, and at the end of a file without any.
  std::vector<std::array<double, 2>> next(std::size_t most);
  /// Whether it can be read again: pipes and terminals cannot. Asked before the first next().
  bool can_rewind();
  /// Back to the first place; only where can_rewind() says so.
  void rewind();

 private:
  bool read_line(std::string_view& line);
  bool read_header(std::string_view line);
  std::array<double, 2> read_place(std::string_view line) const;

  std::filesystem::path path_;
  std::ifstream file_;
  std::vector<char> buffer_;
  std::size_t line_number_ = 0;
  std::size_t places_ = 0;                    // read so far
  std::array<std::size_t, 2> columns_{0, 1};  // of x and z
  bool has_header_ = false;
};

}  // namespace offing
