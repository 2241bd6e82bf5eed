#pragma once

#include <string>

#include "host/ocl/device.h"
#include "host/scene/ocean_scene.h"
#include "present/free_camera.h"
#include "present/gl_context.h"
#include "present/scene_clock.h"
#include "present/stage_times.h"
#include "present/transfer.h"
#include "present/water_pass.h"

namespace offing::present {

/// Everything that keys and panels change, and the window shows.
struct ViewState {
  scene::OceanScene scene;  ///< as edited; its view's camera is the one that flies
  FreeCamera camera;
  SceneClock clock;
  DebugView debug = DebugView::none;
  Fill fill = Fill::solid;
  float frame_limit_hz = 60.0f;  ///< 0: none
  float render_scale = 1.0f;     ///< pixels that are drawn a pixel of the window, along a side
  bool shows_panels = true;
  bool shows_help = false;
  std::string message = {};  ///< last fault or news, with the compiler's words if there were any
};

/// What the panels only show.
struct ViewFacts {
  const StageTimes& times;
  const GlCapabilities& capabilities;
  const ocl::DeviceInfo& device;
  TransferRung transfer;
  int width_px, height_px;  ///< of the picture that is drawn
};

/// What the user changed in one frame.
struct PanelEdits {
  bool is_sea_changed = false;  ///< the world is to be made anew
  bool is_sun_changed = false;
};

/// Draws all panels between PanelLayer::begin() and end().
PanelEdits draw_panels(ViewState& state, const ViewFacts& facts);

}  // namespace offing::present
