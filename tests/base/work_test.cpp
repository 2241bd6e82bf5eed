// Work that others wait for.
#include "host/base/work.h"

#include <vector>

#include <gtest/gtest.h>

#include "host/base/error.h"

namespace offing {
namespace {

// Fails if parts of parts tell shares of themselves and not of the whole, or go on when it is to stop.
TEST(Work, PartsTellSharesOfTheWhole) {
  CancelToken cancel;
  std::vector<double> told;
  const Work whole(cancel, [&](double share) { told.push_back(share); });
  const Work half = whole.part(0.5, 1.0), quarter = half.part(0.0, 0.5);
  quarter.tell(0.0);
  quarter.tell(0.5);
  half.tell(1.0);
  EXPECT_EQ(told, (std::vector<double>{0.5, 0.625, 1.0}));
  cancel.cancel();
  EXPECT_THROW(quarter.poll(), Error);
  EXPECT_THROW(quarter.tell(0.7), Error);
  EXPECT_EQ(told.size(), 3u);
  EXPECT_NO_THROW(Work().part(0.0, 0.5).tell(0.3)) << "nobody waits for it";
}

}  // namespace
}  // namespace offing
