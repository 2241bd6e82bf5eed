// What several observers see together, and the angles at which they look, on cases that this file counts
// itself.
#include "host/terrain/analysis/sight_counts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/terrain/analysis/sight_limits.h"

namespace offing::terrain {
namespace {

constexpr double degree_rad = std::numbers::pi / 180.0;

/// Random viewsheds of 130 posts, which fill two words of bits and a part of a third.
std::vector<std::vector<std::uint8_t>> random_viewsheds(std::size_t observers, unsigned seed, double share,
                                                        std::size_t posts = 130) {
  std::mt19937 random(seed);
  std::bernoulli_distribution sees(share), is_outside(0.1);
  std::vector<std::vector<std::uint8_t>> viewsheds(observers, std::vector<std::uint8_t>(posts));
  for (std::vector<std::uint8_t>& viewshed : viewsheds) {
    for (std::uint8_t& post : viewshed) {
      post = 0;
      if (is_outside(random)) {
        post = sight_outside;
      } else if (sees(random)) {
        post = 255;
      }
    }
  }
  return viewsheds;
}

SightCounts counts_of(const std::vector<std::vector<std::uint8_t>>& viewsheds) {
  SightCounts counts(viewsheds.front().size(), true);
  for (const auto& viewshed : viewsheds) counts.add(viewshed);
  return counts;
}

/// Posts that any of the observers sees.
std::size_t seen_by(const std::vector<std::vector<std::uint8_t>>& viewsheds,
                    const std::vector<std::size_t>& observers) {
  std::size_t seen = 0;
  for (std::size_t post = 0; post < viewsheds.front().size(); ++post) {
    const bool is_seen =
        std::ranges::any_of(observers, [&](std::size_t i) { return viewsheds[i][post] == 255; });
    seen += is_seen ? 1 : 0;
  }
  return seen;
}

// Fails if a count, the union, a share or the posts of one observer alone are not those of a plain loop.
TEST(SightCounts, AreSumsOfViewsheds) {
  const auto viewsheds = random_viewsheds(9, 3, 0.3);
  const SightCounts counts = counts_of(viewsheds);
  const std::vector<std::size_t> only_posts = counts.only_posts();
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < viewsheds.size(); ++i) all.push_back(i);
  for (std::size_t i = 0; i < viewsheds.size(); ++i) {
    EXPECT_EQ(counts.seen_posts()[i], seen_by(viewsheds, {i}));
    std::vector<std::size_t> others = all;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_EQ(only_posts[i], seen_by(viewsheds, all) - seen_by(viewsheds, others));
    EXPECT_EQ(counts.reached_posts()[i],
              130 - static_cast<std::size_t>(std::ranges::count(viewsheds[i], sight_outside)));
  }
  EXPECT_EQ(counts.union_posts(), seen_by(viewsheds, all));
  for (std::size_t post = 0; post < 130; ++post) {
    std::size_t seen = 0, outside = 0;
    for (const auto& viewshed : viewsheds) {
      seen += viewshed[post] == 255 ? 1 : 0;
      outside += viewshed[post] == sight_outside ? 1 : 0;
    }
    EXPECT_EQ(counts.counts()[post], seen);
    EXPECT_EQ(counts.is_reached(post), outside < viewsheds.size());
  }
}

// Posts are added up 255 at a time and their bits 8 at a time: fails if any is counted twice or left out.
TEST(SightCounts, HoldForAnyNumberOfPosts) {
  for (const std::size_t posts : {1, 7, 8, 63, 65, 254, 255, 256, 511, 771}) {
    for (const double share : {0.3, 1.0}) {
      const auto viewsheds = random_viewsheds(3, 5, share, posts);
      const SightCounts counts = counts_of(viewsheds);
      EXPECT_EQ(counts.union_posts(), seen_by(viewsheds, {0, 1, 2}));
      for (std::size_t i = 0; i < viewsheds.size(); ++i) {
        EXPECT_EQ(counts.seen_posts()[i], seen_by(viewsheds, {i})) << posts;
        EXPECT_EQ(counts.reached_posts()[i],
                  posts - static_cast<std::size_t>(std::ranges::count(viewsheds[i], sight_outside)))
            << posts;
        for (std::size_t post = 0; post < posts; ++post)
          EXPECT_EQ(counts.each()[i][post / 64] >> post % 64 & 1, viewsheds[i][post] == 255 ? 1u : 0u);
      }
    }
  }
}

// Fails if the best k of up to 10 are not those of all subsets, or their order and sums are wrong.
TEST(SightCounts, BestObserversAreThoseOfAllChoices) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const auto viewsheds = random_viewsheds(10, seed, 0.15);
    const SightCounts counts = counts_of(viewsheds);
    for (std::size_t count = 1; count <= 4; ++count) {
      std::size_t most = 0;
      for (unsigned subset = 0; subset < 1024; ++subset) {
        std::vector<std::size_t> chosen;
        for (std::size_t i = 0; i < 10; ++i) {
          if ((subset >> i & 1) != 0) chosen.push_back(i);
        }
        if (chosen.size() == count) most = std::max(most, seen_by(viewsheds, chosen));
      }
      const BestObservers best = best_observers(counts.each(), count, CancelToken());
      EXPECT_TRUE(best.is_exhaustive);
      ASSERT_EQ(best.observers.size(), count);
      EXPECT_EQ(best.seen_posts.back(), most) << seed << ' ' << count;
      for (std::size_t i = 0; i < count; ++i) {
        const std::vector<std::size_t> first(best.observers.begin(),
                                             best.observers.begin() + static_cast<std::ptrdiff_t>(i + 1));
        EXPECT_EQ(best.seen_posts[i], seen_by(viewsheds, first));
      }
    }
  }
}

