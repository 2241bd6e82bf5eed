#include "host/ocean/spectrum/slope_covariance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/ocean/ocean_limits.h"

namespace offing::ocean {
namespace {

/// Signed wavenumber index of the element i of an array of n.
int signed_index(int i, int n) {
  return i < n / 2 ? i : i - n;
}

/// What the mean over `width` neighbours leaves of the amplitude of wave i of n (a Dirichlet kernel).
double mean_response(int i, int n, int width) {
  const double half_phase = std::numbers::pi * i / n;
  if (i == 0) return 1.0;
  return std::sin(half_phase * width) / (width * std::sin(half_phase));
}

}  // namespace

std::vector<SlopeCovariance> hidden_slopes(std::span<const float> variance, int size, double patch_length_m) {
  require_valid_size(size);
  require_within("patch_length_m", patch_length_m, 0.01, 1e6);
  const auto n = static_cast<std::size_t>(size);
  if (variance.size() != n * n) {
    throw Error(ErrorKind::bad_input,
                fmt::format("mode variance: expected {} x {} values, found {}", n, n, variance.size()),
                "give the array of Ocean::mode_variance()");
  }
  const double step_radpm = 2.0 * std::numbers::pi / patch_length_m;
  std::vector<SlopeCovariance> hidden;
  for (int width = 1; width <= size; width *= 2) {
    std::vector<double> kept(n);  // of the variance, along one axis
    for (std::size_t i = 0; i < n; ++i) {
      const double response = mean_response(signed_index(static_cast<int>(i), size), size, width);
      kept[i] = response * response;
    }
    SlopeCovariance& sum = hidden.emplace_back();
    for (std::size_t row = 0; row < n; ++row) {
      const double kz = step_radpm * signed_index(static_cast<int>(row), size);
      for (std::size_t column = 0; column < n; ++column) {
        const double mode_m2 = variance[row * n + column];
        if (mode_m2 == 0.0) continue;
        const double kx = step_radpm * signed_index(static_cast<int>(column), size);
        const double lost_m2 = mode_m2 * (1.0 - kept[row] * kept[column]);
        sum.xx += kx * kx * lost_m2;
        sum.xz += kx * kz * lost_m2;
        sum.zz += kz * kz * lost_m2;
      }
    }
  }
  return hidden;
}

SlopeCovariance measured_slopes(const Wind& wind) {
  require_within("wind_speed_mps", wind.wind_speed_mps, 0.0, 100.0);
  const double along = 0.00316 * wind.wind_speed_mps, across = 0.003 + 0.00192 * wind.wind_speed_mps;
  const double cosine = std::cos(wind.wind_direction_rad), sine = std::sin(wind.wind_direction_rad);
  return {.xx = along * cosine * cosine + across * sine * sine,
          .xz = (along - across) * cosine * sine,
          .zz = along * sine * sine + across * cosine * cosine};
}

SlopeCovariance remaining_slopes(const SlopeCovariance& all, const SlopeCovariance& resolved, double least) {
  // One factor for all directions keeps the result positive definite, as `all` is.
  const double share = 1.0 - resolved.mean_square() / std::max(all.mean_square(), 1e-12);
  const double factor = std::clamp(share, least, 1.0);
  return {.xx = factor * all.xx, .xz = factor * all.xz, .zz = factor * all.zz};
}

}  // namespace offing::ocean
