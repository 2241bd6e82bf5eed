#include "host/clouds/genera.h"

#include <array>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/base/error.h"
#include "host/clouds/ball_layouts.h"

namespace offing::clouds {
namespace {

// In the order of Genus.
constexpr std::array<GenusRange, 8> ranges{{
    {"cirrus", 6000.0, 12000.0, 500.0, 4800.0},
    {"stratus", 100.0, 900.0, 300.0, 2700.0},
    {"cumulus", 500.0, 1500.0, 800.0, 1700.0},
    {"stratocumulus", 700.0, 2000.0, 400.0, 3600.0},
    {"altocumulus", 2500.0, 5500.0, 180.0, 3600.0},
    {"cumulonimbus", 400.0, 1200.0, 9300.0, 11000.0},
    {"lenticular", 3000.0, 6000.0, 500.0, 2700.0},
    {"funnel", 500.0, 900.0, 900.0, 1000.0},
}};

/// What a genus has beside its balls. Extinctions: droplets of 0.05 ... 0.5 g/m^3 with an effective radius of
/// some 10 um scatter 0.0075 ... 0.075 per m; ice of cirrus a hundredth of that (Rogers & Yau 1989, A short
/// course in cloud physics).
void dress(Genus genus, CloudParameters& cloud) {
  Turbulence& turbulence = cloud.turbulence;
  cloud.modelling = Modelling::sampled;
  cloud.motion.wind_mps = {8.0, 0.0, 0.0};
  turbulence.change_per_s = 0.005;
  switch (genus) {
    case Genus::cirrus:
      // Faint and wide-spread; its thin ends are dragged ahead.
      cloud.target_particles = 1200;
      cloud.look.extinction_per_m = 0.0025;
      turbulence.wavelength_m = 260.0;
      turbulence.blend = 0.65;
      turbulence.wisp = 1.8;
      turbulence.edge = 0.6;
      cloud.motion.wind_mps = {25.0, 0.0, 0.0};
      cloud.motion.drag = 6.0;
      break;
    case Genus::stratus:
      cloud.target_particles = 1000;
      cloud.look.extinction_per_m = 0.012;
      turbulence.wavelength_m = 500.0;
      turbulence.blend = 0.35;
      turbulence.edge = 0.8;
      break;
    case Genus::cumulus:
      // Thick, dense, crisp: repulsion radii below the drawn ones, so that particles overlap.
      cloud.modelling = Modelling::hierarchical;
      cloud.levels = {{.ratio = 0.5, .deviation_m = 20.0, .repulsion = 0.86},
                      {.ratio = 0.5, .deviation_m = 10.0, .repulsion = 0.86}};
      cloud.base_m = 0.0;
      cloud.look.extinction_per_m = 0.04;
      cloud.motion.sway_m = 12.0;
      break;
    case Genus::stratocumulus:
      cloud.target_particles = 1400;
      cloud.look.extinction_per_m = 0.025;
      turbulence.wavelength_m = 350.0;
      turbulence.blend = 0.5;
      turbulence.wisp = 1.3;
      break;
    case Genus::altocumulus:
      cloud.target_particles = 1400;
      cloud.look.extinction_per_m = 0.015;
      turbulence.wavelength_m = 150.0;
      turbulence.blend = 0.5;
      turbulence.wisp = 1.3;
      cloud.motion.wind_mps = {15.0, 0.0, 0.0};
      break;
    case Genus::cumulonimbus:
      cloud.modelling = Modelling::hierarchical;
      cloud.levels = {{.ratio = 0.5, .deviation_m = 150.0, .repulsion = 0.85},
                      {.ratio = 0.5, .deviation_m = 80.0, .repulsion = 0.85}};
      cloud.base_m = 0.0;
      // Its particles are so large that a denser one would have a hard edge.
      cloud.look.extinction_per_m = 0.01;
      turbulence.wavelength_m = 1500.0;
      cloud.motion.wind_mps = {12.0, 0.0, 0.0};
      cloud.motion.sway_m = 60.0;
      break;
    case Genus::lenticular:
      // Smooth, and stays where it is: air flows through it.
      cloud.target_particles = 900;
      cloud.look.extinction_per_m = 0.01;
      turbulence.blend = 0.12;
      turbulence.wavelength_m = 600.0;
      turbulence.octaves = 3;
      cloud.motion.wind_mps = {0.0, 0.0, 0.0};
      break;
    case Genus::funnel:
      cloud.target_particles = 1300;
      cloud.look.extinction_per_m = 0.05;
      turbulence.wavelength_m = 90.0;
      turbulence.blend = 0.4;
      turbulence.change_per_s = 0.05;
      break;
  }
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
  return ranges[static_cast<std::size_t>(genus)];
}

Genus genus_named(std::string_view name) {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (ranges[i].name == name) return static_cast<Genus>(i);
    names.push_back(ranges[i].name);
  }
  throw Error(ErrorKind::bad_input, fmt::format("cloud.genus: expected a genus, found \"{}\"", name),
              fmt::format("choose one of {}", fmt::join(names, ", ")));
}

CloudParameters preset(Genus genus, std::uint64_t seed, double size) {
  CloudParameters cloud;
  cloud.seed = seed;
  cloud.genus = genus;
  const GenusRange range = range_of(genus);
  cloud.position_m.y = 0.5 * (range.lowest_base_m + range.highest_base_m);
  cloud.balls = ball_layout(genus, seed);
  dress(genus, cloud);
  stretch(cloud, size);
  return cloud;
}

}  // namespace offing::clouds
