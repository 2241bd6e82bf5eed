// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
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
                     .beam_m = 4.0}}};
}

/// Waves of all lengths and directions: of calm water one step makes heights as small as rounding.
ocean::WakeState rough_water(int cells) {
  std::mt19937 random(20'141'019);
  const auto height_m = [&] { return static_cast<float>(random()) / 4294967296.0f - 0.5f; };
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
  const double shortest = std::numbers::pi / parameters.cell_m();
  const double fade_per_s = 1e-4 + parameters.dispersion.omega_radps(shortest) / (2.0 * std::numbers::pi) *
                                       std::pow(k / shortest, 4);
  return std::exp(-fade_per_s * parameters.step_s);
}

/// The step of the `dispersive` method in C++ with FFTW, without the border: e^(-i omega dt) of each mode,
/// with its fading, under a displaced depth that stays.
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
    for (std::size_t i = 0; i < count_; ++i) {
      state_.data()[2 * i] = modes_.data()[2 * i] - displaced_m_[i];
      state_.data()[2 * i + 1] = modes_.data()[2 * i + 1];
    }
  }

  std::vector<float> heights_m() {
    std::vector<float> heights;
    for (std::size_t i = 0; i < count_; ++i) heights.push_back(state_.data()[2 * i]);
    return heights;
  }

 private:
  std::size_t count_;
  std::vector<float> displaced_m_, turn_;
  HugeArray state_, modes_;
  FftwPlan plan_;
};

/// After one step, inside of the border.
void require_same(const ocean::WakeWindow& ours, const std::vector<float>& peer_m) {
  const std::vector<float> ours_m = ours.read_state().height_m;
  const int n = ours.grid().size;
  std::vector<float> found, expected;
  for (int row = n / 8; row < n - n / 8; ++row) {
    const auto first = static_cast<std::ptrdiff_t>(row * n + n / 8), end = first + n - n / 4;
    found.insert(found.end(), ours_m.begin() + first, ours_m.begin() + end);
    expected.insert(expected.end(), peer_m.begin() + first, peer_m.begin() + end);
  }
  require_equal(fmt::format("wake {}", n), found.data(), expected.data(), found.size());
}

void bench_size(const ocl::Device& device, int size, int blocks, const Sinks& sinks) {
  ocean::WakeParameters parameters{.cells = size, .length_m = 0.5 * size};
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
  sinks.row(row_of("wake_dispersive", size, "C++ with FFTW measure, no border",
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
