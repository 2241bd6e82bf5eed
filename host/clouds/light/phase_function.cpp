#include "host/clouds/light/phase_function.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "host/base/error.h"

namespace offing::clouds {
namespace {

void require_within(const char* name, double value, double least, double most) {
  if (value >= least && value <= most) return;
  throw Error(ErrorKind::bad_input,
              fmt::format("look.{}: expected a number within [{}, {}], got {}", name, least, most, value),
              "leave it out for a cloud of water droplets");
}

// Mean cosines beyond this are a beam, which no sum over directions resolves.
constexpr double greatest_g = 0.999;

// Jendersie & d'Eon 2023, eqs. 4 to 7, d in um.
std::vector<PhaseLobe> droplet_lobes(double d) {
  const double g_forward = std::exp(-0.0990567 / (d - 1.67154));
  const double g_draine = std::exp(-2.20679 / (d + 3.91029) - 0.428934);
  const double alpha = std::exp(3.62489 - 8.29288 / (d + 5.52825));
  const double draine_share = std::exp(-0.599085 / (d - 0.641583) - 0.665888);
  return {{1.0 - draine_share, g_forward, 0.0}, {draine_share, g_draine, alpha}};
}

std::vector<PhaseLobe> lobes_of(const CloudLook& look) {
  switch (look.phase) {
    case PhaseKind::rayleigh:
      return {{1.0, 0.0, 1.0}};
    case PhaseKind::henyey_greenstein:
      require_within("g", look.g, -greatest_g, greatest_g);
      return {{1.0, look.g, 0.0}};
    case PhaseKind::double_henyey_greenstein:
      require_within("g", look.g, -greatest_g, greatest_g);
      require_within("g_back", look.g_back, -greatest_g, greatest_g);
      require_within("forward_share", look.forward_share, 0.0, 1.0);
      return {{look.forward_share, look.g, 0.0}, {1.0 - look.forward_share, look.g_back, 0.0}};
    case PhaseKind::mie_droplet:
      require_within("droplet_um", look.droplet_um, smallest_droplet_um, largest_droplet_um);
      return droplet_lobes(look.droplet_um);
  }
  throw Error(ErrorKind::bad_input, "look.phase: expected one of the four kinds of phase functions");
}

// Integral of 1 + alpha c^2 over the lobe of Henyey and Greenstein, whose second Legendre moment is g^2.
double lobe_norm(const PhaseLobe& lobe) {
  return 1.0 + lobe.alpha * (1.0 + 2.0 * lobe.g * lobe.g) / 3.0;
}

}  // namespace

PhaseFunction::PhaseFunction(const CloudLook& look) : lobes_(lobes_of(look)) {}

double PhaseFunction::operator()(double cosine) const {
  double sum = 0.0;
  for (const PhaseLobe& lobe : lobes_) {
    // (1 - g)^2 + 2 g (1 - c) keeps the digits that 1 + g^2 - 2 g c loses near the forward peak.
    const double base = (1.0 - lobe.g) * (1.0 - lobe.g) + 2.0 * lobe.g * (1.0 - cosine);
    sum += lobe.weight * (1.0 - lobe.g * lobe.g) * (1.0 + lobe.alpha * cosine * cosine) /
           (lobe_norm(lobe) * base * std::sqrt(base));
  }
  return sum / (4.0 * std::numbers::pi);
}

double PhaseFunction::mean_cosine() const {
  return moments(2)[1];
}

std::vector<double> PhaseFunction::moments(int count) const {
  return moments_of_lobes(count, -1.0);
}

std::vector<double> PhaseFunction::forward_moments(int count) const {
  return moments_of_lobes(count, 0.0);
}

std::vector<double> PhaseFunction::moments_of_lobes(int count, double least_g) const {
  const auto size = static_cast<std::size_t>(count);
  std::vector<double> sum(size, 0.0);
  for (const PhaseLobe& lobe : lobes_) {
    if (!(lobe.g > least_g)) continue;
    std::vector<double> plain(size + 2), times_cosine(size + 1);
    double power = 1.0;
    for (double& moment : plain) {
      moment = power;
      power *= lobe.g;
    }
    // c P_l = ((l + 1) P_(l+1) + l P_(l-1)) / (2 l + 1), of which c^2 p takes two rounds.
    const auto raised = [](const std::vector<double>& from, std::size_t l) {
      const auto n = static_cast<double>(l);
      return ((n + 1.0) * from[l + 1] + (l > 0 ? n * from[l - 1] : 0.0)) / (2.0 * n + 1.0);
    };
    for (std::size_t l = 0; l <= size; ++l) times_cosine[l] = raised(plain, l);
    for (std::size_t l = 0; l < size; ++l)
      sum[l] += lobe.weight * (plain[l] + lobe.alpha * raised(times_cosine, l)) / lobe_norm(lobe);
  }
  return sum;
}

double PhaseFunction::henyey_greenstein_cosine(double g, double uniform) {
  const double s = 2.0 * uniform - 1.0;
  if (std::abs(g) < 1e-3) return s + 1.5 * g * (1.0 - s * s);  // its series, exact to g^2
  const double part = (1.0 - g * g) / (1.0 + g * s);
  return std::fmin(1.0, std::fmax(-1.0, (1.0 + g * g - part * part) / (2.0 * g)));
}

DeltaScaling delta_scaling(const PhaseFunction& phase) {
  const double f = phase.forward_moments(3)[2];
  return {f, (phase.mean_cosine() - f) / (1.0 - f)};
}

}  // namespace offing::clouds
