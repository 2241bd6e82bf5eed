// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include <cmath>

#include "host/clouds/particle_light.h"
#include "host/clouds/particle_order.h"
#include "tests/bench/benches.h"
#include "tests/clouds/example_clouds.h"

namespace offing::bench {
namespace {

using namespace clouds;

/// Of C16 and of the paper's examples, and up to a million.
constexpr int counts[] = {100, 128, 193, 946, 1000, 2000, 2568, 3000, 30000, 1000000};

void add_row(const std::string& name, int count, const Settings& settings, const Sinks& sinks,
             const Work& work) {
  std::vector<double> times_ms;
  for (int block = 0; block < settings.blocks; ++block) times_ms.push_back(block_ms(work));
  sinks.row({.name = name,
             .size = count,
             .ours_ms = median(times_ms),
             .peer = "none",
             .spread = relative_spread(times_ms)});
}

}  // namespace

void bench_clouds(const ocl::Device& device, const Settings& settings, const Sinks& sinks) {
  CloudIllumination light;
  light.suns.push_back({{0.0, 0.6, 0.8}, glm::dvec3(100.0, 95.0, 90.0)});
  light.sky_kcdpm2 = glm::dvec3(3.0, 4.0, 6.0);
  const CloudLook look;
  const glm::vec3 eye_m(0.0f, 100.0f, 3000.0f);
  ParticleLight lit(device);
  ViewOrder order(device);
  for (const int count : counts) {
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
  }
}

}  // namespace offing::bench
