#pragma once

#include <atomic>
#include <compare>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/keyframes.h"
#include "host/io/file_trust.h"
#include "host/ocean/spectrum/wind.h"
#include "host/scene/model/body_scene.h"
#include "host/scene/model/bookmark_scene.h"
#include "host/scene/model/cloud_scene.h"
#include "host/scene/model/mesh_scene.h"
#include "host/scene/model/ocean_section.h"
#include "host/scene/model/terrain_scene.h"
#include "host/scene/model/view_scene.h"
#include "host/scene/schema/section.h"

namespace offing::scene {

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

/// Counts copies of whole scenes, which are large: a frame makes none, an edit one for undo.
class CopyCount {
 public:
  CopyCount() = default;
  CopyCount(const CopyCount&) noexcept { ++copies_; }
  CopyCount(CopyCount&&) noexcept {}
  CopyCount& operator=(const CopyCount&) noexcept {
    ++copies_;
    return *this;
  }
  CopyCount& operator=(CopyCount&&) noexcept { return *this; }

  /// Since the program began.
  static std::size_t copies() { return copies_; }

 private:
  inline static std::atomic<std::size_t> copies_ = 0;
};

/// Everything a scene file or the command line can say about a sea, the ground and their pictures, checked
/// one value at a time by the parameter table (parameter_table.h), which holds every key, flag, unit and
/// range. A default-made scene is the default sea.
struct Scene {
  WorldSection world;
  TimeSection time;
  ocean::Wind wind;
  OceanSection ocean;
  TerrainScene terrain;
  std::vector<LakeScene> lakes;
  std::vector<LightScene> lights;
  std::vector<MeshScene> meshes;
  std::vector<BodyScene> bodies;
  CloudsScene cloud_settings;
  std::vector<CloudScene> clouds;
  std::vector<CloudLayerScene> cloud_layers;
  bool has_clouds() const { return !clouds.empty() || !cloud_layers.empty(); }
  /// Ground, meshes and clouds that are given without a sea stand alone.
  bool has_sea() const { return ocean.is_given || !(terrain.is_given || !meshes.empty() || has_clouds()); }

  /// In the heights of the scene; 0 where there is none.
  double sea_level_m() const { return has_sea() ? world.sea_level_m : 0.0; }

  ViewScene view;  ///< for the presenter; no simulation reads it
  std::vector<BookmarkScene> bookmarks;
  /// Each number that moves -> how, in the stored unit; see view_at(), meshes_at() and prepare_clouds().
  std::map<ValueKey, KeyframeTrack> tracks;

  std::map<ValueKey, std::string> set_at;  ///< each parameter that was set -> where

  Trust trust = Trust::trusted;       ///< in the files that it names
  std::set<std::string> named_files;  ///< by the scene's file, not by flags or in the window

  CopyCount copy_count = {};
};

}  // namespace offing::scene
