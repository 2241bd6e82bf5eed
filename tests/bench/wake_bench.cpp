// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include <cmath>
#include <numbers>

#include "host/ocean/wake_window.h"
#include "tests/bench/benches.h"
#include "tests/bench/difference.h"
#include "tests/bench/fftw_plan.h"
#include "tests/bench/huge_array.h"

namespace offing::bench {
namespace {

const ocean::WakeForcing one_hull{
    .centre = {}, .hulls = {{.shape = ocean::WakeHull::Shape::gaussian, .length_m = 12.0, .beam_m = 4.0}}};

/// The step of the `dispersive` method in C++ with FFTW, without the border: e^(-i omega dt) of each mode,
/// under a displaced depth that stays.
class FftwStep {
 public:
  FftwStep(const ocean::WakeParameters& parameters, const std::vector<float>& displaced_m)
      : count_(displaced_m.size()),
        displaced_m_(displaced_m),
        state_(2 * count_),
        modes_(2 * count_),
        // A forward transform is the conjugate of the inverse one of the conjugate: one plan serves both.
        plan_({.size = parameters.cells, .batch = 1, .pitch = parameters.cells}, modes_.data(), modes_.data(),
              core_count() == 1 ? Threading::one : Threading::openmp) {
    state_.clear();
    const int n = parameters.cells;
    for (int row = 0; row < n; ++row) {
      for (int column = 0; column < n; ++column) {
        const double k = 2.0 * std::numbers::pi / parameters.length_m *
                         std::hypot(row <= n / 2 ? row : row - n, column <= n / 2 ? column : column - n);
        const double angle = parameters.dispersion.omega_radps(k) * parameters.step_s;
        turn_.push_back(static_cast<float>(std::cos(angle) / static_cast<double>(count_)));
        turn_.push_back(static_cast<float>(std::sin(angle) / static_cast<double>(count_)));
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

/// After one step, inside of the border; the peer's heights lie as WakeGrid says.
void require_same(const ocean::WakeWindow& ours, const std::vector<float>& peer_m) {
  const std::vector<float> ours_m = ours.read_state().height_m;
  const WakeGrid grid = ours.grid();
  const int n = grid.size, mask = n - 1;
  std::vector<float> found, expected;
  for (int row = n / 8; row < n - n / 8; ++row) {
    for (int column = n / 8; column < n - n / 8; ++column) {
      found.push_back(ours_m[static_cast<std::size_t>(row * n + column)]);
      expected.push_back(peer_m[static_cast<std::size_t>(((grid.first_row + row) & mask) * n +
                                                         ((grid.first_column + column) & mask))]);
    }
  }
  require_equal(fmt::format("wake {}", n), found.data(), expected.data(), found.size());
}

void bench_size(const ocl::Device& device, int size, int blocks, const Sinks& sinks) {
  ocean::WakeParameters parameters{.cells = size, .length_m = 0.5 * size};
  std::vector<float> displaced_m;
  const auto forcing_at = [](double) { return one_hull; };
  ocean::WakeWindow ours(device, parameters);
  ours.advance_to(parameters.step_s, forcing_at, [&](double, const WakeGrid&, ocl::Buffer<float>& depths_m) {
    displaced_m = depths_m.read();
  });
  FftwStep peer(parameters, displaced_m);
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
