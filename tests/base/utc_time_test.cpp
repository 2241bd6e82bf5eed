#include "host/base/utc_time.h"

#include <gtest/gtest.h>

namespace offing {
namespace {

// Fails if a time is written, read or counted wrongly, or one that does not exist is taken.
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
}  // namespace offing
