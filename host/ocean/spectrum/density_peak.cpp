#include "host/ocean/spectrum/density_peak.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace offing::ocean {
namespace {

constexpr double share_of_largest = 0.3;  // of the density, within the range of the fit
constexpr double largest_move = 0.25;     // of ln f

double middle_hz(const FrequencyBin& bin) {
  return 0.5 * (bin.low_hz + bin.high_hz);
}

double width_hz(const FrequencyBin& bin) {
  return bin.high_hz - bin.low_hz;
}

/// Waves of a lattice in the plane of wavenumbers lie within a range of frequency as f^3 df.
double weight_of(const FrequencyBin& bin) {
  return std::pow(middle_hz(bin), 3.0) * width_hz(bin);
}

class PeakFit {
 public:
  PeakFit(std::span<const FrequencyBin> bins, const std::function<double(double)>& density_m2phz,
          double peak_hz)
      : density_m2phz_(density_m2phz) {
    const double least = share_of_largest * density_m2phz(peak_hz);
    const auto is_low = [&](const FrequencyBin& bin) { return density_m2phz(middle_hz(bin)) < least; };
    const auto at_peak = std::find_if(bins.begin(), bins.end(),
                                      [&](const FrequencyBin& bin) { return bin.high_hz > peak_hz; });
    const auto first = std::find_if(std::make_reverse_iterator(at_peak), bins.rend(), is_low).base();
    const auto end = std::find_if(at_peak, bins.end(), is_low);
    bins_ = {first, end};
  }

  bool has_bins() const { return bins_.size() >= 3; }

  /// Of the energies, with the shape moved by this step of ln f, and scaled as suits it best.
  double likelihood(double move) const {
    double logarithms = 0.0, ratios = 0.0, total = 0.0;
    for (const FrequencyBin& bin : bins_) {
      const double mean = shape_within(bin, std::exp(-move));
      logarithms += weight_of(bin) * std::log(mean);
      ratios += weight_of(bin) * bin.energy_m2 / mean;
      total += weight_of(bin);
    }
    const double value = -logarithms - total * std::log(ratios / total);
    return std::isfinite(value) ? value : -INFINITY;
  }

  /// Of the best move: of ln m_i = g_i move, sum of w g r / sum of w g^2 with the scatter r of each bin and g
  /// around its mean.
  double error() const {
    constexpr double step = 1e-3;
    double total = 0.0, mean_rise = 0.0;
    std::vector<double> rises;
    for (const FrequencyBin& bin : bins_) {
      const double hz = middle_hz(bin);
      rises.push_back(std::log(density_m2phz_(hz * (1.0 + step)) / density_m2phz_(hz * (1.0 - step))) /
                      (2.0 * step));
      total += weight_of(bin);
      mean_rise += weight_of(bin) * rises.back();
    }
    mean_rise /= total;
    double information = 0.0, variance = 0.0;
    for (std::size_t i = 0; i < bins_.size(); ++i) {
      const double effect = weight_of(bins_[i]) * (rises[i] - mean_rise);
      information += effect * (rises[i] - mean_rise);
      if (bins_[i].waves > 0.0) variance += effect * effect / bins_[i].waves;
    }
    const double error = std::sqrt(variance) / information;
    return std::isfinite(error) ? error : 0.0;
  }

 private:
  /// Integral of the shape over a bin, on a frequency axis that is stretched by this factor: Simpson's rule,
  /// since bins of a small patch are as wide as half a narrow peak.
  double shape_within(const FrequencyBin& bin, double factor) const {
    return width_hz(bin) / 6.0 *
           (density_m2phz_(bin.low_hz * factor) + 4.0 * density_m2phz_(middle_hz(bin) * factor) +
            density_m2phz_(bin.high_hz * factor));
  }

  std::span<const FrequencyBin> bins_;
  const std::function<double(double)>& density_m2phz_;
};

}  // namespace

DensityPeak peak_of(std::span<const FrequencyBin> bins, const std::function<double(double hz)>& density_m2phz,
                    double peak_hz) {
  const PeakFit fit(bins, density_m2phz, peak_hz);
  if (!fit.has_bins()) return {peak_hz};
  constexpr int steps = 25;  // to either side
  constexpr double step = largest_move / steps;
  double best = 0.0, best_likelihood = -INFINITY;
  for (int i = -steps; i <= steps; ++i) {
    const double likelihood = fit.likelihood(i * step);
    if (likelihood <= best_likelihood) continue;
    best_likelihood = likelihood;
    best = i * step;
  }
  double left = best - step, right = best + step;
  const double golden = 1.0 / std::numbers::phi;
  while (right - left > 1e-6) {
    const double inner_left = right - golden * (right - left), inner_right = left + golden * (right - left);
    if (fit.likelihood(inner_left) > fit.likelihood(inner_right)) {
      right = inner_right;
    } else {
      left = inner_left;
    }
  }
  return {peak_hz * std::exp(0.5 * (left + right)), fit.error()};
}

}  // namespace offing::ocean
