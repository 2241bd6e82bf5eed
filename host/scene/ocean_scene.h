#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/keyframes.h"
#include "host/ocean/ocean.h"
#include "host/ocean/spectrum_parameters.h"
#include "host/ocean/trochoids.h"
#include "host/scene/terrain_scene.h"
#include "host/scene/view_scene.h"

namespace offing::scene {

/// A parallel swell beside the sea of the spectrum.
struct SwellScene {
  double amplitude_m = 0.5;
  std::optional<double> wavelength_m = {};  ///< where both are given, this counts; with neither, 100
  std::optional<double> period_s = {};
  double direction_rad = 0.0;  ///< of travel, from +x toward +z
  double phase_rad = 0.0;      ///< at the origin and time 0; 0 is a crest
};

/// Everything a scene file or the command line can say about a sea, the ground and their pictures, checked
/// one value at a time by the parameter table (parameter_table.h), which holds every key, flag, unit and
/// range. A default-made scene is the default sea.
struct OceanScene {
  double latitude_rad = 0.0;   ///< of the origin, north positive
  double longitude_rad = 0.0;  ///< of the origin, east positive

  double frames_per_second = 24.0;
  double start_s = 0.0;  ///< first frame
  double end_s = 2.0;    ///< frames stop before this time

  double wind_speed_mps = 10.0;
  double wind_direction_rad = 0.0;                 ///< of travel, from +x toward +z
  std::optional<double> ocean_wind_speed_mps;      ///< overrides wind_speed_mps for the sea
  std::optional<double> ocean_wind_direction_rad;  ///< overrides wind_direction_rad for the sea
  std::optional<double> depth_m;                   ///< absent: deep water, or the depth a measured file gives
  ocean::SpectrumParameters spectrum;              ///< its wind and depth are filled in by prepare_sea()

  std::string spectrum_file;      ///< measured spectrum; empty: the modelled one
  std::optional<double> tail_hz;  ///< the measured spectrum is continued to this frequency
  int record = 0;                 ///< record of spectrum_file

  std::vector<double> patch_lengths_m;     ///< one a cascade; empty: chosen from the spectrum
  int cascade_count = 3;                   ///< how many to choose at most
  int gerstner_count = 0;                  ///< trochoids for the long waves; 0: the cascades carry all
  std::optional<double> gerstner_split_m;  ///< they are longer than this; absent: chosen from the spectrum
  std::vector<SwellScene> swells;
  std::vector<ocean::Raindrop> raindrops;
  ocean::OceanParameters ocean;  ///< its cascades are filled in by prepare_sea()

  bool names_sea = false;  ///< the scene has an [ocean] section
  TerrainScene terrain;
  /// Ground that is given without a sea stands alone.
  bool has_sea() const { return names_sea || !terrain.is_given; }

  ViewScene view;  ///< for the presenter; no simulation reads it
  /// Key of each parameter of the view that moves -> how, in the stored unit; see view_at().
  std::map<std::string_view, KeyframeTrack> tracks;

  std::map<std::string_view, std::string> set_at;  ///< key of each parameter that was set -> where
};

}  // namespace offing::scene
