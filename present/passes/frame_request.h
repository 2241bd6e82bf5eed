#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string_view>

#include "host/base/camera.h"
#include "host/highlights/tracks/highlight_tracker.h"
#include "host/world/world_terrain.h"
#include "present/passes/quality.h"

namespace offing::present {

enum class Fill { solid, wireframe };

/// What the water shows instead of light.
enum class WaterShow {
  none,
  height,
  slope,
  jacobian,
  foam,
  footprint,
  grid,
  cascade_0,
  cascade_1,
  cascade_2,
  cascade_3
};
inline constexpr std::array all_water_shows{WaterShow::none,      WaterShow::height,    WaterShow::slope,
                                            WaterShow::jacobian,  WaterShow::foam,      WaterShow::footprint,
                                            WaterShow::grid,      WaterShow::cascade_0, WaterShow::cascade_1,
                                            WaterShow::cascade_2, WaterShow::cascade_3};
std::string_view to_string(WaterShow show);

/// What the ground shows.
enum class TerrainShow {
  light,
  steps,  ///< how many steps each ray took, over the whole picture (terrain::step_colours)
};

/// What meshes show.
enum class MeshShow {
  light,
  curvature,   ///< red: convex, blue: hollow, green: saddles
  directions,  ///< strokes along e_max, red, and e_min, blue
  projectors,  ///< the boxes of highlights
  regions,     ///< the faces of highlights
  ids,         ///< what is within highlights' boxes, a colour for each
};
inline constexpr std::array all_mesh_shows{MeshShow::light,      MeshShow::curvature, MeshShow::directions,
                                           MeshShow::projectors, MeshShow::regions,   MeshShow::ids};
std::string_view to_string(MeshShow show);

/// What a picture shows of highlights.
enum class HighlightShow {
  shown,
  hidden,        ///< none but those that water mirrors or shows beneath it
  only,          ///< nothing else: premultiplied, with alpha, hidden by all that stands before them
  unobstructed,  ///< the same, hidden by their own mesh alone
};
/// Whether a picture shows nothing but highlights.
inline bool is_alone(HighlightShow highlights) {
  return highlights == HighlightShow::only || highlights == HighlightShow::unobstructed;
}

/// How much of the round map of a cloudy sky a picture draws anew.
enum class SkyRefresh {
  whole,  ///< a picture is the same whatever was drawn before it
  slice,  ///< now and then a fifth: the map lags some pictures behind
};

/// What to draw: a time, from where, and how.
struct FrameRequest {
  double time_s = 0.0;  ///< for LiveSea; a Frame draws the world as it stands
  Camera camera;
  double exposure = 1.0;  ///< 1 / (kcd/m2), of LightMeter; LiveSea sets it
  WaterShow debug = WaterShow::none;
  Fill fill = Fill::solid;
  TerrainShow terrain = TerrainShow::light;
  MeshShow meshes = MeshShow::light;
  HighlightShow highlights = HighlightShow::shown;
  world::TileWait tiles = world::TileWait::all;
  SkyRefresh sky = SkyRefresh::whole;
  Quality quality = {};  ///< the camera has the side's share already
  /// For highlights that depend on the time alone (World::see_meshes()); none: they follow the camera.
  highlights::LightingAt lighting_at = {};
  std::optional<double> first_s =
      {};  ///< with a lighting: of the sequence that this picture is of; none: alone
  /// Asked between parts of a picture that takes long; false: it is not wanted any more.
  std::function<bool()> goes_on = {};

  /// Whether the picture is still wanted. Where somebody is asked, OpenGL first does what it was asked for.
  bool is_wanted() const;
};

}  // namespace offing::present
