// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "host/ocean/wakes/wake_window.h"
#include "tests/bench/benches.h"
#include "tests/bench/difference.h"
#include "tests/bench/huge_array.h"
#include "tests/bench/peers/fftw_plan.h"

namespace offing::bench {
namespace {

/// A hull in the middle of the window, whose first sample is column and row 0 of the world.
ocean::WakeForcing one_hull(const ocean::WakeParameters& parameters) {
  const double middle_m = 0.5 * parameters.length_m;
  return {.centre = {middle_m, middle_m},
          .hulls = {{.shape = ocean::WakeHull::Shape::gaussian,
                     .x_m = middle_m,
                     .z_m = middle_m,
                     .length_m = 12.0,
                     .beam_m = 4.0,
                     .draught_m = 0.05}}};
}

/// Waves of all lengths and directions, too gentle to break: the peer has no breaking. In calm water, one
/// step would make heights as small as rounding.
ocean::WakeState rough_water(int cells) {
  std::mt19937 random(20'141'019);
  const auto height_m = [&] { return 0.05f * (static_cast<float>(random()) / 4294967296.0f - 0.5f); };
  ocean::WakeState state;
  for (int i = 0; i < cells * cells; ++i) {
    state.height_m.push_back(height_m());
    state.second_m.push_back(height_m());
  }
  return state;
}

/// What a mode keeps of its height in a step: as the window's, whose short waves fade.
double kept_in_step(const ocean::WakeParameters& parameters, double k) {
  if (k == 0.0) return 1.0;
  const double short_wave = 0.5 * std::numbers::pi / parameters.cell_m();
  const double fade_per_s = 1e-4 + parameters.dispersion.omega_radps(short_wave) / (2.0 * std::numbers::pi) *
                                       std::pow(k / short_wave, 6);
  return std::exp(-fade_per_s * parameters.step_s);
}

/// What a row or column keeps of its water in a step: as the window's, whose border absorbs waves.
double kept_by_border(const ocean::WakeParameters& parameters, int place) {
  const double width_m = parameters.length_m / 8.0;
  const double edge_m = (std::min(place, parameters.cells - 1 - place) + 0.5) * parameters.cell_m();
  const double outward = 1.0 - std::min(1.0, edge_m / width_m);
  const double rate_per_s =
      7.5 * parameters.dispersion.group_speed_mps(2.0 * std::numbers::pi / width_m) / width_m;
  return std::exp(-rate_per_s * outward * outward * parameters.step_s);
}

/// The step of the `dispersive` method in C++ with FFTW: e^(-i omega dt) of each mode, with its fading, under
/// a displaced depth that stays, and the border.
class FftwStep {
 public:
  FftwStep(const ocean::WakeParameters& parameters, const ocean::WakeState& start,
           const std::vector<float>& displaced_m)
      : count_(displaced_m.size()),
        displaced_m_(displaced_m),
        state_(2 * count_),
        modes_(2 * count_),
        // A forward transform is the conjugate of the inverse one of the conjugate: one plan serves both.
        plan_({.size = parameters.cells, .batch = 1, .pitch = parameters.cells}, modes_.data(), modes_.data(),
              core_count() == 1 ? Threading::one : Threading::openmp) {
    for (std::size_t i = 0; i < count_; ++i) {
      state_.data()[2 * i] = start.height_m[i];
      state_.data()[2 * i + 1] = start.second_m[i];
    }
    const int n = parameters.cells;
    for (int i = 0; i < n; ++i) kept_.push_back(static_cast<float>(kept_by_border(parameters, i)));
    for (int row = 0; row < n; ++row) {
      for (int column = 0; column < n; ++column) {
        const double k = 2.0 * std::numbers::pi / parameters.length_m *
                         std::hypot(row <= n / 2 ? row : row - n, column <= n / 2 ? column : column - n);
        const double angle = parameters.dispersion.omega_radps(k) * parameters.step_s;
        const double scale = kept_in_step(parameters, k) / static_cast<double>(count_);
        turn_.push_back(static_cast<float>(scale * std::cos(angle)));
        turn_.push_back(static_cast<float>(scale * std::sin(angle)));
      }
    }
  }

  void step() {
    for (std::size_t i = 0; i < count_; ++i) {
      modes_.data()[2 * i] = state_.data()[2 * i] + displaced_m_[i];
      modes_.data()[2 * i + 1] = -state_.data()[2 * i + 1];
    }
    plan_.execute();
    for (std::size_t i = 0; i < count_; ++i) {
      const float x = modes_.data()[2 * i], y = modes_.data()[2 * i + 1];
      // (x - i y) e^(-i omega dt).
      modes_.data()[2 * i] = x * turn_[2 * i] - y * turn_[2 * i + 1];
      modes_.data()[2 * i + 1] = -(x * turn_[2 * i + 1] + y * turn_[2 * i]);
    }
    plan_.execute();
    std::size_t i = 0;
    for (const float of_row : kept_) {
      for (const float of_column : kept_) {
        const float share = of_row * of_column;
        state_.data()[2 * i] = share * (modes_.data()[2 * i] - displaced_m_[i]);
        state_.data()[2 * i + 1] = share * modes_.data()[2 * i + 1];
        ++i;
      }
    }
  }

  std::vector<float> heights_m() {
    std::vector<float> heights;
    for (std::size_t i = 0; i < count_; ++i) heights.push_back(state_.data()[2 * i]);
    return heights;
  }

 private:
  std::size_t count_;
  std::vector<float> displaced_m_, turn_, kept_;
  HugeArray state_, modes_;
  FftwPlan plan_;
};

/// After one step.
void require_same(const ocean::WakeWindow& ours, const std::vector<float>& peer_m) {
  const std::vector<float> ours_m = ours.read_state().height_m;
  require_equal(fmt::format("wake {}", ours.grid().size), ours_m.data(), peer_m.data(), ours_m.size());
}

void bench_size(const ocl::Device& device, int size, int blocks, const Sinks& sinks) {
  ocean::WakeParameters parameters{.cells = size, .length_m = 0.5 * size, .foam_decay_s = 0.0};
  std::vector<float> displaced_m;
  const auto forcing_at = [forcing = one_hull(parameters)](double) { return forcing; };
  ocean::WakeWindow ours(device, parameters);
  const ocean::WakeState start = rough_water(size);
  ours.reset(0.0, forcing_at(0.0).centre);
  ours.write_state(start);
  ours.advance_to(parameters.step_s, forcing_at, [&](double, const WakeGrid&, ocl::Buffer<float>& depths_m) {
    displaced_m = depths_m.read();
  });
  FftwStep peer(parameters, start, displaced_m);
  peer.step();
  require_same(ours, peer.heights_m());
  const auto run = [&](ocean::WakeWindow& window) -> Work {
    return [&device, &window, forcing_at] {
      window.advance_to(window.time_s() + 16.0 * window.parameters().step_s, forcing_at);
      device.finish();
    };
  };
  const Work peer_run = repeated([&] { peer.step(); });
  sinks.row(row_of("wake_dispersive", size, "C++ with FFTW measure",
                   for_each_one(compare(run(ours), peer_run, blocks))));
  parameters.method = ocean::WakeMethod::verlet;
  ocean::WakeWindow verlet(device, parameters);
  sinks.row(row_of("wake_verlet", size, "the dispersive step in C++",
                   for_each_one(compare(run(verlet), peer_run, blocks))));
}

}  // namespace

void bench_wake(const ocl::Device& device, const Settings& settings, const Sinks& sinks) {
  for (const int size : settings.sizes) bench_size(device, size, settings.blocks, sinks);
}

}  // namespace offing::bench
