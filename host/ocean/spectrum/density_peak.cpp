#include "host/ocean/spectrum/density_peak.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace offing::ocean {
namespace {

constexpr double smoothing = 0.06;        // standard deviation in ln f
constexpr double share_of_largest = 0.6;  // of the smoothed density, within the range of the fit
constexpr std::size_t fewest_bins = 5;    // for three coefficients

double middle_hz(const FrequencyBin& bin) {
  return 0.5 * (bin.low_hz + bin.high_hz);
}

double width_hz(const FrequencyBin& bin) {
  return bin.high_hz - bin.low_hz;
}

std::vector<double> smoothed_density(std::span<const FrequencyBin> bins) {
  std::vector<double> density;
  std::size_t first = 0;
  for (const FrequencyBin& at : bins) {
    const auto distance = [&](const FrequencyBin& bin) {
      return std::log(middle_hz(bin) / middle_hz(at)) / smoothing;
    };
    constexpr double reach = 4.0;  // standard deviations: beyond, a weight is below 4e-4
    while (distance(bins[first]) < -reach) ++first;
    double energy = 0.0, width = 0.0;
    for (std::size_t i = first; i < bins.size() && distance(bins[i]) <= reach; ++i) {
      const double weight = std::exp(-0.5 * distance(bins[i]) * distance(bins[i]));
      energy += weight * bins[i].energy_m2;
      width += weight * width_hz(bins[i]);
    }
    density.push_back(energy / width);
  }
  return density;
}

using Triple = std::array<double, 3>;

/// Solves the symmetric A x = y by Cramer's rule; nothing where A is singular.
std::optional<Triple> solve(const std::array<Triple, 3>& a, const Triple& y) {
  const auto determinant = [](const Triple& p, const Triple& q, const Triple& r) {
    return p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0]) +
           p[2] * (q[0] * r[1] - q[1] * r[0]);
  };
  const double whole = determinant(a[0], a[1], a[2]);
  if (whole == 0.0) return std::nullopt;
  return Triple{determinant(y, a[1], a[2]) / whole, determinant(a[0], y, a[2]) / whole,
                determinant(a[0], a[1], y) / whole};
}

/// a + b u + c e^-4u with u = ln(f / reference), fitted to these bins by steps of least squares on ln E, in
/// which energies that scatter in proportion to their mean weigh as many as there are waves: f^3 df.
class PeakFit {
 public:
  PeakFit(std::span<const FrequencyBin> bins, std::span<const double> start, double reference_hz)
      : bins_(bins), reference_hz_(reference_hz) {
    std::vector<double> model(start.begin(), start.end());
    constexpr int steps = 20;
    for (int step = 0; step < steps; ++step) {
      products_ = {};
      Triple sums{};
      for (std::size_t i = 0; i < bins_.size(); ++i) {
        const Triple terms = terms_of(bins_[i]);
        const double density = bins_[i].energy_m2 / width_hz(bins_[i]);
        const double working = std::log(model[i]) + (density - model[i]) / model[i];
        for (int row = 0; row < 3; ++row) {
          sums[row] += weight_of(bins_[i]) * terms[row] * working;
          for (int column = 0; column < 3; ++column)
            products_[row][column] += weight_of(bins_[i]) * terms[row] * terms[column];
        }
      }
      coefficients_ = solve(products_, sums);
      if (!coefficients_) return;
      for (std::size_t i = 0; i < bins_.size(); ++i)
        model[i] = std::exp(dot(*coefficients_, terms_of(bins_[i])));
      const auto is_usable = [](double value) { return value > 0.0 && std::isfinite(value); };
      if (std::all_of(model.begin(), model.end(), is_usable)) continue;
      coefficients_.reset();
      return;
    }
  }

  /// Nothing where the fit has no maximum among the bins.
  std::optional<DensityPeak> maximum() const {
    if (!coefficients_) return std::nullopt;
    const auto [a, b, c] = *coefficients_;
    if (!(b < 0.0 && c < 0.0)) return std::nullopt;
    const double peak_hz = reference_hz_ * std::pow(4.0 * c / b, 0.25);
    if (!(peak_hz > bins_.front().low_hz && peak_hz < bins_.back().high_hz)) return std::nullopt;
    return DensityPeak{peak_hz, error({0.0, -0.25 / b, 0.25 / c})};
  }

 private:
  static double dot(const Triple& p, const Triple& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }

  Triple terms_of(const FrequencyBin& bin) const {
    const double u = std::log(middle_hz(bin) / reference_hz_);
    return {1.0, u, std::exp(-4.0 * u)};
  }

  double weight_of(const FrequencyBin& bin) const {
    return std::pow(middle_hz(bin) / reference_hz_, 3.0) * width_hz(bin);
  }

  /// Of a figure with this gradient over the coefficients, by how ln E of each bin moves them.
  double error(const Triple& gradient) const {
    const std::optional<Triple> pull = solve(products_, gradient);
    double variance = 0.0;
    for (const FrequencyBin& bin : bins_) {
      if (!pull || bin.waves <= 0.0) continue;
      const double effect = weight_of(bin) * dot(*pull, terms_of(bin));
      variance += effect * effect / bin.waves;
    }
    return std::sqrt(variance);
  }

  std::span<const FrequencyBin> bins_;
  double reference_hz_;
  std::array<Triple, 3> products_{};
  std::optional<Triple> coefficients_;
};

}  // namespace

DensityPeak peak_of(std::span<const FrequencyBin> bins) {
  const std::vector<double> density = smoothed_density(bins);
  const std::size_t largest = std::max_element(density.begin(), density.end()) - density.begin();
  std::size_t first = largest, end = largest + 1;
  const auto is_in = [&](std::size_t i) { return density[i] > share_of_largest * density[largest]; };
  while (first > 0 && is_in(first - 1)) --first;
  while (end < bins.size() && is_in(end)) ++end;
  while (end - first < std::min(fewest_bins, bins.size())) {
    if (first > 0) --first;
    if (end < bins.size()) ++end;
  }
  const double reference_hz = middle_hz(bins[largest]);
  if (bins.size() < fewest_bins) return {reference_hz};
  const PeakFit fit(bins.subspan(first, end - first), std::span(density).subspan(first, end - first),
                    reference_hz);
  return fit.maximum().value_or(DensityPeak{reference_hz});
}

}  // namespace offing::ocean
