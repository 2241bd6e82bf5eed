#pragma once

#include <complex>
#include <vector>

#include "host/ocean/surface/ocean.h"

namespace offing::ocean {

/// [n][n], row-major, row = z or kz, column = x or kx; K = 0 at [0][0], index i >= n/2 standing for i - n.
using ComplexField = std::vector<std::complex<double>>;
using RealField = std::vector<double>;

/// The waves' frequencies: those of the dispersion relation, or the nearest ones that the phase clock holds.
enum class Frequencies { exact, of_clock };

/// One cascade's fields as Ocean reads them, by definition and in double precision.
struct ReferenceSurface {
  RealField displacement_x, displacement_y, displacement_z;
  RealField slope_x, slope_z;
  RealField gradient_xx, gradient_xz, gradient_zz;
  RealField jacobian, jacobian_min_eigenvalue;
};

struct ReferenceVelocity {
  RealField x, y, z;
};

/// A spectral sea as O1-O7 of docs/sources.md define it, summed wave by wave in double precision on the host:
/// random amplitudes, evolution, every field's factor and the transform are written again, without the
/// device's packing, symmetry or phase clock. Only the expected variances are given.
class OceanReference {
 public:
  /// variance [cascades][n][n] m^2, of Ocean::mode_variance().
  OceanReference(const Dispersion& dispersion, const OceanParameters& parameters,
                 const std::vector<std::vector<float>>& variance);

  ReferenceSurface surface(int cascade, double time_s, Frequencies frequencies) const;
  ReferenceVelocity velocity(int cascade, double time_s, double depth_m, Frequencies frequencies) const;
  /// h0(K), m.
  const ComplexField& initial(int cascade) const { return initial_[static_cast<std::size_t>(cascade)]; }
  /// omega(K) as the clock holds it, rad/s, for wave (column, row).
  double omega_radps(int cascade, int column, int row, Frequencies frequencies) const;
  /// Of all cascades' waves.
  double fastest_hz() const;

 private:
  struct Evolved {
    ComplexField height, rise;  // h(K, t) in m, its rate of change in m/s
  };
  Evolved evolved(int cascade, double time_s, Frequencies frequencies) const;
  template <class Factor>
  RealField field(int cascade, const ComplexField& spectrum, Factor factor) const;

  Dispersion dispersion_;
  OceanParameters parameters_;
  std::vector<ComplexField> initial_;
};

/// sum over K of spectrum(K) e^{+i K X}, or over X of field(X) e^{-i K X}; size a power of two.
ComplexField inverse_transform(const ComplexField& spectrum, int size);
ComplexField forward_transform(const ComplexField& field, int size);

}  // namespace offing::ocean
