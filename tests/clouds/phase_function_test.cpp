#include "host/clouds/light/phase_function.h"

#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/clouds/shape/genera.h"
#include "kernels/shared/random.h"
#include "tests/ocl/expect_error.h"

namespace offing::clouds {
namespace {

struct NamedLook {
  std::string name;
  CloudLook look;
};

std::vector<NamedLook> looks() {
  std::vector<NamedLook> result{{"Rayleigh", {.phase = PhaseKind::rayleigh}},
                                {"isotropic", {.phase = PhaseKind::henyey_greenstein, .g = 0.0}},
                                {"forward", {.phase = PhaseKind::henyey_greenstein, .g = 0.85}},
                                {"backward", {.phase = PhaseKind::henyey_greenstein, .g = -0.5}},
                                {"double", {.phase = PhaseKind::double_henyey_greenstein}}};
  for (const double d : {5.0, 10.0, 20.0, 50.0})
    result.push_back({"droplet " + std::to_string(d), {.phase = PhaseKind::mie_droplet, .droplet_um = d}});
  return result;
}

// Integral of f over the sphere. Angles are the cubes of a parameter in 0 ... 1, dense at the forward peak,
// which for droplets of 50 um is 2e-3 wide; the midpoint rule's error is 1e-8 there.
template <typename F>
double over_sphere(const F& f) {
  constexpr int steps = 400000;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double u = (i + 0.5) / steps, angle = std::numbers::pi * u * u * u;
    sum += f(std::cos(angle)) * 2.0 * std::numbers::pi * std::sin(angle) * 3.0 * std::numbers::pi * u * u /
           steps;
  }
  return sum;
}

// Fails if a phase function creates or destroys light, or its mean cosine, on which all diffusion rests, is
// not that of the function itself.
TEST(PhaseFunctionTest, IntegralsAreThoseOfItsMoments) {
  for (const NamedLook& named : looks()) {
    const PhaseFunction phase(named.look);
    const std::vector<double> moments = phase.moments(4);
    EXPECT_NEAR(over_sphere(phase), 1.0, 1e-6) << named.name;
    EXPECT_NEAR(over_sphere([&](double c) { return c * phase(c); }), moments[1], 1e-6) << named.name;
    EXPECT_NEAR(over_sphere([&](double c) { return 0.5 * (3.0 * c * c - 1.0) * phase(c); }), moments[2], 1e-6)
        << named.name;
    EXPECT_NEAR(over_sphere([&](double c) { return 0.5 * (5.0 * c * c - 3.0) * c * phase(c); }), moments[3],
                1e-6)
        << named.name;
  }
}

// Fails if a formula is mistyped. Rayleigh: 3 / (16 pi) (1 + c^2). Henyey-Greenstein forward: (1 + g) / (4 pi
// (1 - g)^2). Draine's mean cosine: g (1 + alpha (3 + 2 g^2) / 5) / (1 + alpha (1 + 2 g^2) / 3), his eq. 9.
// Water droplets in visible light scatter forward with mean cosines of 0.80 ... 0.88 (Hansen & Travis 1974,
// fig. 12).
TEST(PhaseFunctionTest, ClosedForms) {
  const PhaseFunction rayleigh(looks()[0].look), forward(looks()[2].look);
  EXPECT_NEAR(rayleigh(0.3), 3.0 / (16.0 * std::numbers::pi) * 1.09, 1e-12);
  EXPECT_NEAR(forward(1.0), 1.85 / (4.0 * std::numbers::pi * 0.0225), 1e-9);
  EXPECT_NEAR(forward.mean_cosine(), 0.85, 1e-12);
  for (const double d : {5.0, 10.0, 20.0, 50.0}) {
    const PhaseFunction droplet({.phase = PhaseKind::mie_droplet, .droplet_um = d});
    double mean = 0.0;
    for (const PhaseLobe& lobe : droplet.lobes()) {
      const double g2 = lobe.g * lobe.g;
      mean += lobe.weight * lobe.g * (1.0 + lobe.alpha * (3.0 + 2.0 * g2) / 5.0) /
              (1.0 + lobe.alpha * (1.0 + 2.0 * g2) / 3.0);
    }
    EXPECT_NEAR(droplet.mean_cosine(), mean, 1e-12);
    EXPECT_GT(mean, 0.80);
    EXPECT_LT(mean, 0.90);
  }
}

// Fails if clouds are lit that send more light back than the diffusion of their light can tell of: below a
// mean cosine of -0.5, whichever of the parameters says so.
TEST(PhaseFunctionTest, RefusesWhatScattersBackward) {
  CloudParameters cloud = preset(Genus::cumulus);
  cloud.look.phase = PhaseKind::henyey_greenstein;
  cloud.look.g = -0.5;
  EXPECT_NO_THROW(require_valid(cloud));
  cloud.look.g = -0.51;
  offing::test::expect_error(ErrorKind::bad_input, "cloud.g", [&] { require_valid(cloud); });
  cloud.look = {.phase = PhaseKind::double_henyey_greenstein, .g = 0.2, .g_back = -0.9, .forward_share = 0.1};
  offing::test::expect_error(ErrorKind::bad_input, "mean cosine of scattering", [&] { require_valid(cloud); });
}

// Fails if paths scatter with another density than they are weighed with. Means of 2e5 cosines and of their
// squares, whose standard errors are below 1 / sqrt(2e5) = 2.2e-3; five of them fail by chance once in 1e5
// tests.
TEST(PhaseFunctionTest, SamplesHaveItsMoments) {
  for (const NamedLook& named : looks()) {
    const PhaseFunction phase(named.look);
    const std::vector<double> moments = phase.moments(3);
    int counter = 0;
    const auto next = [&] {
      return static_cast<double>(uniform_open01(philox_block(7, 0, 0, counter++, 0, 0).v[0]));
    };
    constexpr int count = 200000;
    double sum = 0.0, squares = 0.0;
    for (int i = 0; i < count; ++i) {
      const double cosine = phase.sample(next);
      sum += cosine / count;
      squares += 0.5 * (3.0 * cosine * cosine - 1.0) / count;
    }
    EXPECT_NEAR(sum, moments[1], 0.011) << named.name;
    EXPECT_NEAR(squares, moments[2], 0.011) << named.name;
  }
}

// Fails if a value that has no phase function is taken.
TEST(PhaseFunctionTest, RefusesWhatIsNoPhaseFunction) {
  const double nan = std::nan("");
  for (const CloudLook& look :
       {CloudLook{.g = 1.0}, CloudLook{.g = nan}, CloudLook{.forward_share = 1.1}, CloudLook{.g_back = -1.0},
        CloudLook{.phase = PhaseKind::mie_droplet, .droplet_um = 2.0}}) {
    EXPECT_THROW(PhaseFunction{look}, Error);
  }
}

}  // namespace
}  // namespace offing::clouds
