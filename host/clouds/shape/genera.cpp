#include "host/clouds/shape/genera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/base/error.h"
#include "host/clouds/particles/random_draws.h"

namespace offing::clouds {
namespace {

using std::numbers::pi;

/// A heap of 14 balls on a flat base: a dome with shoulders, a lower one to the side, a foot around both.
std::vector<Metaball> cumulus(RandomDraws& draws) {
  std::vector<Metaball> balls;
  const double side = draws.next() < 0.5 ? -1.0 : 1.0;
  const auto put = [&](double x_m, double y_m, double z_m, double radius_m) {
    const double jitter_m = 0.18 * radius_m;
    balls.push_back(
        {{side * x_m + draws.between(-jitter_m, jitter_m), y_m, z_m + draws.between(-jitter_m, jitter_m)},
         radius_m * draws.between(0.92, 1.08)});
  };
  constexpr int feet = 6;
  for (int i = 0; i < feet; ++i) {
    const double angle = 2.0 * pi * (i + draws.between(-0.25, 0.25)) / feet, out = draws.between(0.8, 1.1);
    put(560.0 * out * std::cos(angle), 120.0, 330.0 * out * std::sin(angle), 190.0);
  }
  put(-150.0, 330.0, 0.0, 270.0);
  put(-420.0, 230.0, 60.0, 170.0);
  put(30.0, 210.0, 250.0, 165.0);
  put(60.0, 210.0, -240.0, 165.0);
  put(-210.0, 540.0, 20.0, 190.0);
  put(-60.0, 600.0, -20.0, 150.0);
  put(440.0, 260.0, -20.0, 190.0);
  put(480.0, 420.0, 20.0, 140.0);
  return balls;
}

/// A number in (0, 1) that changes slowly over the plane, evenly spread: a sum of waves in all directions.
class Swell {
 public:
  Swell(double wavelength_m, RandomDraws& draws) {
    for (Wave& wave : waves_) {
      const double angle = 2.0 * pi * draws.next(), length_m = wavelength_m * draws.between(0.7, 1.5);
      wave = {2.0 * pi * std::cos(angle) / length_m, 2.0 * pi * std::sin(angle) / length_m,
              2.0 * pi * draws.next()};
    }
  }

  double at(double x_m, double z_m) const {
    double sum = 0.0;
    for (const Wave& wave : waves_) sum += std::cos(wave.x_per_m * x_m + wave.z_per_m * z_m + wave.phase);
    // Of variance 1; the logistic function makes it even (Camilli 1994).
    return 1.0 / (1.0 + std::exp(-1.702 * sum * std::sqrt(2.0 / wave_count)));
  }

