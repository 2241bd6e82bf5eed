#pragma once

#include <cstdint>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "host/base/wave_spectrum.h"
#include "host/ocean/spectrum/spectrum_parameters.h"
#include "host/ocean/surface/gerstner_waves.h"
#include "host/ocean/surface/ocean.h"
#include "host/ocean/surface/water_optics.h"
#include "host/scene/model/wake_scene.h"

namespace offing::scene {

/// [world]
struct WorldSection {
  std::uint64_t seed = 1;      ///< of the sea
  double latitude_rad = 0.0;   ///< of the origin, north positive
  double longitude_rad = 0.0;  ///< of the origin, east positive
  double sea_level_m = 0.0;    ///< of the still sea, in the heights of the scene

  bool operator==(const WorldSection&) const = default;
};

/// [time]
struct TimeSection {
  double frames_per_second = 24.0;
  double start_s = 0.0;                      ///< first frame
  double end_s = 2.0;                        ///< frames stop before this time
  std::optional<double> loop_period_s = {};  ///< the sea repeats exactly after this time

  bool operator==(const TimeSection&) const = default;
};

/// Whether waves feel the ground of a scene below them.
enum class Shoaling { off, on };

/// [[ocean.swell]]: a swell beside the sea. With hs_m it is irregular, a part of the spectrum; else one wave
/// with parallel crests.
struct SwellScene {
  std::optional<double> hs_m = {};
  std::optional<double> tp_s = {};                        ///< of the density's peak; absent: 12
  double spread_rad = 10.0 * (std::numbers::pi / 180.0);  ///< standard deviation of its directions
  double amplitude_m = 0.5;
  std::optional<double> wavelength_m = {};  ///< where both are given, this counts; with neither, 100
  std::optional<double> period_s = {};
  double direction_rad = 0.0;  ///< of travel, from +x toward +z
  double phase_rad = 0.0;      ///< at the origin and time 0; 0 is a crest

  bool operator==(const SwellScene&) const = default;
};

/// [ocean] and the sections in it.
struct OceanSection {
  bool is_given = false;                     ///< the scene has an [ocean] section
  std::optional<double> wind_speed_mps;      ///< overrides that of [wind]
  std::optional<double> wind_direction_rad;  ///< overrides that of [wind]
  std::optional<double> depth_m;             ///< absent: deep water, or the depth a measured file gives
  ocean::SpectrumParameters spectrum;        ///< its wind and depth are filled in by prepare_sea()

  std::string modes_file;     ///< the waves themselves; empty: they are drawn from a spectrum
  std::string spectrum_file;  ///< measured spectrum; empty: the modelled one
  /// A spectrum that a program has given, in place of what the file holds; nullptr: none.
  std::shared_ptr<const WaveSpectrum> spectrum_data;
  std::optional<double> tail_hz;  ///< the measured spectrum is continued to this frequency
  int record = 0;                 ///< record of spectrum_file

  std::vector<double> patch_lengths_m;     ///< one a cascade; empty: chosen from the spectrum
  int cascade_count = 3;                   ///< how many to choose at most
  int gerstner_count = 0;                  ///< Gerstner waves for the long waves; 0: the cascades carry all
  std::optional<double> gerstner_split_m;  ///< they are longer than this; absent: chosen from the spectrum
  std::vector<SwellScene> swells;
  std::vector<ocean::Raindrop> raindrops;
  std::vector<WakeScene> wakes;
  ocean::OceanParameters parameters;  ///< seed, loop and cascades are filled in by prepare_sea()

  ocean::WaterType water = ocean::WaterType::oceanic_1b;
  Shoaling shoaling = Shoaling::on;
};

}  // namespace offing::scene
