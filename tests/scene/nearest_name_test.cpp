#include "host/scene/nearest_name.h"

#include <array>
#include <string>

#include <gtest/gtest.h>

namespace offing::scene {
namespace {

constexpr std::array<std::string_view, 4> names = {"wind_speed_mps", "fetch_m", "gamma", "size"};

// Fails if a slip of the finger gets no suggestion, or the wrong one.
TEST(NearestName, FindsWhatWasMeant) {
  EXPECT_EQ(nearest_name("wind_sped_mps", names), "wind_speed_mps");
  EXPECT_EQ(nearest_name("fetch", names), "fetch_m");
  EXPECT_EQ(nearest_name("fecth_m", names), "fetch_m");
  EXPECT_EQ(nearest_name("gama", names), "gamma");
}

// Fails if unrelated or hostile names get a misleading suggestion.
TEST(NearestName, LeavesStrangersAlone) {
  EXPECT_EQ(nearest_name("zzzzzzzzzz", names), "");
  EXPECT_EQ(nearest_name("", names), "");
  EXPECT_EQ(nearest_name(std::string(1000000, 'a'), names), "");
}

}  // namespace
}  // namespace offing::scene
