// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include "tests/bench/measure.h"

#include <chrono>
#include <thread>

#include <gtest/gtest.h>

namespace offing::bench {
namespace {

std::vector<double> one_to(int count) {
  std::vector<double> values;
  for (int i = count; i > 0; --i) values.push_back(i);
  return values;
}

// Ranks as printed in tables of the sign test's confidence interval (Conover, Practical Nonparametric
// Statistics): two-sided 95 % for n = 6, 9, 15, 25 and 50 begin at the 1st, 2nd, 4th, 8th and 18th value. An
// off-by-one rank would overstate each ratio that is claimed.
TEST(Measure, MedianLowerBoundIsTheTabulatedOrderStatistic) {
  EXPECT_EQ(median_lower_bound(one_to(6)), 1);
  EXPECT_EQ(median_lower_bound(one_to(9)), 2);
  EXPECT_EQ(median_lower_bound(one_to(15)), 4);
  EXPECT_EQ(median_lower_bound(one_to(25)), 8);
  EXPECT_EQ(median_lower_bound(one_to(50)), 18);
}

// Fails if a handful of blocks were to claim a confidence that it cannot give.
TEST(Measure, FewValuesGiveTheLeastAsBound) {
  EXPECT_EQ(median_lower_bound({3.0, 2.0}), 2.0);
  EXPECT_EQ(median_lower_bound(one_to(5)), 1);
}

TEST(Measure, MedianAndSpreadOfKnownValues) {
  EXPECT_DOUBLE_EQ(median({4.0, 1.0, 3.0, 2.0}), 2.5);
  EXPECT_DOUBLE_EQ(relative_spread({1.0, 2.0, 3.0, 4.0, 5.0}), 2.0 / 3.0);
}

// Fails if ratio were ours / peer, or if the two were swapped. Sleeps of 1 and 4 ms overshoot by less than a
// millisecond even on a busy machine's median: the ratio is 4 up to a factor of 2.
TEST(Measure, RatioIsPeerOverOurs) {
  using namespace std::chrono_literals;
  const Comparison comparison =
      compare([] { std::this_thread::sleep_for(1ms); }, [] { std::this_thread::sleep_for(4ms); }, 1);
  EXPECT_GT(comparison.ratio, 2.0);
  EXPECT_LT(comparison.ours_ms, comparison.peer_ms);
}

}  // namespace
}  // namespace offing::bench
