#pragma once

#include <compare>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/keyframes.h"
#include "host/io/file_trust.h"
#include "host/ocean/spectrum/spectrum_parameters.h"
#include "host/ocean/surface/gerstner_waves.h"
#include "host/ocean/surface/ocean.h"
#include "host/ocean/surface/water_optics.h"
#include "host/scene/model/body_scene.h"
#include "host/scene/model/bookmark_scene.h"
#include "host/scene/model/cloud_scene.h"
#include "host/scene/model/mesh_scene.h"
#include "host/scene/model/terrain_scene.h"
#include "host/scene/model/view_scene.h"
#include "host/scene/model/wake_scene.h"

namespace offing::scene {

/// Which element of a repeated section: of [[mesh]] the outer one; of [[mesh.highlight]], which each mesh has
/// its own of, the inner one too.
struct ElementIndex {
  std::size_t outer = 0, inner = 0;

  auto operator<=>(const ElementIndex&) const = default;
};

/// A value of a scene, or one of the numbers that it is made of.
struct ValueKey {
  std::string_view key;  ///< of its row of the parameter table
  ElementIndex element = {};
  std::size_t number = 0;

  // Implicit: most values have a key and no more.
  ValueKey(const char* row_key) : key(row_key) {}  // NOLINT(google-explicit-constructor)
  ValueKey(std::string_view row_key, ElementIndex index = {}, std::size_t which = 0)  // NOLINT
      : key(row_key), element(index), number(which) {}

  auto operator<=>(const ValueKey&) const = default;
};

/// Whether waves feel the ground of a scene below them.
enum class Shoaling { off, on };

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
struct Scene {
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
  int gerstner_count = 0;                  ///< Gerstner waves for the long waves; 0: the cascades carry all
  std::optional<double> gerstner_split_m;  ///< they are longer than this; absent: chosen from the spectrum
  std::vector<SwellScene> swells;
  std::vector<ocean::Raindrop> raindrops;
  std::vector<WakeScene> wakes;
  ocean::OceanParameters ocean;  ///< its cascades are filled in by prepare_sea()

  ocean::WaterType water = ocean::WaterType::oceanic_1b;
  Shoaling shoaling = Shoaling::on;

  bool names_sea = false;  ///< the scene has an [ocean] section
  TerrainScene terrain;
  std::vector<LightScene> lights;
  std::vector<MeshScene> meshes;
  std::vector<BodyScene> bodies;
  CloudsScene cloud_settings;
  std::vector<CloudScene> clouds;
  std::vector<CloudLayerScene> cloud_layers;
  bool has_clouds() const { return !clouds.empty() || !cloud_layers.empty(); }
  /// Ground, meshes and clouds that are given without a sea stand alone.
  bool has_sea() const { return names_sea || !(terrain.is_given || !meshes.empty() || has_clouds()); }

  ViewScene view;  ///< for the presenter; no simulation reads it
  std::vector<BookmarkScene> bookmarks;
  /// Each number that moves -> how, in the stored unit; see view_at(), meshes_at() and prepare_clouds().
  std::map<ValueKey, KeyframeTrack> tracks;

  std::map<ValueKey, std::string> set_at;  ///< each parameter that was set -> where

  Trust trust = Trust::trusted;       ///< in the files that it names
  std::set<std::string> named_files;  ///< by the scene's file, not by flags or in the window
};

}  // namespace offing::scene
