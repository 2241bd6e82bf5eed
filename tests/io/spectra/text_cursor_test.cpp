#include "host/io/spectra/text_cursor.h"

#include <string>

#include <gtest/gtest.h>

#include "host/io/spectra/utc_time.h"
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

TEST(UtcTime, WritesAndReadsIsoTimes) {
  EXPECT_EQ(iso_time({2020, 6, 8, 3, 50, 0}), "2020-06-08T03:50Z");
  EXPECT_EQ(iso_time({2020, 6, 8, 3, 50, 7}), "2020-06-08T03:50:07Z");
  EXPECT_EQ(iso_time({2019, 12, 31, 24, 0, 0}), "2020-01-01T00:00Z");
  EXPECT_EQ(iso_time({2020, 2, 30, 0, 0, 0}), std::nullopt);
  EXPECT_EQ(iso_time({2021, 2, 29, 0, 0, 0}), std::nullopt);
  EXPECT_EQ(iso_time({2021, 2, 28, 25, 0, 0}), std::nullopt);
  EXPECT_EQ(parse_iso_time("2020-06-08T03:50:07Z"), (UtcTime{2020, 6, 8, 3, 50, 7}));
  EXPECT_EQ(parse_iso_time("2020-06-08T03:50Z"), (UtcTime{2020, 6, 8, 3, 50, 0}));
  EXPECT_EQ(parse_iso_time("2020-06-08 03:50Z"), std::nullopt);
  EXPECT_EQ(parse_iso_time(""), std::nullopt);
  // The Unix epoch and 2^31 s after it, which `date -u -d @2147483648` gives.
  EXPECT_EQ(from_unix_seconds(0), (UtcTime{1970, 1, 1, 0, 0, 0}));
  EXPECT_EQ(from_unix_seconds(2147483648), (UtcTime{2038, 1, 19, 3, 14, 8}));
}

}  // namespace
}  // namespace offing::spectra
