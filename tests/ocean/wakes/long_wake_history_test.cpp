#include <string>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/ocean/wakes/wake_window.h"

namespace offing::ocean {
namespace {

// Fails if a history that would take a day is begun and not refused with the time that it needs: an hour in
// steps of a millisecond on 2048 x 2048 cells.
TEST(LongWakeHistory, IsRefused) {
  const WakeParameters parameters{.cells = 2048, .length_m = 1000.0, .step_s = 0.001};
  WakeWindow window(ocl::Device::open(), parameters);
  window.reset(0.0, {});
  try {
    window.advance_to(3600.0, [](double) { return WakeForcing{.hulls = {WakeHull{}}}; });
    ADD_FAILURE() << "an hour of steps in less than an hour";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_TRUE(
        std::string(error.what())
            .starts_with("ocean.wake: 3600000 steps of 0.001 s on 2048 x 2048 cells would take about "))
        << error.what();
  }
}

}  // namespace
}  // namespace offing::ocean
