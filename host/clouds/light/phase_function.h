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

}  // namespace offing::clouds
