#include "host/clouds/ball_layouts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/clouds/random_draws.h"

namespace offing::clouds {
namespace {

constexpr double pi = std::numbers::pi;

/// A heap: a row of wide balls on the base, others piled on its middle. 14 balls.
std::vector<Metaball> cumulus(RandomDraws& draws) {
  std::vector<Metaball> balls;
  for (int i = 0; i < 8; ++i) {
    // Around an ellipse and inside it, larger toward the middle.
    const double angle = 2.0 * pi * (i + draws.between(-0.3, 0.3)) / 8.0, out = draws.between(0.45, 0.95);
    const double radius_m = 230.0 - 90.0 * out + draws.between(-15.0, 15.0);
    balls.push_back(
        {{680.0 * out * std::cos(angle), 0.75 * radius_m, 400.0 * out * std::sin(angle)}, radius_m});
  }
  for (int i = 0; i < 4; ++i) {
    const double angle = 2.0 * pi * (i + draws.between(-0.3, 0.3)) / 4.0;
    const double radius_m = draws.between(170.0, 220.0);
    balls.push_back(
        {{290.0 * std::cos(angle), draws.between(260.0, 350.0), 190.0 * std::sin(angle)}, radius_m});
  }
  balls.push_back(
      {{draws.between(-120.0, 0.0), draws.between(440.0, 500.0), draws.between(-60.0, 60.0)}, 190.0});
  balls.push_back(
      {{draws.between(20.0, 160.0), draws.between(540.0, 600.0), draws.between(-60.0, 60.0)}, 160.0});
  return balls;
}

/// Rows and columns of balls, each moved by up to `jitter` of the spacing.
struct Sheet {
  int across_x, across_z;
  double spacing_m, jitter, lowest_radius_m, highest_radius_m, share;  // share of places that are taken
};

std::vector<Metaball> sheet(const Sheet& plan, RandomDraws& draws) {
  std::vector<Metaball> balls;
  for (int row = 0; row < plan.across_z; ++row) {
    for (int column = 0; column < plan.across_x; ++column) {
      const double x = column - 0.5 * (plan.across_x - 1) + 0.5 * (row % 2) - 0.25;
      const double z = (row - 0.5 * (plan.across_z - 1)) * 0.5 * std::numbers::sqrt3;
      const double radius_m = draws.between(plan.lowest_radius_m, plan.highest_radius_m);
      const double dx = draws.between(-plan.jitter, plan.jitter),
                   dz = draws.between(-plan.jitter, plan.jitter);
      const double dy = draws.between(-0.2, 0.2);
      if (draws.next() > plan.share) continue;
      balls.push_back(
          {{(x + dx) * plan.spacing_m, (1.0 + dy) * radius_m, (z + dz) * plan.spacing_m}, radius_m});
    }
  }
  return balls;
}

/// Streaks: each a line of balls that falls behind the wind, thick at its head and thin at its end.
std::vector<Metaball> cirrus(RandomDraws& draws) {
  std::vector<Metaball> balls;
  for (int streak = 0; streak < 11; ++streak) {
    const double x_m = draws.between(-2600.0, -400.0),
                 z_m = (streak - 5) * 330.0 + draws.between(-120.0, 120.0);
    const double length_m = draws.between(1900.0, 3200.0), bend_m = draws.between(-350.0, 350.0);
    const double head_m = draws.between(85.0, 130.0), top_m = draws.between(330.0, 420.0);
    constexpr int pieces = 34;
    for (int i = 0; i < pieces; ++i) {
      const double along = static_cast<double>(i) / (pieces - 1);
      const double radius_m = head_m * (1.0 - 0.72 * along) * draws.between(0.85, 1.1);
      balls.push_back({{x_m + length_m * along, top_m - 300.0 * along * along,
                        z_m + bend_m * along * along + draws.between(-12.0, 12.0)},
                       radius_m,
                       1.0 - 0.75 * along});
    }
  }
  return balls;
}

/// A tower of heaps below an anvil that spreads with the wind.
std::vector<Metaball> cumulonimbus(RandomDraws& draws) {
  std::vector<Metaball> balls;
  for (int layer = 0; layer < 8; ++layer) {
    const double y_m = 900.0 + 950.0 * layer;
    const int count = layer < 2 ? 7 : 4;
    const double out_m = layer < 2 ? 2300.0 - 500.0 * layer : 1150.0 - 30.0 * layer;
    for (int i = 0; i < count; ++i) {
      const double angle = 2.0 * pi * (i + draws.next()) / count;
      const double radius_m = draws.between(850.0, 1250.0);
      balls.push_back({{out_m * std::cos(angle) + 60.0 * layer, y_m + draws.between(-150.0, 150.0),
                        0.8 * out_m * std::sin(angle)},
                       radius_m});
    }
    balls.push_back({{60.0 * layer, y_m, 0.0}, 1200.0});
  }
  for (int i = 0; i < 44; ++i) {
    const double angle = 2.0 * pi * draws.next(), out = std::sqrt(draws.next());
    const double x_m = 1100.0 + 4700.0 * out * std::cos(angle), z_m = 3100.0 * out * std::sin(angle);
    balls.push_back(
        {{x_m, 9000.0 - 150.0 * out + draws.between(-90.0, 90.0), z_m}, 680.0 - 300.0 * out, 0.7});
  }
  return balls;
}

/// A lens: balls whose height is that of a cap of a sphere, in smooth layers.
std::vector<Metaball> lenticular(RandomDraws& draws) {
  std::vector<Metaball> balls;
  constexpr int rings = 9;
  for (int ring = 0; ring < rings; ++ring) {
    const double out = static_cast<double>(ring) / (rings - 1);
    const int count = std::max(1, 6 * ring);
    const double turn = draws.next();
    for (int i = 0; i < count; ++i) {
      const double angle = 2.0 * pi * (i + turn) / count;
      const double radius_m = 60.0 + 190.0 * (1.0 - out * out);
      balls.push_back(
          {{1250.0 * out * std::cos(angle), 250.0 - 90.0 * out * out, 800.0 * out * std::sin(angle)},
           radius_m,
           0.5});
    }
  }
  return balls;
}

/// A funnel: rings that narrow downward around an axis that leans, under a wide collar.
std::vector<Metaball> funnel(RandomDraws& draws) {
  std::vector<Metaball> balls;
  for (int i = 0; i < 26; ++i) {
    const double angle = 2.0 * pi * draws.next(), out_m = 420.0 * std::sqrt(draws.next());
    const double radius_m = draws.between(90.0, 140.0);
    balls.push_back({{out_m * std::cos(angle), 40.0 + radius_m, out_m * std::sin(angle)}, radius_m});
  }
  // A helix whose turns lie closer than its balls are wide: the vortex shows as ridges.
  constexpr int pieces = 150;
  for (int i = 0; i < pieces; ++i) {
    const double down = static_cast<double>(i) / (pieces - 1), angle = 2.0 * pi * 11.0 * down;
    const double out_m = 150.0 * std::pow(1.0 - down, 1.6) + 14.0;
    const double lean_m = 130.0 * down * down + 25.0 * std::sin(5.0 * down);
    balls.push_back({{lean_m + out_m * std::cos(angle), 90.0 - 640.0 * down, out_m * std::sin(angle)},
                     0.55 * out_m + 16.0,
                     0.9});
  }
  return balls;
}

}  // namespace

std::vector<Metaball> ball_layout(Genus genus, std::uint64_t seed) {
  RandomDraws draws(seed, OFFING_STREAM_CLOUD_LAYOUT, static_cast<int>(genus), 0);
  switch (genus) {
    case Genus::cirrus:
      return cirrus(draws);
    case Genus::stratus:
      return sheet({.across_x = 18,
                    .across_z = 14,
                    .spacing_m = 150.0,
                    .jitter = 0.25,
                    .lowest_radius_m = 130.0,
                    .highest_radius_m = 160.0,
                    .share = 1.0},
                   draws);
    case Genus::cumulus:
      return cumulus(draws);
    case Genus::stratocumulus:
      return sheet({.across_x = 11,
                    .across_z = 9,
                    .spacing_m = 330.0,
                    .jitter = 0.2,
                    .lowest_radius_m = 130.0,
                    .highest_radius_m = 215.0,
                    .share = 0.85},
                   draws);
    case Genus::altocumulus:
      return sheet({.across_x = 20,
                    .across_z = 15,
                    .spacing_m = 180.0,
                    .jitter = 0.16,
                    .lowest_radius_m = 50.0,
                    .highest_radius_m = 90.0,
                    .share = 0.8},
                   draws);
    case Genus::cumulonimbus:
      return cumulonimbus(draws);
    case Genus::lenticular:
      return lenticular(draws);
    case Genus::funnel:
      return funnel(draws);
  }
  return {};
}

}  // namespace offing::clouds
