#include "host/scene/file/nearest_name.h"

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

// Fails if names that a scene has are not listed, or all of thousands are.
TEST(NearestName, HintsListWhatIsKnown) {
  EXPECT_EQ(hint_of_names("shp", {"buoy", "ship"}, "none"), "did you mean ship? known here: buoy, ship");
  EXPECT_EQ(hint_of_names("whale", {"buoy", "ship"}, "none"), "known here: buoy, ship");
  EXPECT_EQ(hint_of_names("ship", {}, "none"), "none");
  EXPECT_LT(hint_of_names("ship", std::vector<std::string>(5000, "buoy"), "none").size(), 200u);
}

}  // namespace
}  // namespace offing::scene
