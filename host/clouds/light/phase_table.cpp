// The table of where light goes in its first scattering, with its aureole.
#include "host/clouds/light/phase_table.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "kernels/shared/cloud_light_params.h"

namespace offing::clouds {
namespace {

// Moments beyond this add nothing that the table's angles would show.
constexpr int moment_count = 2048;
// Of moments; beyond it (b t)^2 / 2 is lost in the sum.
constexpr double least_moment = 1e-5;
// Between these cosines the aureole ends.
constexpr double aureole_ends = -0.2, aureole_is_whole = 0.5;

double depth_of_row(int row) {
  const double u = static_cast<double>(row) / CLOUD_PHASE_DEPTHS;
  return CLOUD_PHASE_DEPTH_SCALE * u / (1.0 - u);
}

double cosine_of_column(int column) {
  const double u = static_cast<double>(column) / (CLOUD_PHASE_ANGLES - 1);
  return std::cos(std::numbers::pi * u * u);
}

// c_l(t) - e^(-f t) b_l: what is left decays with the square of b_l.
double moment_beyond_first(double b, int l, double f, double t) {
  const double share = std::exp(-f * t);
  if (l < 2) return b - f - share * b + (t > 0.0 ? -std::expm1(-f * t) / t : f);
  // (e^(b t) - 1) / t - b loses all its digits for small b t.
  const double x = b * t;
  const double rest = x < 1e-3 ? 0.5 * x * b * (1.0 + x / 3.0) : std::expm1(x) / t - b;
  return share * rest;
}

}  // namespace

std::vector<float> phase_table(const PhaseFunction& phase) {
  std::vector<double> moments = phase.forward_moments(moment_count);
  const std::vector<double> of_all = phase.moments(2);
  std::copy(of_all.begin(), of_all.end(), moments.begin());
  while (moments.size() > 2 && std::abs(moments.back()) < least_moment) moments.pop_back();
  const double f = delta_scaling(phase).forward_share;
  std::vector<float> table;
  std::vector<double> beyond(moments.size());
  for (int row = 0; row < CLOUD_PHASE_DEPTHS; ++row) {
    const double t = depth_of_row(row);
    for (std::size_t l = 0; l < moments.size(); ++l)
      beyond[l] = (2.0 * static_cast<double>(l) + 1.0) / (4.0 * std::numbers::pi) *
                  moment_beyond_first(moments[l], static_cast<int>(l), f, t);
    for (int column = 0; column < CLOUD_PHASE_ANGLES; ++column) {
      const double c = cosine_of_column(column), plain = phase(c);
      double before = 1.0, legendre = c, sum = std::exp(-f * t) * plain + beyond[0];
      for (std::size_t l = 1; l < beyond.size(); ++l) {
        sum += beyond[l] * legendre;
        const auto n = static_cast<double>(l);
        const double next = ((2.0 * n + 1.0) * c * legendre - n * before) / (n + 1.0);
        before = legendre;
        legendre = next;
      }
      const double u = std::clamp((c - aureole_ends) / (aureole_is_whole - aureole_ends), 0.0, 1.0);
      table.push_back(static_cast<float>(std::max(0.0, std::lerp(plain, sum, u * u * (3.0 - 2.0 * u)))));
    }
  }
  return table;
}

}  // namespace offing::clouds