// Of 60 there are 34,220 choices of three. Fails if one of them does not add the most to those before it.
TEST(SightCounts, OfManyObserversEachAddsTheMost) {
  const auto viewsheds = random_viewsheds(60, 11, 0.1);
  const BestObservers best = best_observers(counts_of(viewsheds).each(), 3, CancelToken());
  EXPECT_FALSE(best.is_exhaustive);
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < 3; ++i) {
    std::size_t most = 0;
    for (std::size_t next = 0; next < 60; ++next) {
      std::vector<std::size_t> with = chosen;
      with.push_back(next);
      most = std::max(most, seen_by(viewsheds, with));
    }
    chosen.push_back(best.observers[i]);
    EXPECT_EQ(best.seen_posts[i], most);
    EXPECT_EQ(seen_by(viewsheds, chosen), most);
  }
  EXPECT_EQ(best_observers(counts_of(viewsheds).each(), 100, CancelToken()).observers.size(), 60u);
}

// Fails if all observers, or all but one, of very many are searched: that takes a call for each of them.
TEST(SightCounts, AllOfVeryManyObserversAreOneChoice) {
  constexpr std::size_t count = 40'000;
  std::vector<std::vector<std::uint64_t>> each(count, std::vector<std::uint64_t>(64));
  for (std::size_t i = 0; i < count; ++i) each[i][i % 64] = i;
  const BestObservers all = best_observers(each, count + 5, CancelToken());
  EXPECT_TRUE(all.is_exhaustive);
  EXPECT_EQ(std::set<std::size_t>(all.observers.begin(), all.observers.end()).size(), count);
  EXPECT_TRUE(std::ranges::is_sorted(all.seen_posts));
  const BestObservers most = best_observers(std::span(each).first(5000), 4999, CancelToken());
  EXPECT_FALSE(most.is_exhaustive);
  EXPECT_EQ(most.observers.size(), 4999u);
  CancelToken cancelled;
  cancelled.cancel();
  EXPECT_THROW(best_observers(each, 3, cancelled), Error);
}

