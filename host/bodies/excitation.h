#pragma once

#include <vector>

#include "host/base/sea/hydrodynamic_data.h"
#include "host/base/sea/modal_sea.h"
#include "host/bodies/floating_body.h"
#include "kernels/shared/bodies.h"

namespace offing::bodies {

/// What linear waves do to a hull besides the hydrostatic pressure below their surface, which
/// bodies/body_advance.cl integrates: the excitation of its data, less that of the pressure on the hull at
/// rest. It is what pressures lose with depth, and what the hull scatters.
struct WaveTable {
  double step_radps = 1.0;  ///< from one frequency to the next, the first one being this
  /// Of a wave of 1 m whose crest is at the mass centre, N and N m about it in the hull's axes, as amplitudes
  /// of e^(-i omega t): [BODY_WAVE_DIRECTIONS][BODY_WAVE_FREQUENCIES][BODY_WAVE_FLOATS].
  std::vector<float> values;
};

/// Of a body with hydrodynamic data; zeros for data without excitation. Frequencies are those that waves of
/// their length have on deep water. Throws Error(bad_input) that names the data for tables of another size.
WaveTable wave_table(const FloatingBody& body, double density_kgpm3, double gravity_mps2);

/// The force of the hydrostatic pressure below a small wave of 1 m on the hull at rest, linear over each
/// face, about the mass centre.
HullWrench hydrostatic_excitation(const FloatingBody& body, double wavenumber_radpm, double direction_rad,
                                  double density_kgpm3, double gravity_mps2);

/// The waves that carry 99.9 % of the energy of those of a sea's patches, at most 16,384, and all others.
std::vector<SeaMode> leading_modes(const ModalSea& sea);

/// As a device sums them: at the question number 0 it is time_s, and questions are this far apart.
std::vector<BodyWave> device_waves(const std::vector<SeaMode>& modes, double time_s, double question_s,
                                   double gravity_mps2);

}  // namespace offing::bodies
