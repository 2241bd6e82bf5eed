// What a sea has, measured by the C interface, and calls that are watched and stopped.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/c/offing.h"
#include "tests/c/small_sea.h"
#include "tests/c/watcher.h"

namespace offing {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class MeasureCallsTest : public SmallSea {
 protected:
  static OffingSeaStatistics unfilled() {
    OffingSeaStatistics statistics{};
    statistics.size = sizeof statistics;
    statistics.hs_m = -7.0;
    return statistics;
  }
};

// Fails if a figure is of another quantity, or the surface lacks the energy that was asked for. Of five
// standard errors a sound sea exceeds one in 1.7 million runs; seeds are fixed, so that it never does.
TEST_F(MeasureCallsTest, TheSeaHasWhatWasAsked) {
  OffingSeaStatistics found = unfilled();
  ASSERT_EQ(offing_measure_sea(device(), scene(), 4, nullptr, &found), OFFING_OK) << offing_last_error();
  OffingSeaState asked{};
  asked.size = sizeof asked;
  ASSERT_EQ(offing_get_sea_state(scene(), &asked), OFFING_OK);
  EXPECT_EQ(found.asked_hs_m, asked.hs_m);
  EXPECT_EQ(found.asked_tp_s, asked.tp_s);
  EXPECT_EQ(found.asked_tm01_s, asked.tm01_s);
  EXPECT_EQ(found.asked_tm02_s, asked.tm02_s);
  EXPECT_NEAR(found.asked_mean_direction_rad, asked.mean_direction_rad, 1e-12);
  EXPECT_EQ(found.asked_mss, asked.mss);
  EXPECT_EQ(found.asked_peak_period_s, asked.peak_period_s);
  EXPECT_NEAR(found.asked_peak_direction_rad, asked.peak_direction_rad, 1e-12);
  EXPECT_EQ(found.asked_spread_rad, asked.spread_rad);
  EXPECT_NEAR(found.resolved_peak_period_s / asked.peak_period_s, 1.0, 0.05);
  EXPECT_NEAR(found.resolved_spread_rad / asked.spread_rad, 1.0, 0.05);
  EXPECT_GT(found.peak_period_standard_error_s, 0.0);
  EXPECT_LT(std::abs(found.peak_period_s - found.resolved_peak_period_s),
            5.0 * found.peak_period_standard_error_s);
  EXPECT_NEAR(std::remainder(found.peak_direction_rad - asked.peak_direction_rad, 6.283185307), 0.0, 0.5);
  EXPECT_NEAR(found.spread_rad / asked.spread_rad, 1.0, 0.2);
  EXPECT_GT(found.hs_standard_error_m, 0.0);
  EXPECT_LT(found.hs_standard_error_m, 0.05 * asked.hs_m);
  EXPECT_LT(std::abs(found.hs_m - found.asked_hs_m), 5.0 * found.hs_standard_error_m);
  EXPECT_LT(std::abs(found.hs_m - found.resolved_hs_m), 5.0 * found.hs_standard_error_m);
  EXPECT_LT(std::abs(found.tm02_s - found.resolved_tm02_s), 5.0 * found.tm02_standard_error_s);
  EXPECT_GT(found.tm01_s, found.tm02_s);
  EXPECT_GT(found.tp_s, found.tm01_s);
  EXPECT_GT(found.mss, 0.0);
  EXPECT_NEAR(found.skewness, 0.0, 0.3);
  EXPECT_NEAR(found.kurtosis, 3.0, 0.6);
  EXPECT_GT(found.max_ka, 3.0 * std::sqrt(found.mss) * 0.5);
  EXPECT_GE(found.folded_share, 0.0);
  EXPECT_GT(found.asked_foam_fraction, 0.0);
  EXPECT_NEAR(found.foam_fraction, found.asked_foam_fraction, 0.5 * found.asked_foam_fraction);
}

// Fails if shares do not rise from 0 to 1, a seed a step.
TEST_F(MeasureCallsTest, SharesRiseFromZeroToOne) {
  const Watcher watcher;
  OffingSeaStatistics found = unfilled();
  ASSERT_EQ(offing_measure_sea(device(), scene(), 4, watcher.progress(), &found), OFFING_OK)
      << offing_last_error();
  EXPECT_THAT(watcher.shares(), ElementsAre(0.0, 0.25, 0.5, 0.75, 1.0));
}

// Fails if work goes on after the callback asked to stop, or leaves a trace: the rest measures as before.
TEST_F(MeasureCallsTest, StopsAtHalf) {
  const Watcher watcher(0.5);
  OffingSeaStatistics found = unfilled(), expected = unfilled();
  EXPECT_EQ(offing_measure_sea(device(), scene(), 4, watcher.progress(), &found), OFFING_CANCELLED);
  EXPECT_THAT(watcher.shares(), ElementsAre(0.0, 0.25, 0.5));
  EXPECT_THAT(offing_last_error(), HasSubstr("OffingProgress"));
  EXPECT_STRNE(offing_last_hint(), "");
  EXPECT_EQ(found.hs_m, -7.0);
  EXPECT_EQ(offing_measure_sea(device(), scene(), 1, nullptr, &found), OFFING_OK) << offing_last_error();
  EXPECT_EQ(offing_measure_sea(device(), scene(), 1, nullptr, &expected), OFFING_OK);
  EXPECT_EQ(found.hs_m, expected.hs_m);
  EXPECT_EQ(offing_frame(world(), 3.0), OFFING_OK);
}

// Fails if bad arguments are found out after the work, or a callback that is missing is called.
TEST_F(MeasureCallsTest, RefusesBadArguments) {
  const Watcher watcher;
  OffingSeaStatistics found = unfilled();
  for (const int seeds : {0, -1, 100'001}) {
    EXPECT_EQ(offing_measure_sea(device(), scene(), seeds, watcher.progress(), &found), OFFING_BAD_INPUT);
    EXPECT_THAT(offing_last_error(), HasSubstr("seeds"));
  }
  EXPECT_EQ(offing_measure_sea(device(), scene(), 1, watcher.progress(), nullptr), OFFING_BAD_INPUT);
  EXPECT_EQ(offing_measure_sea(nullptr, scene(), 1, watcher.progress(), &found), OFFING_BAD_INPUT);
  found.size = 0;
  EXPECT_EQ(offing_measure_sea(device(), scene(), 1, watcher.progress(), &found), OFFING_BAD_INPUT);
  EXPECT_THAT(watcher.shares(), testing::IsEmpty());
  found.size = sizeof found;
  OffingProgress nobody{};
  EXPECT_EQ(offing_measure_sea(device(), scene(), 1, &nobody, &found), OFFING_BAD_INPUT);
  nobody.size = sizeof nobody;
  EXPECT_EQ(offing_measure_sea(device(), scene(), 1, &nobody, &found), OFFING_OK) << offing_last_error();
}

}  // namespace
}  // namespace offing