 private:
  static constexpr int wave_count = 6;
  struct Wave {
    double x_per_m, z_per_m, phase;
  };
  std::array<Wave, wave_count> waves_{};
};

/// Billows across x: rows that bend together, of balls at uneven steps, smaller toward holes and the rim.
struct Sheet {
  double half_x_m, half_z_m;  // of an ellipse
  double row_m, step_m;       // between rows and, in the mean, along them
  double middle_m;            // height of the middles
  double radius_m, spread;    // radii are 1 - spread ... 1 + spread of it
  double swell_m, holes;      // wavelength of the cover, share of holes
};

std::vector<Metaball> sheet(const Sheet& plan, RandomDraws& draws) {
  const Swell cover(plan.swell_m, draws), bend(2.0 * plan.swell_m, draws);
  std::vector<Metaball> balls;
  const int rows = static_cast<int>(plan.half_x_m / plan.row_m);
  for (int row = -rows; row <= rows; ++row) {
    double along_m = -plan.half_z_m + plan.step_m * draws.next();
    for (; along_m < plan.half_z_m; along_m += plan.step_m * draws.between(0.4, 1.6)) {
      const double x_m = row * plan.row_m + plan.row_m * draws.between(-0.3, 0.3) +
                         3.0 * plan.row_m * (bend.at(0.0, along_m) - 0.5);
      const double out = std::hypot(x_m / plan.half_x_m, along_m / plan.half_z_m);
      const double share = std::min(4.0 * (1.0 - out), 1.0) *
                           std::min(2.5 * (cover.at(x_m, along_m) - plan.holes) / (1.0 - plan.holes), 1.0);
      const double radius_m =
          plan.radius_m * draws.between(1.0 - plan.spread, 1.0 + plan.spread) * (0.4 + 0.6 * share);
      const double up = draws.between(0.85, 1.15);
      if (share <= 0.0) continue;
      balls.push_back({{x_m, up * plan.middle_m, along_m}, radius_m, 0.5 + 0.5 * share});
    }
  }
  return balls;
}

/// Tufts of hooked fibres that fall behind the wind: thick where they begin, thin where they end.
std::vector<Metaball> cirrus(RandomDraws& draws) {
  std::vector<Metaball> balls;
  constexpr int tufts = 6, fibres = 9, pieces = 90;
  for (int tuft = 0; tuft < tufts; ++tuft) {
    const double head_x_m = draws.between(-2500.0, -700.0),
                 head_z_m = (tuft - 0.5 * (tufts - 1)) * 560.0 + draws.between(-250.0, 250.0);
    const double bend_m = draws.between(-350.0, 350.0), top_m = draws.between(270.0, 330.0);
    for (int fibre = 0; fibre < fibres; ++fibre) {
      const double x_m = head_x_m + draws.between(-450.0, 450.0),
                   z_m = head_z_m + draws.between(-170.0, 170.0);
      const double length_m = draws.between(1700.0, 3300.0), fan_m = draws.between(-260.0, 260.0);
      const double wide_m = draws.between(26.0, 52.0), fall_m = draws.between(220.0, 330.0);
      const double weight = draws.between(0.5, 1.0);
      const Swell swell(900.0, draws);
      for (int i = 0; i < pieces; ++i) {
        const double along = static_cast<double>(i) / (pieces - 1);
        // The hook: its head turns up into the wind.
        const double hook_m = 90.0 * std::exp(-14.0 * along);
        const double thin = (1.0 - 0.65 * along) * std::min(1.0, 0.5 + 8.0 * along);
        balls.push_back({{x_m + length_m * along, top_m - fall_m * std::pow(along, 1.6) - hook_m + 45.0,
                          z_m + (bend_m + fan_m) * along * along},
                         wide_m * thin * (0.7 + 0.6 * swell.at(length_m * along, 0.0)),
                         weight * (1.0 - 0.8 * along) * (0.3 + 1.0 * swell.at(length_m * along, 500.0))});
      }
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
  // As seeds of a sunflower lie: none of it gapes.
  constexpr int anvil_balls = 50;
  const double turn = draws.next();
  for (int i = 0; i < anvil_balls; ++i) {
    const double angle = 2.0 * pi * (0.381966 * i + turn), out = std::sqrt((i + 0.5) / anvil_balls);
    const double x_m = 1300.0 + 4700.0 * out * std::cos(angle) + draws.between(-250.0, 250.0),
                 z_m = 2600.0 * out * std::sin(angle) + draws.between(-250.0, 250.0);
    balls.push_back(
        {{x_m, 9000.0 - 200.0 * out + draws.between(-60.0, 60.0), z_m}, 600.0 - 210.0 * out, 0.7});
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

/// Metaballs of the genera (C6, C15), in metres, the base at y = 0, spread along x; the same for the same
/// seed.
std::vector<Metaball> ball_layout(Genus genus, std::uint64_t seed) {
  RandomDraws draws(seed, OFFING_STREAM_CLOUD_LAYOUT, static_cast<int>(genus), 0);
  switch (genus) {
    case Genus::cirrus:
      return cirrus(draws);
    case Genus::stratus:
      return sheet({.half_x_m = 1450.0,
                    .half_z_m = 1050.0,
                    .row_m = 130.0,
                    .step_m = 130.0,
                    .middle_m = 155.0,
                    .radius_m = 120.0,
                    .spread = 0.15,
                    .swell_m = 1100.0,
                    .holes = 0.0},
                   draws);
    case Genus::cumulus:
      return cumulus(draws);
    case Genus::stratocumulus:
      return sheet({.half_x_m = 1900.0,
                    .half_z_m = 1450.0,
                    .row_m = 330.0,
                    .step_m = 230.0,
                    .middle_m = 200.0,
                    .radius_m = 165.0,
                    .spread = 0.25,
                    .swell_m = 1200.0,
                    .holes = 0.1},
                   draws);
    case Genus::altocumulus:
      return sheet({.half_x_m = 1900.0,
                    .half_z_m = 1300.0,
                    .row_m = 200.0,
                    .step_m = 85.0,
                    .middle_m = 95.0,
                    .radius_m = 72.0,
                    .spread = 0.25,
                    .swell_m = 1100.0,
                    .holes = 0.2},
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

/// What a genus has beside its balls.
struct Preset {
  GenusRange range;
  CloudParameters cloud;
};

/// In the order of Genus. Extinctions: droplets of 0.05 ... 0.5 g/m^3 with an effective radius of some 10 um
/// scatter 0.0075 ... 0.075 per m; ice of cirrus a hundredth of that (Rogers & Yau 1989, A short course in
/// cloud physics).
const std::array<Preset, 8>& presets() {
  using enum Modelling;
  using enum BillboardSet;
  // How fast noise changes, 1/s, and the wind of most: they are in motion unless told otherwise.
  constexpr double slowly = 0.005;
  constexpr glm::dvec3 breeze_mps{8.0, 0.0, 0.0};
  static const std::array<Preset, 8> rows{{
      // Faint and wide-spread; its thin ends are dragged ahead.
      {{"cirrus", 6000.0, 12000.0, 500.0, 4800.0},
       {.modelling = sampled,
        .turbulence = {.wavelength_m = 400.0, .blend = 0.4, .wisp = 1.2, .edge = 0.6, .change_per_s = slowly},
        .target_particles = 2400,
        .look = {.extinction_per_m = 0.007, .billboards = soft},
        .motion = {.wind_mps = {25.0, 0.0, 0.0}, .drag = 6.0}}},
      {{"stratus", 100.0, 900.0, 300.0, 2700.0},
       {.modelling = sampled,
        .turbulence = {.wavelength_m = 500.0, .blend = 0.35, .edge = 0.8, .change_per_s = slowly},
        .target_particles = 1000,
        .look = {.extinction_per_m = 0.012, .billboards = soft},
        .motion = {.wind_mps = breeze_mps}}},
      // Thick, dense, crisp: repulsion radii below the drawn ones, so that particles overlap.
      {{"cumulus", 500.0, 1500.0, 800.0, 1700.0},
       {.modelling = hierarchical,
        .turbulence = {.change_per_s = slowly},
        .levels = {{.ratio = 0.5, .deviation_m = 20.0, .repulsion = 0.82},
                   {.ratio = 0.5, .deviation_m = 10.0, .repulsion = 0.82}},
        .base_m = 0.0,
        .look = {.extinction_per_m = 0.07},
        .motion = {.wind_mps = breeze_mps, .sway_m = 12.0}}},
      {{"stratocumulus", 700.0, 2000.0, 400.0, 3600.0},
       {.modelling = sampled,
        .turbulence = {.wavelength_m = 350.0, .wisp = 1.3, .change_per_s = slowly},
        .target_particles = 1400,
        .look = {.extinction_per_m = 0.025},
        .motion = {.wind_mps = breeze_mps}}},
      {{"altocumulus", 2500.0, 5500.0, 180.0, 3600.0},
       {.modelling = sampled,
        .turbulence = {.wavelength_m = 150.0, .wisp = 1.3, .change_per_s = slowly},
        .target_particles = 1400,
        .look = {.extinction_per_m = 0.015, .billboards = soft},
        .motion = {.wind_mps = {15.0, 0.0, 0.0}}}},
      // Its particles are so large that denser ones would have a hard edge.
      {{"cumulonimbus", 400.0, 1200.0, 9300.0, 11000.0},
       {.modelling = hierarchical,
        .turbulence = {.wavelength_m = 1500.0, .change_per_s = slowly},
        .levels = {{.ratio = 0.5, .deviation_m = 150.0, .repulsion = 0.85},
                   {.ratio = 0.5, .deviation_m = 80.0, .repulsion = 0.85}},
        .base_m = 0.0,
        .look = {.extinction_per_m = 0.01},
        .motion = {.wind_mps = {12.0, 0.0, 0.0}, .sway_m = 60.0}}},
      // Smooth, and stays where it is: air flows through it.
      {{"lenticular", 3000.0, 6000.0, 500.0, 2700.0},
       {.modelling = sampled,
        .turbulence = {.wavelength_m = 600.0, .octaves = 3, .blend = 0.12, .change_per_s = slowly},
        .target_particles = 900,
        .look = {.extinction_per_m = 0.01, .billboards = soft}}},
      {{"funnel", 500.0, 900.0, 900.0, 1000.0},
       {.modelling = sampled,
        .turbulence = {.wavelength_m = 90.0, .blend = 0.4, .change_per_s = 0.05},
        .target_particles = 1300,
        .look = {.extinction_per_m = 0.05, .billboards = soft},
        .motion = {.wind_mps = breeze_mps}}},
  }};
  return rows;
}

const Preset& preset_of(Genus genus) {
  return presets()[static_cast<std::size_t>(genus)];
}

void stretch(CloudParameters& cloud, double size) {
  for (Metaball& ball : cloud.balls) {
    ball.centre_m *= size;
    ball.radius_m *= size;
  }
  for (HierarchyLevel& level : cloud.levels) level.deviation_m *= size;
  cloud.turbulence.wavelength_m *= size;
  cloud.motion.sway_m *= size;
}

}  // namespace

GenusRange range_of(Genus genus) {
  return preset_of(genus).range;
}

Genus genus_named(std::string_view name) {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < presets().size(); ++i) {
    names.push_back(presets()[i].range.name);
    if (names.back() == name) return static_cast<Genus>(i);
  }
  throw Error(ErrorKind::bad_input, fmt::format("cloud.genus: expected a genus, found \"{}\"", name),
              fmt::format("choose one of {}", fmt::join(names, ", ")));
}

CloudParameters preset(Genus genus, std::uint64_t seed, double size) {
  const auto& [range, usual] = preset_of(genus);
  CloudParameters cloud = usual;
  cloud.seed = seed;
  cloud.genus = genus;
  cloud.position_m.y = 0.5 * (range.lowest_base_m + range.highest_base_m);
  cloud.balls = ball_layout(genus, seed);
  stretch(cloud, size);
  return cloud;
}

}  // namespace offing::clouds
