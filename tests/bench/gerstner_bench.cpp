// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include <cmath>
#include <numbers>

#include "host/base/error.h"
#include "host/ocean/surface/gerstner_surface.h"
#include "tests/bench/benches.h"
#include "tests/bench/difference.h"
#include "tests/bench/peers/gerstner_peer.h"

namespace offing::bench {
namespace {

using Way = GerstnerPeer::Way;

constexpr double frame_s = 1.0 / 24.0;
constexpr int wave_count = 16;
constexpr int least_size = 64;  // a block of the peers
// The same piece of sea for every size: phases of a larger one would not fit the peers' floats.
constexpr double side_m = 128.0;

/// Waves of 10 ... 100 m, all drawn in full.
ocean::GerstnerSea sea() {
  ocean::GerstnerSea sea;
  for (int i = 0; i < wave_count; ++i) {
    const double k = 2.0 * std::numbers::pi / (10.0 + 6.0 * i);
    sea.waves.push_back({.amplitude_m = 0.05 / k,
                         .wavenumber_radpm = k,
                         .direction_rad = 0.4 * i,
                         .omega_radps = std::sqrt(9.81 * k),
                         .phase_rad = 1.0 * i});
  }
  return sea;
}

/// The eight fields, at a time when phases have gone round often.
void require_equal_maps(const ocl::Device& device, ocean::GerstnerSurface& ours, GerstnerPeer& peer, Way way,
                        const ocean::SampleGrid& grid) {
  constexpr double time_s = 123.4;
  constexpr const char* names[] = {"dx", "h", "dz", "d dx/dz", "dh/dx", "dh/dz", "d dx/dx", "d dz/dz"};
  ours.at(sea(), grid, time_s);
  peer.at(time_s, way);
  device.finish();
  const auto displacement = ours.displacement().map();
  const auto gradient = ours.gradient().map();
  const std::size_t samples = static_cast<std::size_t>(grid.rows) * static_cast<std::size_t>(grid.columns);
  for (std::size_t field = 0; field < 8; ++field) {
    const auto& ours_map = field < 4 ? displacement : gradient;
    const HugeArray& peers_map = field < 4 ? peer.displacement() : peer.gradient();
    require_equal(fmt::format("gerstner {}, {}, {}", grid.columns, GerstnerPeer::way_name(way), names[field]),
                  &ours_map[field % 4], peers_map.data() + field % 4, samples, 4);
  }
}

void bench_size(const ocl::Device& device, int size, int blocks, const Sinks& sinks) {
  if (size < least_size) {
    throw Error(ErrorKind::bad_usage, fmt::format("--sizes: expected 64 or more, got {}", size),
                "for example --sizes 256");
  }
  const double spacing_m = side_m / size;
  const ocean::SampleGrid grid{
      .spacing_x_m = spacing_m, .spacing_z_m = spacing_m, .columns = size, .rows = size};
  const ocean::GerstnerSea waves = sea();
  ocean::GerstnerSurface ours(device);
  GerstnerPeer peer(waves, grid);
  double ours_time_s = 0.0, peers_time_s = 0.0;
  const Work enqueue_ours = [&] { ours.at(waves, grid, ours_time_s += frame_s); };
  const auto until_finished = [&](const Work& work) -> Work {
    return [&device, work] {
      work();
      device.finish();
    };
  };
  for (const auto& ways : {std::vector{Way::loop_64, Way::loop_256}, {Way::recurrence, Way::mirrored}}) {
    std::vector<Work> alternatives;
    for (const Way way : ways) {
      require_equal_maps(device, ours, peer, way, grid);
      alternatives.emplace_back([&, way] { peer.at(peers_time_s += frame_s, way); });
    }
    const std::size_t best = fastest(alternatives);
    const std::string name(GerstnerPeer::way_name(ways[best]));
    sinks.row(row_of(
        "gerstner", size, name,
        for_each_one(compare(until_finished(repeated(enqueue_ours)), repeated(alternatives[best]), blocks))));
    sinks.row(row_of("gerstner_alone", size, name,
                     compare(until_finished(enqueue_ours), alternatives[best], blocks)));
  }
}

}  // namespace

void bench_gerstner(const ocl::Device& device, const Settings& settings, const Sinks& sinks) {
  for (const int size : settings.sizes) bench_size(device, size, settings.blocks, sinks);
}

}  // namespace offing::bench
