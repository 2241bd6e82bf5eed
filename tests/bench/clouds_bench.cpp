// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include <algorithm>
#include <cmath>

#include "host/base/camera.h"
#include "host/clouds/image/cloud_image.h"
#include "host/clouds/light/particle_light.h"
#include "host/clouds/particles/cloud_model.h"
#include "host/clouds/particles/particle_order.h"
#include "host/clouds/shape/genera.h"
#include "tests/bench/benches.h"
#include "tests/bench/cloud_counts.h"
#include "tests/clouds/example_clouds.h"

namespace offing::bench {
namespace {

using namespace clouds;

void add_row(const std::string& name, int count, const std::vector<double>& times_ms, const Sinks& sinks) {
  sinks.row({.name = name,
             .size = count,
             .ours_ms = median(times_ms),
             .peer = "none",
             .spread = relative_spread(times_ms)});
}

void add_row(const std::string& name, int count, const Settings& settings, const Sinks& sinks,
             const Work& work) {
  std::vector<double> times_ms;
  for (int block = 0; block < settings.blocks; ++block) times_ms.push_back(block_ms(work));
  add_row(name, count, times_ms, sinks);
}

/// A cumulus that is made anew: three times, but once where that takes seconds.
void add_model_row(const std::string& name, const ocl::Device& device, const CloudParameters& parameters,
                   const Sinks& sinks) {
  constexpr int most_runs = 3;
  constexpr double long_ms = 1000.0;
  std::size_t found = 0;
  std::vector<double> times_ms;
  do {
    times_ms.push_back(once_ms([&] { found = particles_at_rest(device, parameters).size(); }));
  } while (times_ms.size() < most_runs && times_ms.back() < long_ms);
  add_row(name, static_cast<int>(found), times_ms, sinks);
}

/// The cumulus whose last level is so fine that it grows about so many particles; of a level more where no
/// ratio would be fine enough, and of fewer seeds where none is coarse enough.
CloudParameters grown_cumulus(const ocl::Device& device, int count) {
  CloudParameters cumulus = preset(Genus::cumulus);
  const auto grown = [&] { return static_cast<int>(particles_at_rest(device, cumulus).size()); };
  // As many spheres have room on one as its radius over theirs, squared: twice that with the preset's
  // overlap.
  constexpr double children_of_equals = 2.0;
  double& ratio = cumulus.levels.back().ratio;
  if (count > most_drawn_particles) {
    const double children = static_cast<double>(count) / grown();
    cumulus.levels.push_back(cumulus.levels.back());
    cumulus.levels.back().ratio = std::sqrt(children_of_equals / children);
    return cumulus;
  }
  for (int round = 0, found = grown(); round < 4; ++round) {
    ratio = std::clamp(ratio * std::sqrt(static_cast<double>(found) / count), 0.02, 1.0);
    found = grown();
    if (ratio == 1.0 && found > count)
      cumulus.balls.resize(std::max<std::size_t>(
          1, cumulus.balls.size() * static_cast<std::size_t>(count) / static_cast<std::size_t>(found)));
  }
  return cumulus;
}

void add_model_rows(const ocl::Device& device, int count, const Sinks& sinks) {
  CloudParameters sampled = preset(Genus::cumulus);
  sampled.modelling = Modelling::sampled;
  sampled.target_particles = count;
  // A million would take many minutes.
  if (count <= most_drawn_particles) add_model_row("clouds_sample", device, sampled, sinks);
  add_model_row("clouds_grow", device, grown_cumulus(device, count), sinks);
}

}  // namespace

void bench_clouds(const ocl::Device& device, const Settings& settings, const Sinks& sinks) {
  CloudIllumination light;
  light.suns.push_back({{0.0, 0.6, 0.8}, glm::dvec3(100.0, 95.0, 90.0)});
  light.sky_kcdpm2 = glm::dvec3(3.0, 4.0, 6.0);
  const CloudLook look;
  const Camera camera{
      .eye_m = {0.0, 100.0, 1300.0}, .vertical_field_of_view_rad = 0.8, .width_px = 640, .height_px = 360};
  const glm::vec3 eye_m(camera.eye_m);
  ParticleLight lit(device);
  ViewOrder order(device);
  CloudImage picture(device, billboard_textures());
  picture.fit(camera.width_px, camera.height_px);
  for (const int count : cloud_counts) {
    add_model_rows(device, count, sinks);
    // The same cloud of ever smaller particles.
    const double scale = std::cbrt(150.0 / count);
    const std::vector<CloudParticle> particles =
        clouds::test::heap({.count = count, .least_radius_m = 60.0 * scale, .most_radius_m = 160.0 * scale});
    const ocl::Buffer<CloudParticle> buffer(device, particles, "particles");
    ocl::Buffer<CloudSprite> sprites(device, particles.size(), "sprites");
    const auto number = static_cast<std::uint32_t>(count);
    const auto relight = [&](LightModel model) {
      lit.relight(buffer, number, light, std::span(&look, 1), model);
      device.finish();
    };
    add_row("clouds_relight_harris", count, settings, sinks, [&] { relight(LightModel::harris); });
    add_row("clouds_relight", count, settings, sinks, [&] { relight(LightModel::calibrated); });
    add_row("clouds_see", count, settings, sinks, [&] {
      lit.see(eye_m, sprites);
      device.finish();
    });
    add_row("clouds_sort", count, settings, sinks, [&] {
      order.sort(buffer, number, eye_m);
      device.finish();
    });
    add_row("clouds_draw", count, settings, sinks, [&] {
      picture.draw({.particles = buffer, .sprites = sprites, .order = order.order(), .count = number},
                   camera);
      device.finish();
    });
  }
}

}  // namespace offing::bench
