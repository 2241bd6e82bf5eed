#pragma once

#include <complex>
#include <vector>

#include "host/ocean/wakes/wake_window.h"

namespace offing::ocean {

/// A wake window in double precision, with the modes summed one by one: O(n^4) a step, for small windows that
/// do not scroll and have their first sample at column and row 0 of the world.
class WakeReference {
 public:
  explicit WakeReference(const WakeParameters& parameters);

  /// One step under this displaced depth, [n][n] m.
  void step(const std::vector<double>& displaced_m);

  std::vector<double> height_m, second_m;  ///< as WakeState has them

 private:
  using Modes = std::vector<std::complex<double>>;
  Modes transformed(const Modes& values, double sign) const;
  void step_dispersive(const std::vector<double>& displaced_m);
  void step_verlet(const std::vector<double>& displaced_m, int parts);
  double kept(int place, double part_s) const;

  WakeParameters parameters_;
};

/// The depth at which a hull presses the cells of that window: its mean over two cells by two, weighted by a
/// tent, by six points along either axis.
std::vector<double> reference_displaced_m(const WakeParameters& parameters, const WakeHull& hull);

/// The sum of the squares of both fields: twice the energy of `dispersive` over density, gravity and a cell.
double wake_energy(const WakeState& state);

}  // namespace offing::ocean
