#include "host/clouds/shape/genera.h"

#include <array>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/base/error.h"
#include "host/clouds/shape/ball_layouts.h"

namespace offing::clouds {
namespace {

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
