#include "host/scene/prepare/spectrum_tail.h"

#include <cmath>

#include <gtest/gtest.h>

#include "host/ocean/spectrum/spectrum_parameters.h"

namespace offing::scene {
namespace {

WaveSpectrum record_up_to(double last_hz) {
  WaveSpectrum record;
  record.frequencies_hz = {0.1, 0.2, last_hz};
  record.energy = {1.0, 3.0, 0.5};
  return record;
}

// Fails if the tail is not f^-5 from the last energy on, or ends elsewhere than asked.
TEST(SpectrumTail, FallsWithTheFifthPower) {
  const WaveSpectrum record = with_tail(record_up_to(0.4), 3.0);
  ASSERT_GT(record.frequencies_hz.size(), 10u);
  ASSERT_EQ(record.energy.size(), record.frequencies_hz.size());
  EXPECT_NEAR(record.frequencies_hz.back(), 3.0, 1e-12);
  for (std::size_t i = 3; i < record.energy.size(); ++i) {
    EXPECT_NEAR(record.energy[i] / (0.5 * std::pow(record.frequencies_hz[i] / 0.4, -5.0)), 1.0, 1e-12);
  }
}

// Fails if a tail that ends at, below or a hair above the record's end adds frequencies that the sea refuses
// as too close.
TEST(SpectrumTail, LeavesARecordThatReachesAsFar) {
  for (const double highest_hz : {0.3, 0.4, std::nextafter(0.4, 1.0), 0.4 * (1.0 + 1e-8), 0.4004, 0.401}) {
    const WaveSpectrum record = with_tail(record_up_to(0.4), highest_hz);
    EXPECT_EQ(record.frequencies_hz.size(), highest_hz > 0.4004 ? 4u : 3u) << highest_hz;
    EXPECT_NO_THROW(ocean::from_measured(record, {}, {})) << highest_hz;
  }
}

}  // namespace
}  // namespace offing::scene
