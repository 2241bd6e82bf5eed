#include "host/io/spectra/text_cursor.h"

#include <string>

#include <gtest/gtest.h>

#include "tests/ocl/expect_error.h"

namespace offing::spectra {
namespace {

std::optional<double> number(std::string_view text) {
  return take_number(text);
}

// Each line fails if that way of writing a number is lost.
TEST(TakeNumber, ReadsWhatFortranWrites) {
  EXPECT_EQ(number("  12.5"), 12.5);
  EXPECT_EQ(number("+.5"), 0.5);
  EXPECT_EQ(number("-3."), -3.0);
  EXPECT_EQ(number("0.261E-17"), 0.261e-17);
  EXPECT_EQ(number("1.5D+03"), 1500.0);
  EXPECT_EQ(number("1.5d3"), 1500.0);
  EXPECT_EQ(number("0.123-104"), 0.123e-104);
  EXPECT_EQ(number("0.123+104"), 0.123e104);
  EXPECT_EQ(number(",7"), 7.0);
  EXPECT_EQ(number("1e-400"), 0.0);
  EXPECT_EQ(number("1-999"), 0.0);
}

TEST(TakeNumber, RefusesWhatIsNoFiniteNumber) {
  for (const char* text :
       {"", " ", "nan", "inf", "-inf", "NaN", ".", "-", "+", "e5", "abc", "1e400", "*****"}) {
    EXPECT_EQ(number(text), std::nullopt) << text;
  }
  EXPECT_EQ(number(std::string(1000, '1')), std::nullopt);
}

// Fails if a minus sign between numbers that touch is taken for an exponent.
TEST(TakeNumber, SplitsNumbersThatTouch) {
  std::string_view text = "  40.98-171.12      46.6";
  EXPECT_EQ(take_number(text), 40.98);
  EXPECT_EQ(take_number(text), -171.12);
  EXPECT_EQ(take_number(text), 46.6);
  EXPECT_EQ(take_number(text), std::nullopt);
}

TEST(TextCursor, CountsLinesOfAllEndings) {
  TextCursor cursor("a\r\n\n b\n\tc", "f");
  EXPECT_TRUE(cursor.next_filled_line());
  EXPECT_EQ(cursor.line(), "a");
  EXPECT_TRUE(cursor.next_filled_line());
  EXPECT_EQ(cursor.line_number(), 3U);
  EXPECT_TRUE(cursor.next_filled_line());
  EXPECT_EQ(cursor.line(), "\tc");
  EXPECT_FALSE(cursor.next_filled_line());
}

// Fails if a name or a value can break an error message over two lines, or be taken for a format.
TEST(TextCursor, ErrorsStayOnOneLine) {
  TextCursor cursor("1\nx\x01{}y", "evil\n{0}.spt");
  cursor.next_line();
  cursor.next_line();
  const std::string hint =
      test::expect_error(ErrorKind::bad_input, "evil\\x0a{0}.spt:2: expected a value, got \"x\\x01{}y\"",
                         [&] { cursor.need_number("a value"); });
  EXPECT_FALSE(hint.empty());
}

}  // namespace
}  // namespace offing::spectra
