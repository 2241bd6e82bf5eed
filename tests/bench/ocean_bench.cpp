// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include <deque>

#include "host/ocean/spectrum/spectrum_parameters.h"
#include "host/ocean/surface/cascades.h"
#include "host/ocean/surface/ocean.h"
#include "host/ocean/surface/surface_maps.h"
#include "host/ocean/surface/wave_modes.h"
#include "tests/bench/benches.h"
#include "tests/bench/difference.h"
#include "tests/bench/peers/ocean_peer.h"

namespace offing::bench {
namespace {

constexpr double choppiness = 1.0;
constexpr double frame_s = 1.0 / 24.0;
constexpr std::uint64_t seed = 1;
constexpr int size_of_several_cascades = 256;

ocean::SeaSpectrum sea() {
  ocean::SpectrumParameters parameters;
  parameters.model = ocean::SpectrumModel::jonswap;
  parameters.wind_speed_mps = 12.0;
  return ocean::make_sea_spectrum(parameters);
}

/// Ours: the maps of all cascades at once, as ocean::Ocean::at() makes them.
struct OurSea {
  OurSea(const ocl::Device& device, std::span<const double> patch_lengths_m, int size)
      : modes(device, sea(), ocean::cascades_from_patches(patch_lengths_m, size), size, std::nullopt),
        maps(device, modes, choppiness) {
    modes.draw(seed);
  }

  ocean::WaveModes modes;
  ocean::SurfaceMaps maps;
};

/// The eight fields of each cascade, ours against the peer's, at a time when phases have gone round often.
void require_equal_maps(const ocl::Device& device, OurSea& ours, std::deque<OceanPeer>& peers,
                        std::size_t way) {
  constexpr double time_s = 1234.567;
  constexpr const char* names[] = {"dx", "h", "dz", "d dx/dz", "dh/dx", "dh/dz", "d dx/dx", "d dz/dz"};
  ours.maps.at(ours.modes, time_s);
  device.finish();
  const auto displacement = ours.maps.displacement().map();
  const auto gradient = ours.maps.gradient().map();
  const std::size_t texels = static_cast<std::size_t>(ours.modes.size()) * ours.modes.size();
  for (std::size_t cascade = 0; cascade < peers.size(); ++cascade) {
    peers[cascade].at(ours.modes.clock().at(time_s), way);
    for (std::size_t field = 0; field < 8; ++field) {
      const auto& ours_map = field < 4 ? displacement : gradient;
      const HugeArray& peers_map = field < 4 ? peers[cascade].displacement() : peers[cascade].gradient();
      require_equal(fmt::format("ocean {}, {}, field {}", ours.modes.size(), peers[cascade].way_name(way),
                                names[field]),
                    &ours_map[4 * cascade * texels + field % 4], peers_map.data() + field % 4, texels, 4);
    }
  }
}

void bench_frame(const ocl::Device& device, const std::string& name, std::span<const double> patch_lengths_m,
                 int size, int blocks, const Sinks& sinks) {
  OurSea ours(device, patch_lengths_m, size);
  sinks.note(fmt::format("{} {}: planning the peer", name, size));
  std::deque<OceanPeer> peers;
  for (int cascade = 0; cascade < ours.modes.cascade_count(); ++cascade) {
    peers.emplace_back(ours.modes, cascade, static_cast<float>(choppiness));
  }

  double ours_time_s = 0.0, peers_time_s = 0.0;
  const auto run_ours = [&] {
    ours.maps.at(ours.modes, ours_time_s += frame_s);
    device.finish();
  };
  std::vector<Work> ways;
  for (std::size_t way = 0; way < peers.front().way_count(); ++way) {
    require_equal_maps(device, ours, peers, way);
    ways.emplace_back([&, way] {
      const ocean::WaveTime time = ours.modes.clock().at(peers_time_s += frame_s);
      for (OceanPeer& peer : peers) peer.at(time, way);
    });
  }
  const std::size_t best = fastest(ways);
  sinks.row(row_of(name, size, peers.front().way_name(best), compare(run_ours, ways[best], blocks)));
}

}  // namespace

void bench_ocean(const ocl::Device& device, const Settings& settings, const Sinks& sinks) {
  const double one_patch_m[] = {400.0};
  const double three_patches_m[] = {400.0, 57.0, 7.9};
  for (const int size : settings.sizes) {
    bench_frame(device, "ocean", one_patch_m, size, settings.blocks, sinks);
    if (size == size_of_several_cascades) {
      bench_frame(device, "ocean_3_cascades", three_patches_m, size, settings.blocks, sinks);
    }
  }
}

}  // namespace offing::bench
