#include "host/clouds/light/phase_table.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "host/clouds/light/phase_function.h"
#include "host/clouds/reference/reference_tracer.h"
#include "kernels/shared/cloud_light_params.h"

namespace offing::clouds {
namespace {

CloudLook henyey_greenstein(double g) {
  CloudLook look;
  look.phase = PhaseKind::henyey_greenstein;
  look.g = g;
  return look;
}

// Share of light from straight above that a slab of droplets lets through which absorb nothing, in the
// delta-Eddington approximation: (5 - exp(-(1 - f) t)) / (4 + 3 (1 - g) t).
double slab_transmittance(const PhaseFunction& phase, double optical_depth) {
  const double g = phase.mean_cosine(), f = delta_scaling(phase).forward_share;
  return (5.0 - std::exp(-(1.0 - f) * optical_depth)) / (4.0 + 3.0 * (1.0 - g) * optical_depth);
}

// Fails if a short way bends light otherwise than the phase function says, for each kind: row 0 is of depth
// 0.
TEST(PhaseTableTest, WithoutDepthIsThePhaseFunction) {
  for (const PhaseKind kind : {PhaseKind::rayleigh, PhaseKind::henyey_greenstein,
                               PhaseKind::double_henyey_greenstein, PhaseKind::mie_droplet}) {
    CloudLook look;
    look.phase = kind;
    const PhaseFunction phase(look);
    const std::vector<float> table = phase_table(phase);
    for (int column = 0; column < CLOUD_PHASE_ANGLES; ++column) {
      const double u = static_cast<double>(column) / (CLOUD_PHASE_ANGLES - 1);
      const double expected = phase(std::cos(std::numbers::pi * u * u));
      // Moments below 1e-5 are left out of a sum that is 0 here.
      EXPECT_NEAR(table[static_cast<std::size_t>(column)], expected, 1e-4 * expected + 1e-5) << column;
    }
  }
}

// Fails if the aureole is a wrong one: straight ahead, small-angle scattering of a Henyey-Greenstein function
// is the sum over its orders n of t^(n-1) / n! e^(-f t) times the function of g^n, of which l = 0 and 1 are
// kept to first order. Row 8 is of depth 2. Both are sums of floats' accuracy; gate 1e-4.
TEST(PhaseTableTest, AureoleIsThatOfAllForwardScatterings) {
  const double g = 0.85, f = g * g, t = 2.0;
  const std::vector<float> table = phase_table(PhaseFunction(henyey_greenstein(g)));
  double expected = 0.0, factor = std::exp(-f * t);
  for (int n = 1; n < 60; ++n) {
    factor *= n == 1 ? 1.0 : t / n;
    const double gn = std::pow(g, n);
    expected += factor * (1.0 + gn) / (4.0 * std::numbers::pi * (1.0 - gn) * (1.0 - gn));
  }
  for (int l = 0; l < 2; ++l) {
    const double b = std::pow(g, l);
    const double all = (std::exp((b - f) * t) - std::exp(-f * t)) / t,
                 first = b - f + (1.0 - std::exp(-f * t)) / t;
    expected += (2.0 * l + 1.0) / (4.0 * std::numbers::pi) * (first - all);
  }
  EXPECT_NEAR(table[8 * CLOUD_PHASE_ANGLES], expected, 1e-4 * expected);
}

// Fails if the law of transmittance, on which the calibrated light rests, is not the truth's within 2.5 % at
// any depth: a conservative slab of g = 0.85, whose transmittances at 2 ... 32 were traced; and again by the
// tracer here, 40,000 photons (standard error 0.25 %).
TEST(PhaseTableTest, SlabsLetThroughWhatTheyShould) {
  const PhaseFunction phase(henyey_greenstein(0.85));
  const double depths[] = {2.0, 4.0, 8.0, 16.0, 32.0}, truth[] = {0.909, 0.809, 0.642, 0.444, 0.274};
  for (int i = 0; i < 5; ++i) {
    EXPECT_NEAR(slab_transmittance(phase, depths[i]) / truth[i], 1.0, 0.025) << depths[i];
    const SlabLight traced = trace_slab(depths[i], 1.0, 1.0, henyey_greenstein(0.85), {.samples = 40000});
    EXPECT_NEAR(traced.transmitted, truth[i], 4.0 * traced.transmitted_error + 5e-4) << depths[i];
  }
}

}  // namespace
}  // namespace offing::clouds
