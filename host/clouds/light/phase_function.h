#pragma once

#include <vector>

#include "host/clouds/shape/cloud_parameters.h"

namespace offing::clouds {

/// Least mean cosine that the light of particles is for: what is thrown back again and again does not
/// diffuse, and is shown up to 1.7 times too bright at -0.9.
inline constexpr double least_mean_cosine = -0.5;

/// One lobe: p(c) = (1 - g^2) (1 + alpha c^2) / (4 pi (1 + alpha (1 + 2 g^2) / 3) (1 + g^2 - 2 g c)^(3/2)), c
/// the cosine of the angle between the ways of light before and after (Draine 2003, "Scattering by
/// interstellar dust grains", eq. 8). alpha = 0 is Henyey & Greenstein 1941; g = 0, alpha = 1 is Rayleigh.
struct PhaseLobe {
  double weight = 1.0;
  double g = 0.0;
  double alpha = 0.0;
};

/// Where light goes that a droplet scatters: a sum of at most two lobes, 1/sr, whose integral over the sphere
/// is 1. Droplets of water: the fit of Jendersie & d'Eon 2023, "An approximate Mie scattering function for
/// fog and cloud rendering", eqs. 4 to 7, diameters of 5 ... 50 um.
class PhaseFunction {
 public:
  /// Throws Error(bad_input) unless -1 < g < 1 and -1 < g_back < 1, forward_share is within 0 ... 1 and
  /// droplet_um within smallest_droplet_um ... largest_droplet_um, of those that the kind reads.
  explicit PhaseFunction(const CloudLook& look);

  const std::vector<PhaseLobe>& lobes() const { return lobes_; }
  /// 1/sr.
  double operator()(double cosine) const;
  double mean_cosine() const;
  /// Legendre moments b_l = 2 pi * integral of p P_l, l < count: b_0 = 1, b_1 the mean cosine; g^l of a
  /// Henyey-Greenstein lobe.
  std::vector<double> moments(int count) const;
  /// What of these is of lobes that peak forward, with g above 0.
  std::vector<double> forward_moments(int count) const;

  /// A cosine with this density, from numbers uniform in (0, 1) that `next` returns one after the other.
  template <typename Next>
  double sample(Next&& next) const {
    std::size_t i = 0;
    for (double at = next(); i + 1 < lobes_.size() && at >= lobes_[i].weight; ++i) at -= lobes_[i].weight;
    // Draine's lobe is that of Henyey and Greenstein times 1 + alpha c^2: by rejection.
    for (;;) {
      const double cosine = henyey_greenstein_cosine(lobes_[i].g, next());
      if (lobes_[i].alpha == 0.0) return cosine;
      if (next() * (1.0 + lobes_[i].alpha) < 1.0 + lobes_[i].alpha * cosine * cosine) return cosine;
    }
  }

 private:
  static double henyey_greenstein_cosine(double g, double uniform);
  std::vector<double> moments_of_lobes(int count, double least_g) const;

  std::vector<PhaseLobe> lobes_;
};

/// A phase function without its forward peak (Joseph, Wiscombe & Weinman 1976): a share f of scattered light
/// goes on as if it had not been scattered, the rest has the mean cosine g' = (g - f) / (1 - f). Lobes that
/// peak backward have no forward peak: they stay in the rest.
struct DeltaScaling {
  double forward_share = 0.0;       ///< f, the second Legendre moment of forward lobes: g^2 of one of Henyey
                                    ///< and Greenstein
  double scaled_mean_cosine = 0.0;  ///< g'
};

DeltaScaling delta_scaling(const PhaseFunction& phase);

/// Where light goes in its first scattering in the scaled medium, with the aureole that all forward
/// scatterings along a way of optical depth t add to it:
///   P(c, t) = sum of (2 l + 1) / (4 pi) c_l(t) P_l(c),
///   c_l = (e^((b_l - f) t) - e^(-f t)) / t for l >= 2, and c_l = b_l - f + (1 - e^(-f t)) / t for l < 2,
/// b_l the moments of the phase function, for l >= 2 of its forward lobes: small-angle theory (Wentzel 1922;
/// Snyder & Scott 1949) for the peak, the first order for the rest, whose further orders diffusion has. P(c,
/// 0) is the phase function itself. Away from the forward direction, where a sum of so few smooth terms would
/// go below zero, the phase function stays (Nakajima & Tanaka 1988, "Algorithms for radiative intensity
/// calculations", TMS). Multiplied by e^(-(1 - f) t) it is light that reaches the eye along a way that bends
/// once. [CLOUD_PHASE_DEPTHS][CLOUD_PHASE_ANGLES] 1/sr, coordinates in kernels/shared/cloud_light_params.h.
std::vector<float> phase_table(const PhaseFunction& phase);

/// Share of light from straight above that a slab of droplets lets through which absorb nothing, in the
/// delta-Eddington approximation: (5 - exp(-(1 - f) t)) / (4 + 3 (1 - g) t).
double slab_transmittance(const PhaseFunction& phase, double optical_depth);

}  // namespace offing::clouds
