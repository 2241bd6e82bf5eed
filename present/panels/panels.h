#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "host/base/error.h"
#include "host/ocl/device_list.h"
#include "host/scene/file/scene_writer.h"
#include "host/scene/model/scene.h"
#include "host/scene/schema/parameter.h"
#include "present/editing/cloud_editing.h"
#include "present/editing/mesh_picker.h"
#include "present/editing/objects/object_edit.h"
#include "present/editing/terrain_pick.h"
#include "present/files/file_browser.h"
#include "present/gl/gl_context.h"
#include "present/gl/stage_times.h"
#include "present/gl/transfer.h"
#include "present/panels/look.h"
#include "present/panels/mini_map.h"
#include "present/panels/panel_layout.h"
#include "present/panels/parameter_widget.h"
#include "present/passes/frame_request.h"
#include "present/passes/quality.h"
#include "present/timeline/timeline_panel.h"
#include "present/window/free_camera.h"
#include "present/window/key_bindings.h"
#include "present/window/scene_clock.h"
#include "present/window/scene_list.h"

namespace offing::present {

/// The last fault or news.
struct Message {
  std::string text = {};
  bool is_fault = false;

  bool operator==(const Message&) const = default;
};
/// The error's line, with the compiler's words if there were any, and its fix.
Message fault_message(const Error& error);

/// The panel of a group of the parameter table.
struct GroupPanel {
  scene::ParameterGroup group;
  const char* title;
  const char* words = "";  ///< that people look for, beside those of its values
};
std::span<const GroupPanel> group_panels();

/// For how many of the picture's pixels rays are cast at the ground at most.
enum class RayChoice { all, three_quarters, half, quarter };
inline constexpr std::array<double, 4> ray_shares{1.0, 0.75, 0.5, 0.25};

/// Of the main panel's width, for what a value is changed with; its name is beside it.
inline constexpr float item_share = 0.42f;
/// In panels at the right: the same, and where lines of text end, in heights of letters.
inline constexpr float side_item_em = 7.0f, side_text_em = 16.0f;

/// Everything that keys and panels change, and the window shows.
struct ViewState {
  scene::Scene scene;  ///< as edited; its view's camera is the one that flies
  FreeCamera camera;
  SceneClock clock;
  Timeline timeline = {};
  WaterShow debug = WaterShow::none;
  Fill fill = Fill::solid;
  TerrainShow terrain = TerrainShow::light;
  MeshShow meshes = MeshShow::light;
  RayChoice rays = RayChoice::all;
  std::optional<TerrainPick> pick = {};
  std::optional<SceneObject> object = {};  ///< that is selected, but for clouds: see selected_object()
  std::optional<HighlightName> picked = {};
  CloudEditing clouds = {};
  std::optional<SceneObject> listed = {};  ///< that was selected when the list of objects was drawn last
  std::optional<SceneObject> valued = {};  ///< whose values were drawn last
  std::optional<Renaming> renaming = {};
  float frame_limit_hz = 60.0f;  ///< 0: none
  float kept_hz = 0.0f;          ///< frames a second that quality gives way to; 0: quality stays
  float render_scale = 1.0f;     ///< pixels that are drawn a pixel of the window, along a side
  bool shows_panels = true;
  bool shows_help = false;
  bool shows_map = false;
  TimeSource shown_times = TimeSource::cpu;
  std::string search = {};  ///< for values; empty: all are shown, by sections
  bool begins_search = false;
  EditInProgress edit = {};
  Message message = {};
  Look look = {};
  PanelLayout layout = {};
};

/// What the panels only show.
struct ViewFacts {
  const StageTimes& times;
  const GlCapabilities& capabilities;
  const ocl::DeviceInfo& device;
  TransferPath transfer;
  int width_px, height_px;  ///< of the picture that is drawn
  bool has_meshes = false;
  const world::WorldTerrain* terrain = nullptr;
  const MiniMap* map = nullptr;
  Quality quality = {};         ///< of the picture
  SceneList* scenes = nullptr;  ///< nullptr: no list is drawn
  ListedScene open_scene = {};
  std::optional<RecordingProgress> recording = {};  ///< that runs
  std::string undo = {}, redo = {};  ///< what they would do; empty: nothing
  bool can_save = false;  ///< there is something that the scene's file has not
};

/// What the user asked for in one frame, and panels cannot do by themselves.
struct PanelEdits {
  Edit scene = Edit::none;  ///< of all but the camera
  bool is_camera_moved = false;
  std::optional<ViewAction> action = {};         ///< of a key, by a button
  std::optional<FileFilter> wanted_file = {};    ///< to be chosen in a dialog
  bool wants_original = false;                   ///< the scene as it was when the window opened
  std::optional<ObjectEdit> object = {};         ///< for objects of the scene
  std::optional<ListedScene> wanted_scene = {};  ///< to be opened
  bool cancels_recording = false;
  std::optional<glm::dvec2> wanted_place = {};  ///< of the camera, east and south: a click on the map
};

/// Draws all panels between PanelLayer::begin() and end().
PanelEdits draw_panels(ViewState& state, const ViewFacts& facts);

}  // namespace offing::present
