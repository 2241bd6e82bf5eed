#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/base/wave_spectrum.h"
#include "host/ocean/spectrum/sea_spectrum.h"
#include "host/ocean/surface/gerstner_choice.h"
#include "host/ocean/surface/ocean.h"
#include "host/scene/model/scene.h"

namespace offing::scene {

/// What a simulation needs of a scene: no file names, no defaults left to choose.
struct Sea {
  std::optional<WaveSpectrum> measured;  ///< the record that `spectrum` was made from, if it was measured
  ocean::SeaSpectrum spectrum;
  /// wind_of_sea(), or of wind waves by height and period without a wind of their own the wind that makes
  /// such waves (fetch_laws.h).
  ocean::Wind wind;
  ocean::OceanParameters parameters;  ///< with its cascades and Gerstner waves
  /// Which waves are Gerstner waves, of the seed of `parameters`; absent where the cascades carry all.
  std::optional<ocean::GerstnerChoice> gerstner_choice;
  std::size_t irregular_swells = 0;         ///< in the spectrum beside the wind's or measured waves
  std::vector<ocean::GerstnerWave> swells;  ///< beside the spectrum
  std::vector<ocean::Raindrop> raindrops;   ///< beside the spectrum

  /// Whether waves are not in the cascades.
  bool has_gerstner_waves() const { return gerstner_choice || !swells.empty() || !raindrops.empty(); }
};

/// That of [wind], where the ocean names no wind of its own.
ocean::Wind wind_of_sea(const Scene& scene);

enum class Warnings { logged, left_out };

/// Reads the measured spectrum if there is one, makes the spectrum and chooses cascades and Gerstner waves;
/// irregular swells join the spectrum, others and raindrops come beside.
/// Warnings are those of parameters that were set and do not matter (unused_parameters()),
/// steepness_warning() and height_warning().
///
/// Throws Error(bad_input) for a scene of ground alone.
///
/// Water depth is the scene's, else that of the measured record, else infinite. Throws Error(bad_input) for a
/// spectrum file that cannot be read, a record that it does not have, or values that do not go together.
Sea prepare_sea(const Scene& scene, Warnings warnings = Warnings::logged);

/// Throws Error(bad_input), with the place that names it, for a file of the scene that is not there: `key` of
/// the scene names it, `kind` says what it should be.
void require_file(const Scene& scene, const char* key, const std::string& file, const char* kind);

/// One line where the Gerstner waves and swells of a scene are so steep that their choppiness is limited
/// (horizontal_scale()), or a raindrop's ring is steeper than water stays whole; else empty.
std::string steepness_warning(const Scene& scene, const ocean::GerstnerSea& gerstner_waves);

/// One line where the cascades lack more than 1 % of a height that was asked for; else empty.
std::string height_warning(const Scene& scene, const Sea& sea);

/// The swells of a scene that are one wave each, in water of this dispersion. Throws Error(bad_input) for a
/// period whose wave is longer or shorter than a swell can be.
std::vector<ocean::GerstnerWave> swells_of(const Scene& scene, const ocean::Dispersion& dispersion);

/// The Gerstner waves of a sea of this seed, with the cascades' choppiness and loop; its swells, which no
/// seed changes; its raindrops.
ocean::GerstnerSea gerstner_waves_of(const Sea& sea, std::uint64_t seed);

/// One line on where the waves come from: "jonswap, wind 10 m/s" or "measured, 41010, 2020-06-08T03:50Z".
std::string spectrum_name(const Scene& scene, const Sea& sea);

}  // namespace offing::scene
