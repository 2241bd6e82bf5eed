#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <glm/ext/vector_int2.hpp>

#include "host/base/work.h"
#include "present/editing/scene_editing.h"
#include "present/files/file_actions.h"
#include "present/gl/gl_context.h"
#include "present/panels/mini_map.h"
#include "present/panels/panel_layer.h"
#include "present/panels/panels.h"
#include "present/panels/quit_dialog.h"
#include "present/passes/enlarge/enlarge_pass.h"
#include "present/passes/live_sea.h"
#include "present/timeline/record_actions.h"
#include "present/view_options.h"
#include "present/window/camera_pilot.h"
#include "present/window/file_intake.h"
#include "present/window/quality_control.h"
#include "present/window/refinement.h"
#include "present/window/scene_switch.h"
#include "present/window/start_screen.h"
#include "present/window/window_input.h"

namespace offing::present {

/// Takes a window to the whole screen and back to its place.
class FullScreen {
 public:
  void toggle(GLFWwindow* window);

 private:
  int x_ = 0, y_ = 0, width_ = 0, height_ = 0;  // of the window before
};

/// Keeps frames from coming faster than asked, where the display does not.
class FrameLimiter {
 public:
  /// Sleeps until a frame may follow the one before; does not catch up on frames that were late. 0 is no
  /// limit.
  void wait(double frames_per_second);

 private:
  std::chrono::steady_clock::time_point next_ = std::chrono::steady_clock::now();
};

/// The window: keys and mouse to what they do, panels, and the sea behind them.
class Viewer {
 public:
  /// Opens a window on the scene of the options. Throws Error(no_device) where no window can be had.
  Viewer(const ViewOptions& options, const CancelToken& cancel);
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;
  /// Remembers how large the window is.
  ~Viewer();

  /// Input, time, picture, panels: one frame. Where nothing is left to draw it waits for input, a quarter of
  /// a second at most. False once the user has quit, or the last frame of a recording is written.
  bool turn();
  /// Whether the picture is as sharp as one in a file.
  bool is_sharp() const;
  /// Whether it is, and nothing is drawn any more.
  bool is_at_rest() const;

  const ViewState& state() const { return state_; }
  /// The name of the scene, with a mark where it has unsaved edits.
  const std::string& shown_title() const { return shown_title_; }
  /// Of the next picture of a moving view. What is recorded has all of it.
  Quality quality() const;
  /// Frames of the recording that are written.
  int recorded() const { return recorder_ ? recorder_->count() : 0; }
  /// Whether the user has the scene recorded, or says what is to be.
  bool is_recording() const { return record_.is_recording() || record_.asks(); }
  LiveSea& sea() { return sea_; }
  GLFWwindow* window() const { return context_.window_handle(); }

 private:
  void act(KeyPress press);
  void go_to_bookmark(std::size_t number);
  /// What follows from another scene's being shown.
  void begin_scene();
  void move_camera(double wall_s);
  void leave_path();
  /// The camera follows the path of that scene, or goes back to it; if it has none, the path stays.
  void take_path(const scene::Scene& from);
  void begin_path();
  void pick_ray();
  void reset_camera();
  void look_at_selected();
  void take_screenshot();
  double most_frames_hz() const;
  LiveSeaSettings sea_settings();
  /// Whether the window has the size that the user leaves it in.
  bool keeps_size() const { return !options_.size && !options_.recording; }
  void take_events();
  /// What a turn has drawn of the scene; panels are drawn with each, and now and then with nothing.
  enum class Drawn { nothing, moving, refined };
  Drawn show();
  bool has_panels_to_draw() const;
  bool are_panels_old() const;
  ShownView view(glm::ivec2 window_px) const;
  void fit(Camera& camera, glm::ivec2 window_px, Sharpness sharpness) const;
  std::optional<Sharpness> next_picture(const ShownView& view) const;
  /// Whether the picture in progress is still wanted.
  bool goes_on() const;
  void follow_path();
  highlights::LightingAt lighting_at(Sharpness sharpness);
  Drawn draw_sea(glm::ivec2 window_px);
  PanelEdits draw_panels();
  void apply(const PanelEdits& edits);
  Screen screen() const;
  void show_title();
  /// News go after a while; faults stay until the next edit or a click.
  void age_message(double now_s);
  /// Deselects, or closes what has popped up.
  void escape();
  void request_quit();
  void record_frame();
  /// Does something; the message says what came of it, or the fault.
  void report(const std::function<std::string()>& work);
  /// Does something; the message tells its fault.
  void attempt(const std::function<void()>& work);

  ViewOptions options_;
  const CancelToken& cancel_;
  Look kept_look_;  // as it is remembered
  GlContext context_;
  WindowInput input_;
  PanelLayer panels_;
  StartScreen start_screen_;
  EnlargePass enlarge_;
  QualityControl control_;
  LiveSea sea_;
  ViewState state_;
  CameraPilot pilot_;
  SceneEditing editing_;
  SceneSwitch scenes_;
  RecentFiles recent_;
  FileIntake intake_;
  QuitDialog quit_;
  SceneList scene_list_;
  FileActions files_;
  RecordActions record_;
  std::string shown_title_;
  std::optional<std::uint64_t> titled_;  // edits and saves that the title knows of
  bool is_unsaved_ = false;
  Message aged_;  // that is shown since then
  double aged_from_s_ = 0.0;
  MiniMap map_;
  Refinement refinement_;
  Quality shown_quality_;  // of the picture that is shown
  FrameLimiter limiter_;
  double last_turn_s_;
  double deed_s_ = 0.0;  // of the last input
  double panels_made_s_ = 0.0;
  double panels_follow_s_ = 0.0;          // until when panels are drawn though nothing has changed
  std::uint64_t events_ = 0, deeds_ = 0;  // that were seen
  double drawn_s_;                        // time of the last picture; before the first one, of that
  bool is_on_path_ = false;               // the camera follows the scene's keyframes until the user moves it
  scene::Scene path_;  // those keyframes, as edited, and the view of the scene's file; no more
  std::optional<Recorder> recorder_;
  std::optional<int> swap_interval_;
  bool was_at_rest_ = false;
  bool is_recorded_ = false;  // the whole recording is
  FullScreen full_screen_;
};

/// Shows the scene of the options in a window until the user quits or the token is cancelled; with a
/// recording, until its last frame is written. Throws what Viewer throws, Error(cancelled) where the token
/// ended it.
void show_window(const ViewOptions& options, const CancelToken& cancel);

}  // namespace offing::present
