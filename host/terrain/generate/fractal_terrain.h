#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "host/terrain/generate/gullies.h"

namespace offing::terrain {

/// A square of generated terrain. Heights are a function of the place: more posts over the same side show the
/// same ground more finely.
struct FractalParameters {
  int posts = 1025;  ///< a side, 2 ... 65536
  double side_m = 20'000.0;
  double relief_m = 1500.0;   ///< about what lies between lowest and highest
  double mean_m = 600.0;      ///< about the middle between them
  double longest_m = 9000.0;  ///< wavelength of the largest hills
  double roughness = 0.5;     ///< height of each octave over that of the one before, 0.2 ... 0.8
  double erosion = 0.0;       ///< 0 none ... 1: how deep gullies are cut into slopes
  /// An island: the ground sinks by relief_m from its middle to this distance, as it is where absent.
  std::optional<double> island_radius_m = {};
  std::uint64_t seed = 1;
};

/// Throws Error(bad_input) that names what is out of range.
void require_valid(const FractalParameters& parameters);

/// Hills of ever shorter wavelengths: gradient noise (Perlin 2002, Improving noise) whose octaves are weaker
/// where those before are steep (Musgrave in Ebert et al. 2003, Texturing and modeling, chapter 16), so that
/// valleys are smooth and slopes rugged. Into the slopes gullies are cut, the wide ones first, each kind
/// along the slopes that those before have left. Octaves end at two posts a wavelength, gullies at four a
/// width.
class FractalTerrain {
 public:
  /// Throws what require_valid() throws.
  explicit FractalTerrain(const FractalParameters& parameters);

  /// Heights [posts] m of a row, 0 at the north edge. Rows in order are quickest; any order gives the same.
  void fill_row(int row, std::span<float> heights_m);

 private:
  struct Gradient {
    double x, z;
  };
  struct Octave {
    double wavelength_m, height_m;
    int index, top = -1;                 ///< of the rows of the lattice that are kept
    std::vector<Gradient> upper, lower;  ///< rows top and top + 1
  };
  double sinking_m(double x_m, double z_m) const;
  void fill_lattice(Octave& octave, int lattice_row, std::vector<Gradient>& gradients) const;

  FractalParameters parameters_;
  std::vector<Octave> octaves_;
  std::vector<Gullies> gullies_;
};

/// Rows of generated terrain, on all cores.
class RowMakers {
 public:
  /// Throws what require_valid() throws.
  explicit RowMakers(const FractalParameters& parameters);

  int rows_at_once() const { return rows_a_maker * static_cast<int>(makers_.size()); }

  /// Heights [rows][posts] m of the rows from `first` on, as many as are made at once or are left; valid
  /// until the next call.
  std::span<const float> make(int first);

 private:
  static constexpr int rows_a_maker = 16;
  int posts_;
  std::vector<FractalTerrain> makers_;
  std::vector<float> heights_m_;
};

}  // namespace offing::terrain
