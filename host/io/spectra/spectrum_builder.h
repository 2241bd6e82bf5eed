#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/wave_spectrum.h"
#include "host/io/spectra/maximum_entropy.h"

namespace offing::spectra {

/// Throws Error(bad_input) naming `where` unless the frequencies (Hz) are at least two, positive and strictly
/// increasing.
void check_frequencies(std::span<const double> frequencies_hz, std::string_view where);

/// Throws Error(bad_input) naming `where` unless every variance density is finite and >= 0.
void check_densities(std::span<const double> densities, std::string_view where);

/// The directions of a model's file, put in the order and the even spacing that WaveSpectrum wants.
///
/// Evenly spaced directions over the whole circle, in any order and off by no more than three printed digits,
/// keep their number; a repeated end (0 and 360 degrees) is dropped. Anything else (a sector, uneven bins) is
/// laid on an even grid of 360 directions, each input bin reaching half-way to its neighbours,
/// its energy conserved.
class DirectionGrid {
 public:
  /// directions_rad [n]: of travel, as WaveSpectrum has them, any order and turn. Throws Error(bad_input)
  /// naming `where` if fewer than two differ.
  DirectionGrid(std::vector<double> directions_rad, std::string_view where);

  /// [nd] as WaveSpectrum::directions_rad.
  const std::vector<double>& directions_rad() const { return directions_rad_; }

  /// density [n] in the constructor's order, m^2/Hz/rad, >= 0. Writes D(theta) to spreading [nd] and returns
  /// E, m^2/Hz. If E is 0, spreading is left all 0.
  double spread(std::span<const double> density, std::span<double> spreading) const;

 private:
  /// `share` radians of input bin `source` lie in output bin `target`.
  struct Deposit {
    std::size_t source;
    std::size_t target;
    double share_rad;
  };

  void keep_even(const std::vector<std::size_t>& order, double first_rad);
  void resample(const std::vector<double>& angles, const std::vector<std::size_t>& order);

  std::vector<double> directions_rad_;
  std::vector<Deposit> deposits_;
};

/// What is known of one frequency's spreading.
enum class RowState { known, unknown };

/// Fills the rows of spreading whose state is unknown from the nearest frequency with a known row (the lower
/// one if two are as near), so that a consumer who interpolates in frequency blends in nothing foreign. If
/// none is known, all rows become uniform. states [nf].
void fill_unknown_rows(WaveSpectrum& spectrum, std::span<const RowState> states);

/// A model's record: density [nf][nd of the file], m^2/Hz/rad, on `grid`. Throws Error(bad_input) naming
/// `where` on a negative or non-finite value. The other members of `spectrum` stay as they are.
void set_density(WaveSpectrum& spectrum, std::span<const double> density, const DirectionGrid& grid,
                 std::string_view where);

/// An instrument's frequency: the moments it reported, if any, in decreasing completeness.
struct ReportedMoments {
  /// None, the first moment, or the first and the second.
  enum class Kind { none, first, both };
  Kind kind = Kind::none;
  DirectionalMoments moments;
};

/// Spreading from moments [nf]: maximum entropy where both are known, cos^(2s) where only the first is, the
/// nearest frequency's where none is. If no frequency has any, the spectrum is left without directions.
void set_moments(WaveSpectrum& spectrum, std::span<const ReportedMoments> moments);

}  // namespace offing::spectra
