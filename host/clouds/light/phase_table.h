#pragma once

#include <vector>

#include "host/clouds/light/phase_function.h"

namespace offing::clouds {

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

}  // namespace offing::clouds
