#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "host/base/error.h"

namespace offing::meshes {

/// The words of a text file, line by line; knows where it stands, so that every error can say file and line.
/// Lines end with LF or CRLF. What follows a # is a comment. A byte-order mark at the begin of a file is no
/// word.
class TextLines {
 public:
  /// `lines_before` counts the lines of the file before the text.
  TextLines(std::string_view text, std::string_view file_name, std::size_t lines_before = 0);

  /// Moves to the next line that has words; false at the end of the text.
  bool next_line();
  /// As next_line(); at the end of the text throws Error: `expected` is missing.
  void need_line(std::string_view expected);

  /// Takes the next word of the line; empty at its end.
  std::string_view word();
  /// Whether the line has no more words.
  bool is_at_end() const { return rest_.empty(); }

  /// The next word of the line as a finite number, or as a whole one; throws Error if it is none.
  double number(std::string_view expected);
  std::int64_t whole(std::string_view expected);

  std::size_t line_number() const { return line_number_; }
  std::size_t bytes_left() const { return remaining_.size() + rest_.size(); }

  /// Throws Error(bad_input): "file:line: expected ..., got ...".
  [[noreturn]] void fail(std::string_view expected, std::string_view got) const;

 private:
  std::string_view remaining_, rest_;
  std::string file_name_;
  std::size_t line_number_ = 0;
};

/// "file:line: expected ..., got ...", or without the line where it is 0.
Error mesh_error(std::string_view file_name, std::size_t line_number, std::string_view expected,
                 std::string_view got);

}  // namespace offing::meshes
