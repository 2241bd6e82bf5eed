#pragma once

#include <cstdint>
#include <vector>

#include "host/ocean/query/water_point.h"
#include "host/ocean/spectrum/dispersion.h"

namespace offing::ocean {

/// How the waves of a wake window move.
enum class WakeMethod {
  dispersive,  ///< each mode at the omega(k) of water: the wake of a ship
  verlet,      ///< the wave equation, all waves at one speed (O14 of docs/sources.md): a Mach cone
};

/// Rain on a wake window.
struct WakeRain {
  double drops_per_m2s = 0.0;  ///< at most one a step on each square of 8 x 8 cells
  double hollow_m = 0.01;      ///< about the depth of the hollow that a drop leaves, 1.5 cells in radius
  std::uint64_t seed = 1;
};

/// Everything that defines a wake window.
struct WakeParameters {
  WakeMethod method = WakeMethod::dispersive;
  int cells = 256;          ///< n, along a side: a power of two, 16 ... 4096
  double length_m = 128.0;  ///< of a side; its border absorbs waves up to an eighth of it
  double step_s = 1.0 / 120.0;
  Dispersion dispersion = {};  ///< of `dispersive`
  double speed_mps = 5.0;      ///< of all waves of `verlet`, c
  WakeRain rain = {};

  double cell_m() const { return length_m / cells; }
};

/// A hull as what it presses: its displaced depth is that of an ellipsoid's lower half, or a bell.
struct WakeHull {
  enum class Shape { ellipsoid, gaussian } shape = Shape::ellipsoid;
  double x_m = 0.0, z_m = 0.0;           ///< its middle
  double heading_rad = 0.0;              ///< of its bow, from +x toward +z
  double length_m = 10.0, beam_m = 3.0;  ///< of the waterline; a bell is down to 1/e there
  double draught_m = 0.5;                ///< 0 ... 100

  /// Of water, m^3.
  double displaced_volume_m3() const;
};

/// What a wake window is told of a time.
struct WakeForcing {
  WaterPoint centre = {};  ///< of the window
  std::vector<WakeHull> hulls = {};
};

/// Throws Error(bad_input) that names what is out of range.
void require_valid_wake(const WakeParameters& parameters);

}  // namespace offing::ocean
