#include "host/base/parameter_check.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "host/base/error.h"

namespace offing {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Fails if a bound is refused, a number beyond it or NaN is taken, or the error lacks name, range or fix.
TEST(ParameterCheck, HoldsItsRange) {
  for (const double value : {-1.0, 0.0, 2.5}) {
    EXPECT_NO_THROW(require_within("sea.depth_m", value, -1.0, 2.5));
  }
  EXPECT_NO_THROW(require_within("sea.depth_m", infinity, 0.0, infinity));
  for (const double value : {std::nextafter(2.5, 3.0), std::nextafter(-1.0, -2.0), infinity, -infinity,
                             std::numeric_limits<double>::quiet_NaN()}) {
    try {
      require_within("sea.depth_m", value, -1.0, 2.5);
      ADD_FAILURE() << "taken: " << value;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      EXPECT_EQ(std::string(error.what()).rfind("sea.depth_m: expected a number within [-1, 2.5], found ", 0),
                0u);
      EXPECT_EQ(error.hint(), "set sea.depth_m to a value between -1 and 2.5");
    }
  }
}

}  // namespace
}  // namespace offing
