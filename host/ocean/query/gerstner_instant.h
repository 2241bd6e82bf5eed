#pragma once

#include <span>
#include <vector>

#include "host/ocean/surface/gerstner_waves.h"

namespace offing::ocean {

/// What Gerstner waves and rings do at one label.
struct GerstnerValues {
  double displacement_x_m = 0.0, displacement_y_m = 0.0, displacement_z_m = 0.0;
  double slope_x = 0.0, slope_z = 0.0;                             ///< dh/dx, dh/dz at the label
  double gradient_xx = 0.0, gradient_xz = 0.0, gradient_zz = 0.0;  ///< d dx/dx, d dx/dz, d dz/dz
};

/// Velocity of a particle, m/s.
struct ParticleVelocity {
  double x_mps = 0.0, y_mps = 0.0, z_mps = 0.0;
};

/// The Gerstner waves of a sea at one time, for single labels: the sums of GerstnerSurface in double
/// precision, with the frequencies of the same clock, all waves in full.
class GerstnerInstant {
 public:
  /// Waves and rings shorter than `min_wavelength_m` are left out; Q stays that of the whole sea. Throws
  /// Error(bad_input) for a sea or a time (beyond 1e8 s) out of range.
  GerstnerInstant(const GerstnerSea& sea, double time_s, double min_wavelength_m = 0.0);

  /// `shares` scale the waves, in the order of waves(); all count in full where it is empty.
  GerstnerValues at(double x_m, double z_m, std::span<const double> shares = {}) const;
  /// Of the particle `depth_m` below the moving surface, by linear theory with that depth measured from it
  /// (Wheeler stretching), as the cascades' (Ocean::read_velocity()); rings add nothing.
  ParticleVelocity velocity(double x_m, double z_m, double depth_m,
                            std::span<const double> shares = {}) const;
  /// Dynamic pressure over density and gravity at that depth below the moving surface, m: each wave's height
  /// times cosh k(D-d) / cosh kD, each ring's times e^{-kd}. It is the height at depth 0.
  double pressure_head_m(double x_m, double z_m, double depth_m, std::span<const double> shares = {}) const;

  /// A wave as it stands now: A cos(kx x + kz z + phase).
  struct Wave {
    double amplitude_m, kx_radpm, kz_radpm, phase_rad;
    double omega_radps;  ///< as the clock holds it
  };
  const std::vector<Wave>& waves() const { return waves_; }
  /// A ring as it stands now; its formula is in kernels/ocean/gerstner_surface.cl.
  struct Ring {
    double centre_x_m, centre_z_m, wavelength_m, radius_m, amplitude_m, phase_rad;
  };
  const std::vector<Ring>& rings() const { return rings_; }
  /// Q.
  double horizontal_scale() const { return horizontal_scale_; }

 private:
  static void add_ring(const Ring& ring, double x_m, double z_m, GerstnerValues& values);

  std::vector<Wave> waves_;
  std::vector<Ring> rings_;
  double horizontal_scale_;
  double water_depth_m_;
};

}  // namespace offing::ocean
