#pragma once

#include <array>
#include <span>
#include <vector>

#include "host/ocean/ocean.h"
#include "host/ocean/trochoid_instant.h"

namespace offing::cli {

/// One cascade as the preview sees it: Ocean::read_surface() and Ocean::read_foam(), or no foam. Only used
/// while the PreviewSurface is made.
struct PreviewCascade {
  double patch_length_m = 0.0;
  const ocean::SurfaceFields* surface = nullptr;
  std::span<const float> foam;  ///< [n][n] 0 ... 1, or empty
};

/// The sea around a label, averaged over a footprint.
struct SurfaceSample {
  float displacement_x = 0, displacement_y = 0, displacement_z = 0;  ///< m
  float slope_x = 0, slope_z = 0;                                    ///< of the displaced surface
  float variance_xx = 0, variance_xz = 0, variance_zz = 0;           ///< of the slopes that the average hides
  float foam = 0;                                                    ///< expected coverage, 0 ... 1
};

/// The sum of all cascades and trochoids at any place and scale. Each cascade is averaged over 1, 2, 4 ...
/// samples beforehand, with the second moments of its slopes, so that waves smaller than a pixel turn into
/// roughness (Bruneton, Neyret, Holzschuch 2010, section 4), and so do trochoids, and the picture shows no
/// trace of the sample grid.
class PreviewSurface {
 public:
  /// Cascades of more than 1024 x 1024 samples are averaged down to that. Throws Error(bad_input) if there is
  /// no cascade, a patch length is not positive or fields do not have [n][n] values.
  PreviewSurface(std::span<const PreviewCascade> cascades, const ocean::FoamParameters& foam,
                 const ocean::TrochoidInstant& trochoids = {{}, 0.0});

  /// Displacement, m, at rest label x, z averaged over about `footprint_m`.
  std::array<float, 3> displacement(double x_m, double z_m, float footprint_m) const;

  SurfaceSample sample(double x_m, double z_m, float footprint_m) const;

  /// Standard deviation of the elevation, m.
  float elevation_deviation_m() const { return elevation_deviation_m_; }
  /// Largest horizontal displacement of any sample, m.
  float largest_shift_m() const { return largest_shift_m_; }

 private:
  /// What a texel holds: means over the texel, and covariances of what the means hide (trace is gxx + gzz).
  enum Quantity {
    dx,
    dy,
    dz,
    sx,
    sz,
    gxx,
    gxz,
    gzz,
    var_xx,
    var_xz,
    var_zz,
    var_trace,
    foam_mean,
    quantities = 16
  };
  using Texel = std::array<float, quantities>;
  struct Level {
    int size = 0;
    int scale = 1;              ///< samples of the cascade along a texel
    std::vector<Texel> texels;  ///< [size][size], row = z
  };
  struct Pyramid {
    double sample_m = 0.0;
    std::vector<Level> levels;  ///< from fine to coarse
  };

  static Level finest_level(const PreviewCascade& cascade);
  static Texel mean_of(const PreviewCascade& cascade, int first_column, int first_row, int count);
  static Level coarser_level(const Level& fine);
  template <int quantity_count>
  static void add_level(const Level& level, double column, double row, float weight, Texel& sums);
  void add_trochoids(double x_m, double z_m, float footprint_m, Texel& sums) const;
  template <int quantity_count>
  Texel filtered(double x_m, double z_m, float footprint_m) const;

  std::vector<Pyramid> pyramids_;
  ocean::TrochoidInstant trochoids_;
  ocean::FoamParameters foam_;
  float elevation_deviation_m_ = 0.0f;
  float largest_shift_m_ = 0.0f;
};

}  // namespace offing::cli
