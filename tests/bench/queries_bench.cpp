// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/ocean/spectrum/spectrum_parameters.h"
#include "host/ocean/surface/cascades.h"
#include "host/ocean/surface/gerstner_choice.h"
#include "host/ocean/surface/ocean.h"
#include "tests/bench/benches.h"
#include "tests/bench/peers/queries_peer_kernels.h"

namespace offing::bench {
namespace {

using Accuracy = ocean::WaterQuery::Accuracy;
using Fields = ocean::WaterQuery::Fields;

constexpr int wave_count = 16, cascade_count = 2;
constexpr double time_s = 12.3;
constexpr double area_m = 1000.0;
constexpr std::size_t point_count = 100'000;
constexpr std::size_t tile_count = (point_count + peer::query_tile - 1) / peer::query_tile;

/// Points within a square, padded to whole tiles of the peer.
std::vector<ocean::WaterPoint> scattered_points() {
  std::mt19937_64 generator(1);
  const auto place_m = [&] { return (static_cast<double>(generator() >> 11) * 0x1p-53 - 0.5) * area_m; };
  std::vector<ocean::WaterPoint> points(tile_count * peer::query_tile);
  for (ocean::WaterPoint& point : points) point = {.x_m = place_m(), .z_m = place_m()};
  return points;
}

ocean::SeaSpectrum wind_sea() {
  ocean::SpectrumParameters wind;
  wind.wind_speed_mps = 15.0;
  return ocean::make_sea_spectrum(wind);
}

/// Long waves as Gerstner waves, the others in two cascades.
struct OurSea {
  OurSea(const ocl::Device& device, const ocean::SeaSpectrum& spectrum, const ocean::GerstnerChoice& choice,
         int size)
      : sea(device, spectrum,
            {.size = size,
             .cascades = ocean::choose_cascades(spectrum, size, cascade_count, choice.split_radpm),
             .gerstner_waves = {.waves = ocean::choose_gerstner_waves(spectrum, choice),
                                .dispersion = spectrum.dispersion}}) {
    sea.at(time_s);
  }

  ocean::Ocean sea;
};

ocean::GerstnerChoice choice_for(const ocean::SeaSpectrum& spectrum) {
  const double peak_m =
      2.0 * std::numbers::pi / spectrum.dispersion.wavenumber_radpm(spectrum.omega_peak_radps);
  return {.split_radpm = ocean::split_at_wavelength_radpm(peak_m / 3.0), .count = wave_count, .seed = 1};
}

/// The same sea in host memory, and the answers of a loop over all cores.
class QueriesPeer {
 public:
  QueriesPeer(const OurSea& ours, const ocean::SurfaceInstant& instant, double gravity_mps2,
              const ocean::WaterQuery& query)
      : samples_(tile_count * peer::query_tile) {
    const ocean::GerstnerInstant& gerstner_waves = instant.gerstner_waves();
    const double q = gerstner_waves.horizontal_scale();
    for (const ocean::GerstnerInstant::Wave& wave : gerstner_waves.waves()) {
      const double k = std::hypot(wave.kx_radpm, wave.kz_radpm), a = wave.amplitude_m, qa = q * a;
      const double cx = wave.kx_radpm / k, cz = wave.kz_radpm / k, speed_mps = wave.omega_radps * a;
      const auto floats = [](auto... values) { return std::array{static_cast<float>(values)...}; };
      // At the surface of deep water.
      const auto cosine = floats(a, -qa * k * cx * cx, -qa * k * cx * cz, -qa * k * cz * cz, speed_mps * cx,
                                 speed_mps * cz, a);
      const auto sine = floats(-qa * cx, -qa * cz, -a * k * cx, -a * k * cz, speed_mps);
      peer::QueryWave& packed = waves_.emplace_back();
      packed = {.kx_radpm = wave.kx_radpm,
                .kz_radpm = wave.kz_radpm,
                .phase_rad = wave.phase_rad,
                .cosine = {},
                .sine = {}};
      std::copy(cosine.begin(), cosine.end(), packed.cosine);
      std::copy(sine.begin(), sine.end(), packed.sine);
    }
    for (const ocean::SurfaceInstant::Maps& maps : instant.cascades()) {
      cascades_.push_back({.displacement = maps.displacement.data(),
                           .gradient = maps.gradient.data(),
                           .flow = maps.flow.empty() ? nullptr : maps.flow.data(),
                           .patch_length_m = maps.patch_length_m});
    }
    sea_ = {.waves = waves_.data(),
            .wave_count = static_cast<int>(waves_.size()),
            .cascades = cascades_.data(),
            .cascade_count = static_cast<int>(cascades_.size()),
            .size = ours.sea.parameters().size,
            .weight_papm = static_cast<float>(query.density_kgpm3 * gravity_mps2),
            .tolerance_m = static_cast<float>(query.tolerance_m)};
  }

  void sample(const std::vector<ocean::WaterPoint>& points) {
#pragma omp parallel for schedule(static)
    for (std::size_t tile = 0; tile < tile_count; ++tile) {
      const std::size_t first = tile * peer::query_tile;
      peer::query_points(sea_, &points[first].x_m, samples_[first].data());
    }
  }

