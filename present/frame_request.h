#pragma once

#include <array>
#include <string_view>

#include "host/base/camera.h"
#include "host/world/ground_view.h"

namespace offing::present {

enum class Fill { solid, wireframe };

/// What the water shows instead of light.
enum class DebugView {
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
inline constexpr std::array all_debug_views{DebugView::none,      DebugView::height,    DebugView::slope,
                                            DebugView::jacobian,  DebugView::foam,      DebugView::footprint,
                                            DebugView::grid,      DebugView::cascade_0, DebugView::cascade_1,
                                            DebugView::cascade_2, DebugView::cascade_3};
std::string_view to_string(DebugView view);

/// What the ground shows.
enum class GroundShow {
  light,
  steps,  ///< how many steps each ray took, over the whole picture (terrain::step_colours)
};

/// What to draw: the world as this camera sees it.
struct FrameRequest {
  Camera camera;
  double exposure = 1.0;  ///< 1 / (kcd/m2), of LightMeter
  DebugView debug = DebugView::none;
  Fill fill = Fill::solid;
  GroundShow ground = GroundShow::light;
  world::TileWait tiles = world::TileWait::all;
  double ground_scale = 1.0;  ///< rays that are cast at the ground a pixel of the picture, along a side
};

}  // namespace offing::present
