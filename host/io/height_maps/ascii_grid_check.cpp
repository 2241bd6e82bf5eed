#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <fstream>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/height_maps/raster_file.h"

namespace offing::height_maps {
namespace {

bool is_space(int letter) {
  return std::isspace(letter) != 0;
}

/// As GDAL reads them: "1.5", "1,5", "+2", "nan", "1.#QNAN", and what marks voids.
bool is_height(std::string word, AsciiNumbers numbers) {
  std::ranges::replace(word, ',', '.');
  if (word.starts_with('+')) word.erase(0, 1);
  if (word == "*" || word == "null") return true;
  const char* const begin = word.data();
  const char* const end = begin + word.size();
  if (numbers == AsciiNumbers::integers) {
    std::int32_t value = 0;
    const std::from_chars_result result = std::from_chars(begin, end, value);
    return result.ec == std::errc() && result.ptr == end;
  }
  if (word.find(".#") != std::string::npos) return true;
  double value = 0.0;
  const std::from_chars_result result = std::from_chars(begin, end, value);
  return result.ec != std::errc::invalid_argument && result.ptr == end;
}

/// Words of a file with their lines.
class Words {
 public:
  explicit Words(const std::filesystem::path& path) : file_(path, std::ios::binary) {}

  /// False at the end.
  bool next() {
    word_.clear();
    int letter = get();
    while (letter >= 0 && is_space(letter)) letter = get();
    constexpr std::size_t longest = 128;  // of a number
    for (; letter >= 0 && !is_space(letter); letter = get()) {
      if (word_.size() < longest) word_ += static_cast<char>(letter);
    }
    ends_line_ = letter < 0 || letter == '\n';
    if (word_.empty()) return false;
    line_of_word_ = line_ - (letter == '\n' ? 1 : 0);
    return true;
  }
  void skip_line() {
    for (int letter = ends_line_ ? '\n' : get(); letter >= 0 && letter != '\n';) letter = get();
  }

  const std::string& word() const { return word_; }
  std::size_t line() const { return line_of_word_; }

 private:
  int get() {
    const int letter = file_.rdbuf()->sbumpc();
    if (letter == '\n') ++line_;
    return letter;
  }

  std::ifstream file_;
  std::string word_;
  std::size_t line_ = 1, line_of_word_ = 1;
  bool ends_line_ = false;
};

}  // namespace

void check_ascii_grid(const std::filesystem::path& path, std::size_t heights, AsciiNumbers numbers) {
  Words words(path);
  bool is_there = words.next();
  // The header: "ncols 4", "north: 4928000".
  while (is_there && std::isalpha(static_cast<unsigned char>(words.word().front())) != 0 &&
         !is_height(words.word(), AsciiNumbers::real)) {
    words.skip_line();
    is_there = words.next();
  }
  const auto refuse = [&](const std::string& what) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}:{}: expected {} heights, found {}", one_line(path.string()), words.line(),
                            heights, what),
                "the file is cut short or has been edited: copy it again, or write the nodata value there");
  };
  for (std::size_t i = 0; i < heights; ++i, is_there = words.next()) {
    if (!is_there) refuse(fmt::format("{}", i));
    if (is_height(words.word(), numbers)) continue;
    if (!is_height(words.word(), AsciiNumbers::real))
      refuse(fmt::format("\"{}\" after {} of them", printable(words.word()), i));
    throw Error(ErrorKind::bad_input,
                fmt::format("{}:{}: expected whole heights, as the others are, found \"{}\"",
                            one_line(path.string()), words.line(), printable(words.word())),
                "convert it: gdal_translate -oo DATATYPE=Float64 MAP.asc MAP.tif");
  }
}

}  // namespace offing::height_maps
