#pragma once

#include <array>
#include <cstdint>

#include "host/ocean/query/shoaling.h"
#include "host/ocean/spectrum/dispersion.h"
#include "kernels/shared/swash_params.h"

namespace offing::ocean {

/// What a shore needs to know of the waves that come in.
struct OpenSea {
  double height_m = 0.0;          ///< significant
  double wavenumber_radpm = 1.0;  ///< of the peak, in deep water
  double direction_rad = 0.0;     ///< of travel
};

/// Water that waves wash up and down the shores of a sea, all of one slope: the height of its edge above
/// still water. Set-up, swash and the height that two of a hundred waves reach follow Stockdon, Holman,
/// Howd & Sallenger 2006 (equations 10 to 12, 19), from the height and the peak period of the open sea. The
/// edge is a sum of six waves near the peak frequency, which travel with the sea, and two slow ones of
/// the surf beat. For pictures only: the waves of the sea do not depend on it.
class Swash {
 public:
  /// `direction_rad` is that of the sea's travel. There is none where the sea has no waves.
  Swash(const Dispersion& sea, const SeaBands& bands, double beach_slope, double direction_rad,
        std::uint64_t seed);

  const OpenSea& sea() const { return sea_; }
  double setup_m() const { return setup_m_; }
  /// What two of a hundred waves reach.
  double reach_m() const { return reach_m_; }
  /// Greatest distance of the edge from still water.
  double farthest_m() const;
  /// Height of the edge.
  double level_m(double x_m, double z_m, double time_s) const;
  /// What shaders and kernels take, about a place and a time.
  SwashParams at(double x_m, double z_m, double time_s) const;

 private:
  struct Wave {
    double amplitude_m, kx_radpm, kz_radpm, omega_radps, phase_rad;
  };
  /// Phase of a wave.
  static double turn(const Wave& wave, double x_m, double z_m, double time_s) {
    return wave.omega_radps * time_s - wave.kx_radpm * x_m - wave.kz_radpm * z_m + wave.phase_rad;
  }

  std::array<Wave, SWASH_WAVES> waves_{};
  OpenSea sea_;
  double setup_m_ = 0.0, reach_m_ = 0.0, period_s_ = 0.0;
};

}  // namespace offing::ocean
