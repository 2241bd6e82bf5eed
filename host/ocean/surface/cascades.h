#pragma once

#include <span>
#include <vector>

#include "host/ocean/spectrum/sea_spectrum.h"

namespace offing::ocean {

/// One periodic patch of sea and the band of wavenumbers that it carries: k_min <= |K| < k_max. The bands of
/// a sea's cascades do not overlap, so that no wave is counted twice.
struct Cascade {
  double patch_length_m = 0.0;
  double k_min_radpm = 0.0;
  double k_max_radpm = 0.0;
};

/// Wavenumber up to which a patch of n samples resolves all directions: (n/2 - 1) * 2 pi / L. The Nyquist row
/// and column carry nothing (O2).
double resolved_wavenumber_radpm(double patch_length_m, int size);

/// Variance, m^2, of the waves that are too long for any mode of this patch: those within the cell of K = 0,
/// |kx| and |kz| < pi / L, down to k_split. To 1e-3 of itself.
double still_cell_variance_m2(const SeaSpectrum& spectrum, double patch_length_m, double split_radpm = 0.0);

/// Cascades for these patch lengths (1 to 4, any order; sorted from long to short): each band ends where its
/// patch stops resolving and the next begins there. The first begins at k_split, below which Gerstner waves
/// carry the sea; without them that is 0, whose mode K = 0 carries nothing. Throws Error(bad_input) for a
/// size, count or length out of range (0.01 ... 1e6 m), two equal lengths, or a patch that resolves only
/// waves longer than those of k_split.
std::vector<Cascade> cascades_from_patches(std::span<const double> patch_lengths_m, int size,
                                           double split_radpm = 0.0);

/// Share of m0 that these cascades hold of a spectrum, with the Gerstner waves below the first. Waves longer
/// than the first patch count as lost.
double share_in_cascades(const SeaSpectrum& spectrum, std::span<const Cascade> cascades);

/// Patch lengths that suit the spectrum. The longest holds about 20 wavelengths of the peak, 8 of the long
/// waves (1 % of m0 is longer) and 2 of the longest (0.1 %), and enough independent waves that Hs of one
/// realisation scatters by about 2 % (up to 64 wavelengths of the peak). Shorter ones follow, by equal
/// factors, until 99.9 % of m0 is resolved or `max_count` (1 ... 4) is reached. Where `size` is too small for
/// both ends, the longest patch shrinks until the bands hold the most energy. Lengths have three significant
/// digits and no small common multiple, so that the tiles of several cascades do not line up. All of this
/// holds for the waves from k_split on; the others are left to Gerstner waves. Throws Error(bad_input) for a
/// size or count out of range, or no waves from k_split on.
std::vector<Cascade> choose_cascades(const SeaSpectrum& spectrum, int size, int max_count = 3,
                                     double split_radpm = 0.0);

}  // namespace offing::ocean