  const std::vector<ocean::FirstWaterFloats>& samples() const {
    return samples_;
  }

 private:
  std::vector<peer::QueryWave> waves_;
  std::vector<peer::QueryCascade> cascades_;
  peer::QuerySea sea_{};
  std::vector<ocean::FirstWaterFloats> samples_;
};

/// Throws Error(device) where the two differ by more than what tolerance and rounding allow: a millimetre.
void require_equal_heights(const std::vector<ocean::WaterSample>& ours,
                           const std::vector<ocean::FirstWaterFloats>& peers) {
  constexpr double gate_m = 1e-3;
  double worst_m = 0.0;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const double off_m = std::abs(1.0 * ours[i].height_m - peers[i][0]);
    worst_m = off_m <= worst_m ? worst_m : off_m;  // also where it is not a number
  }
  if (worst_m <= gate_m) return;
  throw Error(ErrorKind::device,
              fmt::format("queries: ours and the peer's differ by {:.3g} m, expected at most {:g} m", worst_m,
                          gate_m),
              "run the tests of this device: ctest -L quick");
}

/// All points from maps made for queries, and these maps at a new time, both against a frame's maps.
void bench_maps(const ocl::Device& device, OurSea& ours, std::span<const ocean::WaterPoint> asked, int size,
                int blocks, const Sinks& sinks) {
  std::vector<ocean::WaterSample> samples(asked.size());
  const std::span one(samples.data(), 1);
  double new_time_s = time_s;
  const auto sample_at_new_time = [&](const ocean::WaterQuery& query) {
    ours.sea.at(new_time_s += 0.1);
    ours.sea.sample(asked.first(1), one, query);
  };
  const Work frame = [&] {
    ours.sea.at(new_time_s += 0.1);
    ours.sea.displacement_map();
    device.finish();
  };
  for (const Fields fields : {Fields::surface, Fields::surface_and_flow}) {
    const ocean::WaterQuery maps{.fields = fields, .accuracy = Accuracy::maps};
    const ocean::WaterQuery of_frame{.fields = fields, .accuracy = Accuracy::frame_maps};
    const std::string suffix = fields == Fields::surface ? "_surface" : "";
    sinks.row(row_of("queries_maps" + suffix, size, "a frame's maps, bilinear",
                     compare([&] { ours.sea.sample(asked, samples, maps); },
                             [&] { ours.sea.sample(asked, samples, of_frame); }, blocks)));
    sinks.row(row_of("queries_make_maps" + suffix, size, "a frame",
                     compare([&] { sample_at_new_time(maps); }, frame, blocks)));
  }
}

/// One point at a new time of one cascade, from all its modes, against a frame of it.
void bench_exact(const ocl::Device& device, const ocean::SeaSpectrum& spectrum, int size, int blocks,
                 const Sinks& sinks) {
  constexpr double patch_m[] = {400.0};
  ocean::Ocean sea(device, spectrum, {.size = size, .cascades = ocean::cascades_from_patches(patch_m, size)});
  const std::vector<ocean::WaterPoint> point{{12.0, -7.0}};
  std::vector<ocean::WaterSample> sample(1);
  double new_time_s = time_s;
  sinks.row(row_of("queries_exact", size, "a frame",
                   compare(
                       [&] {
                         sea.at(new_time_s += 0.1);
                         sea.sample(point, sample, {.accuracy = Accuracy::exact});
                       },
                       [&] {
                         sea.at(new_time_s += 0.1);
                         sea.displacement_map();
                         device.finish();
                       },
                       blocks)));
}

}  // namespace

void bench_queries(const ocl::Device& device, const Settings& settings, const Sinks& sinks) {
  const std::vector<ocean::WaterPoint> points = scattered_points();
  const std::span<const ocean::WaterPoint> asked(points.data(), point_count);
  const ocean::SeaSpectrum spectrum = wind_sea();
  for (const int size : settings.sizes) {
    OurSea ours(device, spectrum, choice_for(spectrum), size);
    for (const Fields fields : {Fields::surface, Fields::surface_and_flow}) {
      const ocean::WaterQuery query{.fields = fields, .accuracy = Accuracy::frame_maps};
      const ocean::SurfaceInstant instant = ours.sea.instant(query);
      QueriesPeer peer(ours, instant, spectrum.dispersion.gravity_mps2, query);
      std::vector<ocean::WaterSample> samples(point_count);
      const Work run_ours = [&] { ours.sea.sample(asked, samples, query); };
      const Work run_peer = [&] { peer.sample(points); };
      run_ours();
      run_peer();
      require_equal_heights(samples, peer.samples());
      sinks.row(row_of(fields == Fields::surface ? "queries_surface" : "queries", size,
                       "libmvec loop, 64 points at a time", compare(run_ours, run_peer, settings.blocks)));
    }
    bench_maps(device, ours, asked, size, settings.blocks, sinks);
    bench_exact(device, spectrum, size, settings.blocks, sinks);
  }
}

}  // namespace offing::bench