// Fails if a hundred gigabytes are asked for before anything is said.
TEST(SightCounts, OfTooManyPostsAreRefused) {
  EXPECT_NO_THROW(require_room(1025 * 1025, 65'000));
  EXPECT_THROW(require_room(std::size_t{3601} * 3601, 65'000), Error);
}

/// Marks posts outside on flat ground with a hill, by angles in plain trigonometry.
TEST(SightLimits, AreAnglesFromTheEye) {
  const PostGrid grid{.columns = 41, .rows = 31, .spacing_x_m = 10.0, .spacing_z_m = 15.0};
  std::vector<float> heights_m(41 * 31);
  for (int row = 0; row < 31; ++row) {
    for (int column = 0; column < 41; ++column)
      heights_m[static_cast<std::size_t>(row * 41 + column)] =
          static_cast<float>(column > 30 ? 40 : column % 3);
  }
  const ViewshedParameters parameters{.observer_x_m = 200.0,
                                      .observer_z_m = 225.0,
                                      .observer_height_m = 5.0,
                                      .target_height_m = 2.0,
                                      .radius_m = 181.3,
                                      .curve = {earth_radius_m, 0.13}};
  const double eye_m = 20 % 3 + 5.0;
  for (const auto& [from_deg, to_deg] : std::vector<std::pair<double, double>>{{0, 360},
                                                                               {-180, 180},
                                                                               {10, 80},
                                                                               {80, 10},
                                                                               {350, 10},
                                                                               {-10, 10},
                                                                               {100, 280.5},
                                                                               {100, 280},
                                                                               {75, 255},
                                                                               {30, 210},
                                                                               {100, 279.5},
                                                                               {300, -90},
                                                                               {200, 200.4}}) {
    for (const auto& [lowest_deg, highest_deg] :
         std::vector<std::pair<double, double>>{{-90, 90}, {-3, 90}, {-90, 1}, {-2, 12}}) {
      const SightLimits limits{from_deg * degree_rad, to_deg * degree_rad, lowest_deg * degree_rad,
                               highest_deg * degree_rad};
      std::vector<std::uint8_t> seen(heights_m.size(), 0);
      mark_outside(grid, heights_m, parameters, limits, sight_outside, seen);
      for (int row = 0; row < 31; ++row) {
        for (int column = 0; column < 41; ++column) {
          const double east_m = 10.0 * column - 200.0, south_m = 15.0 * row - 225.0;
          const double plan_m = std::hypot(east_m, south_m);
          const std::size_t post = static_cast<std::size_t>(row * 41 + column);
          const double azimuth_deg = std::atan2(east_m, -south_m) / degree_rad;
          const double turned_deg = std::fmod(azimuth_deg - from_deg + 720.0, 360.0);
          const double width_deg = std::fmod(to_deg - from_deg + 720.0, 360.0);
          const double rise_m = static_cast<double>(heights_m[post]) + 2.0 - eye_m -
                                parameters.curve.bend_perm() * plan_m * plan_m;
          const double up_deg = std::atan2(rise_m, plan_m) / degree_rad;
          const bool is_own = plan_m == 0.0;
          // On an edge rounding decides.
          if (std::abs(turned_deg - width_deg) < 1e-9 || turned_deg < 1e-9 || turned_deg > 360.0 - 1e-9)
            continue;
          const bool is_within = plan_m <= 181.3 &&
                                 (is_own || to_deg - from_deg == 360.0 || turned_deg <= width_deg) &&
                                 up_deg >= lowest_deg && up_deg <= highest_deg;
          EXPECT_EQ(seen[post], is_within ? 0 : sight_outside)
              << column << ' ' << row << ", " << from_deg << " to " << to_deg << ", " << lowest_deg << " to "
              << highest_deg;
        }
      }
    }
  }
}

// Of a radius alone only some columns of a row are looked at: fails if any post is on the wrong side of it.
TEST(SightLimits, RadiiAreThoseOfEveryPost) {
  const PostGrid grid{.columns = 57, .rows = 43, .spacing_x_m = 10.0, .spacing_z_m = 15.0};
  const std::vector<float> heights_m(57 * 43, 0.0f);
  for (const auto& [x_m, z_m] :
       std::vector<std::pair<double, double>>{{0, 0}, {560, 630}, {273.1, 300}, {280, 311.7}, {560, 12}}) {
    for (const double radius_m : {0.5, 10.0, 15.0, 44.9, 150.0, 298.7, 555.0, 2000.0}) {
      std::vector<std::uint8_t> seen(heights_m.size(), 0);
      mark_outside(grid, heights_m, {.observer_x_m = x_m, .observer_z_m = z_m, .radius_m = radius_m}, {},
                   sight_outside, seen);
      for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
          const double east_m = 10.0 * column - x_m, south_m = 15.0 * row - z_m;
          const bool is_far = east_m * east_m + south_m * south_m > radius_m * radius_m;
          EXPECT_EQ(seen[static_cast<std::size_t>(row * 57 + column)], is_far ? sight_outside : 0)
              << column << ' ' << row << ' ' << x_m << ' ' << radius_m;
        }
      }
    }
  }
}

// Fails if angles that cannot be are taken.
TEST(SightLimits, RefuseWhatIsNoSector) {
  EXPECT_THROW(require_valid(SightLimits{.azimuth_from_rad = 7.0}), Error);
  EXPECT_THROW(require_valid(SightLimits{.azimuth_to_rad = std::nan("")}), Error);
  EXPECT_THROW(require_valid(SightLimits{.lowest_rad = 0.2, .highest_rad = 0.1}), Error);
  EXPECT_THROW(require_valid(SightLimits{.lowest_rad = -2.0}), Error);
}

}  // namespace
}  // namespace offing::terrain
