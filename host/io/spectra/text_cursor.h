#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace offing::spectra {

/// What to do about a file whose parts do not go together.
inline constexpr const char* damaged_hint = "the file is damaged or cut short; fetch or write it again";

/// A file name fit for one line of an error message: control bytes as `\xNN`, UTF-8 kept.
std::string printable_name(std::string_view name);

/// Takes the first number off `rest`, leading blanks and commas skipped. Reads what Fortran writes: "1.5D-3",
/// "0.123-104" (a three-digit exponent without its letter) and numbers that touch ("40.98-171.12" is two).
/// Values too small for a double are 0. Nothing (and `rest` as it was) if no finite number stands there.
std::optional<double> take_number(std::string_view& rest);

/// `text` without blanks around it.
std::string_view trimmed(std::string_view text);

/// Takes what stands before the next comma off `rest`, trimmed.
std::string_view take_cell(std::string_view& rest);

/// Takes the first word off `rest`, blanks skipped; empty at the end.
std::string_view take_word(std::string_view& rest);

/// True if only blanks remain.
bool is_blank(std::string_view rest);

/// A text file, read line by line; knows where it stands, so that every error can say file and line.
/// Lines end with LF or CRLF. Views into the text stay valid as long as the text does.
class TextCursor {
 public:
  TextCursor(std::string_view text, std::string_view file_name);

  /// Moves to the next line, or to the next one that is not blank; false at the end of the text.
  bool next_line();
  bool next_filled_line();

  /// As next_filled_line(); at the end of the text throws Error: `expected` is missing.
  void need_line(std::string_view expected);

  std::string_view line() const { return line_; }
  std::size_t line_number() const { return line_number_; }
  std::size_t text_size() const { return text_size_; }

  /// "file:line" of the present line.
  std::string place() const;

  /// The next number at or after the present place, over line ends; throws Error if something else stands
  /// there.
  double need_number(std::string_view expected);

  /// The same for how many things follow. Each has at least two bytes, so the size of the file bounds it.
  std::size_t need_count(std::string_view expected);

  /// What is left of the present line for need_number().
  std::string_view& rest() { return rest_; }

  /// Throws Error(bad_input): "file:line: expected ..., got ...".
  [[noreturn]] void fail(std::string_view expected, std::string_view got, std::string_view hint) const;

 private:
  std::string_view remaining_;
  std::string file_name_;
  std::string_view line_;
  std::string_view rest_;
  std::size_t line_number_ = 0;
  std::size_t text_size_;
};

}  // namespace offing::spectra
