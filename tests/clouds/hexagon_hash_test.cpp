// The hash with hexagonal cells (C7): fails if a place within an edge's length is not found.
#include "host/clouds/shape/hexagon_hash.h"

#include <random>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace offing::clouds {
namespace {

TEST(HexagonHashTest, FindsAllWithinAnEdge) {
  constexpr double edge_m = 3.0;
  HexagonHash hash(edge_m);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-20.0, 20.0);
  std::vector<glm::dvec3> places_m;
  for (std::uint32_t i = 0; i < 4000; ++i) {
    places_m.emplace_back(uniform(random), uniform(random), uniform(random));
    hash.insert(places_m.back(), i);
  }
  std::size_t visited = 0, near = 0;
  for (int query = 0; query < 2000; ++query) {
    const glm::dvec3 place_m(uniform(random), uniform(random), uniform(random));
    std::vector<std::uint32_t> found;
    EXPECT_TRUE(hash.all_near(place_m, [&](std::uint32_t number) {
      ++visited;
      if (glm::distance(places_m[number], place_m) < edge_m) found.push_back(number);
      return true;
    }));
    std::size_t expected = 0;
    for (const glm::dvec3& other_m : places_m) expected += glm::distance(other_m, place_m) < edge_m ? 1 : 0;
    near += expected;
    ASSERT_EQ(found.size(), expected);
  }
  EXPECT_GT(near, 5000u);
  // 21 prisms of edge^3 sqrt(27) / 2 hold 13 times the ball's volume.
  EXPECT_LT(visited, 16 * near);
}

TEST(HexagonHashTest, StopsWhereToldTo) {
  HexagonHash hash(1.0);
  hash.insert(glm::dvec3(0.0), 0);
  hash.insert(glm::dvec3(0.1), 1);
  int visits = 0;
  EXPECT_FALSE(hash.all_near(glm::dvec3(0.0), [&](std::uint32_t) { return ++visits > 1; }));
  EXPECT_EQ(visits, 1);
}

}  // namespace
}  // namespace offing::clouds
