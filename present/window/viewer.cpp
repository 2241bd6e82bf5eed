#include "present/window/viewer.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/host_memory.h"
#include "host/base/log.h"
#include "host/scene/prepare/moving_view.h"
#include "host/scene/prepare/scene_terrain.h"
#include "present/files/state_folder.h"
#include "present/gl/render_target.h"
#include "present/output/camera_path.h"
#include "present/output/image_file.h"
#include "present/output/video_pipe.h"
#include "present/panels/cloud_panel.h"
#include "present/panels/highlight_panel.h"
#include "present/panels/shown_names.h"
#include "present/window/bookmarks.h"
#include "present/window/view_actions.h"
#include "present/window/viewer_start.h"

namespace offing::present {
namespace {

// Where the CPU draws, more pixels than these make frames too slow; the window shows them enlarged.
constexpr double software_pixels = 640.0 * 360.0;

// Panels are drawn for so long after something that they may tell of.
constexpr double panels_follow_s = 1.0;

std::string whole_name(const std::filesystem::path& path) {
  std::error_code failure;
  const std::filesystem::path whole = std::filesystem::absolute(path, failure);
  return (failure ? path : whole).string();
}

}  // namespace

void FullScreen::toggle(GLFWwindow* window) {
  if (glfwGetWindowMonitor(window) != nullptr) {
    glfwSetWindowMonitor(window, nullptr, x_, y_, width_, height_, 0);
    return;
  }
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
  if (mode == nullptr) return;
  glfwGetWindowPos(window, &x_, &y_);
  glfwGetWindowSize(window, &width_, &height_);
  glfwSetWindowMonitor(window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

void FrameLimiter::wait(double frames_per_second) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point now = Clock::now();
  if (frames_per_second <= 0.0) {
    next_ = now;
    return;
  }
  std::this_thread::sleep_until(next_);
  const auto interval =
      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1.0 / frames_per_second));
  next_ = std::max(next_, now) + interval;
}

Viewer::Viewer(const ViewOptions& options, const CancelToken& cancel)
    : options_(options),
      cancel_(cancel),
      kept_look_(read_look(state_file("look"))),
      context_(GlContext::window(window_settings(options, kept_look_.window))),
      input_(window()),
      panels_(window(), options.ui_scale),
      start_screen_(window(), panels_),
      enlarge_(context_.capabilities()),
      control_(start_level(options, context_.capabilities())),
      sea_(context_, sea_settings(), options.scene),
      state_(start_state(options, sea_)),
      editing_(sea_, state_),
      scenes_(options_, sea_, state_, editing_),
      recent_(state_file("recent_files")),
      intake_(options_, sea_, state_, editing_, scenes_, recent_),
      quit_(scenes_, state_),
      files_(options_, state_, editing_, scenes_, intake_, scene_list_, recent_),
      record_(options_, state_),
      last_turn_s_(glfwGetTime()),
      drawn_s_(options.time_s) {
  options_.scene.view.camera = sea_.scene().view.camera;  // which the ground may have placed
  begin_path();
  scene_list_.follow(options_.scene_file);
  if (!options_.scene_file.empty()) recent_.add(options_.scene_file);
  state_.look = kept_look_;
  state_.kept_hz = start_kept_hz(options, context_.capabilities());
  state_.render_scale = static_cast<float>(options.render_scale);
  if (options.starts_paused) state_.clock.toggle_pause();
  if (options.recording) recorder_.emplace(*options.recording);
  spdlog::info("OpenGL {} ({}); OpenCL {}; transfer {}", context_.capabilities().version,
               context_.capabilities().renderer, sea_.device().name, to_string(sea_.frame().transfer_path()));
}

Viewer::~Viewer() {
  WindowExtent& extent = state_.look.window;
  const auto has = [&](int attribute) { return glfwGetWindowAttrib(window(), attribute) == GLFW_TRUE; };
  if (keeps_size() && glfwGetWindowMonitor(window()) == nullptr && !has(GLFW_ICONIFIED)) {
    extent.is_maximised = has(GLFW_MAXIMIZED);
    if (!extent.is_maximised) glfwGetWindowSize(window(), &extent.width, &extent.height);
  }
  if (state_.look != kept_look_) write_look(state_file("look"), state_.look);
  if (record_.is_recording()) glfwHideWindow(window());  // the end of its frame in progress may take a while
}

LiveSeaSettings Viewer::sea_settings() {
  panels_.set_look(kept_look_);
  const Quality quality = options_.recording ? Quality{} : control_.quality();
  LiveSeaSettings settings = present::sea_settings(options_, context_.capabilities(), cancel_, quality);
  settings.watch = [this](const OpeningStep& step) { start_screen_.show(title(options_), step); };
  settings.watch({.work = "OpenCL", .share = {}});
  return settings;
}

bool Viewer::is_sharp() const {
  glm::ivec2 window_px(0);
  glfwGetFramebufferSize(window(), &window_px.x, &window_px.y);
  return !options_.recording && refinement_.is_complete(view(window_px)) && !sea_.is_behind();
}

bool Viewer::is_at_rest() const {
  return is_sharp() && !has_panels_to_draw() && intake_.is_idle() && !sea_.is_making();
}

/// Waits for input where nothing is left to draw.
void Viewer::take_events() {
  constexpr double longest_wait_s = 0.25;
  const bool is_resting = is_at_rest();
  // Edits, pictures at other sizes and clouds that were made leave much behind that is freed.
  if (!std::exchange(was_at_rest_, is_resting) && is_resting) give_back_freed_memory();
  if (is_resting) {
    control_.rest();
    glfwWaitEventsTimeout(longest_wait_s);
    last_turn_s_ = glfwGetTime();  // nothing has moved meanwhile
  } else {
    glfwPollEvents();
  }
  const double now_s = glfwGetTime();
  if (std::exchange(deeds_, input_.deeds()) != input_.deeds()) deed_s_ = now_s;
  const bool has_news = std::exchange(events_, input_.events()) != input_.events();
  if (has_news || sea_.is_making()) panels_follow_s_ = now_s + panels_follow_s;
}

bool Viewer::turn() {
  take_events();
  const double now_s = glfwGetTime(), wall_s = now_s - std::exchange(last_turn_s_, now_s);
  for (const KeyPress press : input_.take_presses()) act(press);
  if (glfwWindowShouldClose(window()) == GLFW_TRUE) {
    glfwSetWindowShouldClose(window(), GLFW_FALSE);
    request_quit();
  }
  const bool asks = quit_.is_open();
  if (!asks && intake_.turn(input_.take_dropped_files(), screen(), input_.pointer())) begin_scene();
  state_.clock.advance(wall_s, played_span(state_.scene, state_.timeline));
  if (options_.recording) {
    const Recording& recording = *options_.recording;
    state_.clock.set_time((recording.frames.first + recorder_->count()) / recording.frames_per_second);
  }
  const bool was_recording = record_.is_recording();
  record_.turn();
  if (was_recording && !record_.is_recording()) panels_follow_s_ = now_s + panels_follow_s;
  editing_.take_made();
  // Where frames are slow, news stay for more of them.
  constexpr double longest_turn_s = 0.25;
  aged_from_s_ += std::max(0.0, wall_s - longest_turn_s);
  age_message(now_s);
  if (editing_.turn(screen(), input_.take_pointer_events(), input_.pointer_now())) input_.hold_camera();
  move_camera(wall_s);
  const Drawn drawn = show();
  // Frames in which wakes catch up or clouds are made say nothing of those that follow.
  const bool is_usual = !sea_.is_behind() && !sea_.is_making();
  if (drawn == Drawn::moving && state_.kept_hz > 0.0f && is_usual) {
    const double shown_s = glfwGetTime();
    control_.note(1e3 * (shown_s - now_s), 1e3 / state_.kept_hz, shown_s);
  }
  if (drawn == Drawn::moving && recorder_) record_frame();
  show_title();
  if (!is_at_rest()) limiter_.wait(most_frames_hz());
  return !quit_.has_quit() && !is_recorded_;
}

void Viewer::act(KeyPress press) {
  if (quit_.is_open()) {  // the dialog takes two keys, and keeps all others from the scene
    if (press.action != ViewAction::deselect && press.action != ViewAction::save) return;
    panels_.close_popups();
    return press.action == ViewAction::save ? quit_.save() : quit_.cancel();
  }
  if (files_.asks() || record_.asks()) return;
  if (files_.act(press.action) || change_view(press.action, state_) ||
      change_edits(press.action, editing_, screen()))
    return;
  const auto number = static_cast<std::size_t>(press.number);
  switch (press.action) {
    case ViewAction::toggle_walk:
      if (pilot_.toggle_walk(state_, sea_)) leave_path();
      break;
    case ViewAction::pick_ray:
      pick_ray();
      break;
    case ViewAction::record:
      record_.open();
      break;
    case ViewAction::take_screenshot:
      take_screenshot();
      break;
    case ViewAction::reload:
      report([&] {
        sea_.reload();
        return std::string("kernels and shaders were read and compiled again");
      });
      break;
    case ViewAction::toggle_fullscreen:
      full_screen_.toggle(window());
      break;
    case ViewAction::reset_camera:
      reset_camera();
      break;
    case ViewAction::look_at_selected:
      look_at_selected();
      break;
    case ViewAction::undo:
    case ViewAction::redo:
      attempt([&] {
        const bool is_other_scene = press.action == ViewAction::undo ? scenes_.undo() : scenes_.redo();
        if (is_other_scene) return begin_scene();
        take_path(editing_.last_edit());
        take_path(state_.scene);
      });
      break;
    case ViewAction::go_to_bookmark:
      go_to_bookmark(number);
      break;
    case ViewAction::set_bookmark:
      editing_.make(
          [&](scene::Scene& scene) { return present::set_bookmark(scene, state_.camera.camera(), number); });
      break;
    case ViewAction::deselect:
      escape();
      break;
    case ViewAction::quit:
      request_quit();
      break;
    default:  // of the view
      break;
  }
}

void Viewer::escape() {
  if (panels_.close_popups() || std::exchange(state_.shows_help, false)) return;
  if (!editing_.deselect()) state_.message = {.text = "nothing is picked; Ctrl Q quits"};
}

void Viewer::request_quit() {
  files_.close();
  record_.close();
  quit_.open(record_.progress());
  // A minimised window cannot ask.
  const bool is_minimised = glfwGetWindowAttrib(window(), GLFW_ICONIFIED) == GLFW_TRUE;
  if (quit_.is_open() && is_minimised) glfwRestoreWindow(window());
}

void Viewer::go_to_bookmark(std::size_t number) {
  report([&] {
    std::string news = present::go_to_bookmark(state_.scene, number, state_.camera.camera());
    leave_path();
    return news;
  });
}

void Viewer::begin_scene() {
  drawn_s_ = state_.clock.time_s();
  begin_path();
  last_turn_s_ = glfwGetTime();
  scene_list_.follow(options_.scene_file);
  control_ = QualityControl(start_level(options_, context_.capabilities()));
  refinement_.forget();
}

void Viewer::show_title() {
  const std::uint64_t now = editing_.edits() + scenes_.saves();
  if (std::exchange(titled_, now) == now) return;
  is_unsaved_ = scenes_.is_unsaved();
  std::string wanted = title(options_) + (is_unsaved_ ? " *" : "");
  if (wanted == shown_title_) return;
  shown_title_ = std::move(wanted);
  glfwSetWindowTitle(window(), shown_title_.c_str());
}

void Viewer::age_message(double now_s) {
  constexpr double least_s = 4.0, per_letter_s = 0.06;
  if (state_.message != aged_) {
    aged_ = state_.message;
    aged_from_s_ = now_s;
  }
  const double read_s = least_s + per_letter_s * static_cast<double>(aged_.text.size());
  if (aged_.text.empty() || aged_.is_fault || now_s < aged_from_s_ + read_s) return;
  state_.message = aged_ = {};
  panels_follow_s_ = std::max(panels_follow_s_, now_s + panels_follow_s);
}

Screen Viewer::screen() const {
  int width = 1, height = 1;
  glfwGetWindowSize(window(), &width, &height);
  const glm::dvec2 size(std::max(width, 1), std::max(height, 1));
  return {state_.camera.camera(), size / static_cast<double>(panels_.scale())};
}

void Viewer::move_camera(double wall_s) {
  constexpr double longest_step_s = 0.25;  // a frame that stands still takes a held key no further
  CameraInput input = input_.take_camera_input();
  if (quit_.is_open() || files_.asks() || record_.asks()) input = {};
  if (is_on_path_ && input.moves()) leave_path();
  for (const glm::dvec2 clip : input_.take_clicks()) {
    if (pilot_.go_through(state_, sea_, clip)) leave_path();
  }
  if (!is_on_path_) pilot_.move(state_, sea_, input, std::min(wall_s, longest_step_s));
}

void Viewer::pick_ray() {
  state_.pick.reset();
  if (!sea_.terrain() || !sea_.terrain()->is_in_reach()) return;
  state_.pick = pick_terrain(*sea_.terrain(), state_.camera.camera(), input_.pointer());
}

Quality Viewer::quality() const {
  Quality quality = state_.kept_hz > 0.0f && !options_.recording ? control_.quality() : Quality{};
  quality.ray_share = std::min(quality.ray_share, ray_shares.at(static_cast<std::size_t>(state_.rays)));
  return quality;
}

/// While quality gives way to a rate, more frames than that would come unevenly and leave it for nothing.
double Viewer::most_frames_hz() const {
  const double limit_hz = state_.frame_limit_hz, kept_hz = state_.kept_hz;
  if (kept_hz == 0.0 || options_.recording || control_.level() == 0) return limit_hz;
  return limit_hz > 0.0 ? std::min(limit_hz, kept_hz) : kept_hz;
}

/// From here on the camera is the user's.
void Viewer::leave_path() {
  is_on_path_ = false;
  state_.timeline.let_go();
  take_camera_path({}, state_.scene);
}

void Viewer::take_path(const scene::Scene& from) {
  if (has_camera_path(from)) take_camera_path(from, path_);
}

/// Of a scene that is shown from here on: of a path that the user has left, the last edit.
void Viewer::begin_path() {
  path_.view = options_.scene.view;
  path_.tracks.clear();
  take_path(options_.scene);
  take_path(editing_.last_edit());
  take_path(state_.scene);
  is_on_path_ = has_camera_path(state_.scene);
}

void Viewer::reset_camera() {
  state_.camera.reset();
  is_on_path_ = has_camera_path(path_);
  take_camera_path(path_, state_.scene);
}

void Viewer::look_at_selected() {
  const std::optional<Sphere> place = editing_.selected_place(screen());
  if (!place) {
    state_.message = {.text = "nothing with a place is selected"};
    return;
  }
  leave_path();
  state_.scene.view.mode = scene::CameraMode::fly;
  const auto surface_m = [this](double x_m, double z_m) { return sea_.surface_height_m(x_m, z_m); };
  const FreeWidth free = state_.shows_panels ? state_.layout.free_width() : FreeWidth{};
  state_.camera.look_at(place->centre_m, place->radius_m, surface_m, free);
}

/// Panels are drawn for a while after the last input: tooltips come late.
bool Viewer::has_panels_to_draw() const {
  return glfwGetTime() < panels_follow_s_ || panels_.is_in_use() || options_.recording;
}

/// While nobody looks into them, times and graphs need no more than ten new ones a second.
bool Viewer::are_panels_old() const {
  constexpr double renewed_s = 0.1;
  const bool has_handles =
      state_.object || state_.picked || state_.pick || state_.clouds.pick != CloudPick::none;
  return has_panels_to_draw() || has_handles || glfwGetTime() - panels_made_s_ > renewed_s;
}

Viewer::Drawn Viewer::show() {
  glm::ivec2 window_px(0);
  glfwGetFramebufferSize(window(), &window_px.x, &window_px.y);
  if (window_px.x == 0 || window_px.y == 0 || glfwGetWindowAttrib(window(), GLFW_ICONIFIED) == GLFW_TRUE) {
    glfwWaitEventsTimeout(0.1);
    return Drawn::nothing;
  }
  const Drawn drawn = draw_sea(window_px);
  if (drawn == Drawn::nothing && !has_panels_to_draw() && !record_.is_recording()) return drawn;
  PanelEdits edits;
  {
    std::optional<StageTimes::Scope> stage;
    if (drawn != Drawn::nothing) stage.emplace(sea_.frame().times(), Stage::panels);
    enlarge_.draw(sea_.frame().screen(), 0, window_px.x, window_px.y);
    if (are_panels_old()) {
      edits = draw_panels();
      panels_made_s_ = glfwGetTime();
    } else {
      panels_.repeat();
    }
  }
  require_no_gl_error("window");
  // Where no limit is wanted the display's is none either; and a quality control must not take waiting for
  // slow frames.
  const int swap_interval = state_.frame_limit_hz > 0.0f && state_.kept_hz == 0.0f ? 1 : 0;
  if (std::exchange(swap_interval_, swap_interval) != swap_interval) glfwSwapInterval(swap_interval);
  glfwSwapBuffers(window());
  if (drawn != Drawn::nothing) sea_.frame().times().end_frame();
  apply(edits);
  return drawn;
}

/// Of a recording or a still picture, whose highlights depend on the time alone; else none.
highlights::LightingAt Viewer::lighting_at(Sharpness sharpness) {
  if (!options_.recording && (sharpness != Sharpness::still || sea_.meshes().empty())) return {};
  const std::optional<glm::dvec3> stands_m =
      is_on_path_ ? std::nullopt : std::optional(state_.camera.camera().eye_m);
  return recorded_lighting(options_.recording ? options_.scene : sea_.scene(), sea_.terrain(), stands_m);
}

void Viewer::follow_path() {
  if (!is_on_path_) return;
  scene::ViewScene now = scene::view_at(path_, state_.clock.time_s());
  if (sea_.terrain()) scene::stand_on_ground(*sea_.terrain(), now);
  state_.camera.place(now.camera);
}

ShownView Viewer::view(glm::ivec2 window_px) const {
  const bool moves = is_on_path_ || moves_by_itself(sea_.scene());
  ShownView view{.time_s = moves ? state_.clock.time_s() : 0.0,
                 .camera = state_.camera.camera(),
                 .scene_revision = sea_.revision(),
                 .debug = state_.debug,
                 .fill = state_.fill,
                 .terrain = state_.terrain,
                 .meshes = state_.meshes,
                 .ray_share = ray_shares.at(static_cast<std::size_t>(state_.rays))};
  fit(view.camera, window_px, Sharpness::still);
  return view;
}

/// Gives a camera the size of a picture for a window of this size.
void Viewer::fit(Camera& camera, glm::ivec2 window_px, Sharpness sharpness) const {
  double scale = state_.render_scale;
  if (sharpness != Sharpness::still && context_.capabilities().is_software && !options_.size)
    scale *= std::min(1.0, std::sqrt(software_pixels / (1.0 * window_px.x * window_px.y)));
  if (sharpness == Sharpness::quick) scale *= quality().side_share;
  camera.width_px = std::max(1, static_cast<int>(std::lround(window_px.x * scale)));
  camera.height_px = std::max(1, static_cast<int>(std::lround(window_px.y * scale)));
  if (options_.recording) {
    camera.width_px = fitting_side(options_.recording->video, camera.width_px);
    camera.height_px = fitting_side(options_.recording->video, camera.height_px);
  }
}

std::optional<Sharpness> Viewer::next_picture(const ShownView& view) const {
  if (options_.recording) return Sharpness::quick;
  if (sea_.is_behind()) return Sharpness::quick;
  return refinement_.next(view, glfwGetTime(), deed_s_);
}

bool Viewer::goes_on() const {
  glfwPollEvents();
  return !cancel_.cancelled() && input_.deeds() == deeds_;
}

/// The picture that is due, if any.
Viewer::Drawn Viewer::draw_sea(glm::ivec2 window_px) {
  try {
    follow_path();
    const ShownView now = view(window_px);
    const std::optional<Sharpness> due = next_picture(now);
    if (!due) return Drawn::nothing;
    Quality drawn = quality();
    if (*due != Sharpness::quick) drawn = {.ray_share = now.ray_share};
    Camera& camera = state_.camera.camera();
    fit(camera, window_px, *due);
    const bool is_alone = options_.recording || *due == Sharpness::still;
    FrameRequest request{.time_s = state_.clock.time_s(),
                         .camera = camera,
                         .debug = state_.debug,
                         .fill = state_.fill,
                         .terrain = state_.terrain,
                         .meshes = state_.meshes,
                         .tiles = is_alone ? world::TileWait::all : world::TileWait::none,
                         .sky = is_alone ? SkyRefresh::whole : SkyRefresh::slice,
                         .quality = drawn,
                         .lighting_at = lighting_at(*due)};
    if (options_.recording) request.first_s = options_.recording->first_s();
    if (*due == Sharpness::still) request.first_s = request.time_s;
    if (*due != Sharpness::quick) request.goes_on = [this] { return goes_on(); };
    const PictureKind kind = *due == Sharpness::still ? PictureKind::still : PictureKind::moving;
    if (!sea_.draw(std::move(request), kind)) return Drawn::nothing;
    drawn_s_ = state_.clock.time_s();
    shown_quality_ = drawn;
    const bool is_fine = *due == Sharpness::quick && drawn == Quality{.ray_share = now.ray_share};
    refinement_.note(now, is_fine ? Sharpness::fine : *due, glfwGetTime());
    return *due == Sharpness::quick ? Drawn::moving : Drawn::refined;
  } catch (const Error& error) {
    // A time that the scene does not have, such as one beyond the sun's calendar: a recording ends there, the
    // window stays where it was.
    if (options_.recording || error.kind() != ErrorKind::bad_input || state_.clock.time_s() == drawn_s_) {
      throw;
    }
    state_.message = fault_message(error);
    state_.clock.set_time(drawn_s_);
    state_.clock.step(0.0);
    return Drawn::moving;
  }
}

PanelEdits Viewer::draw_panels() {
  Frame& frame = sea_.frame();
  if (sea_.terrain() && state_.shows_map) {
    const bool has_sea = sea_.scene().has_sea();
    map_.show(sea_.terrain()->parameters(), has_sea ? std::optional(sea_.sea_level_m()) : std::nullopt);
  }
  const auto need = [&](std::string_view text) { panels_.need(text); };
  for_shown_names(state_, scene_list_, need);
  files_.for_shown_names(need);
  record_.for_shown_names(need);
  panels_.set_look(state_.look);
  state_.edit.computed = sea_.computed_values();
  panels_.begin();
  editing_.draw(screen(), input_.pointer());
  PanelEdits edits =
      present::draw_panels(state_, {.times = frame.times(),
                                    .capabilities = context_.capabilities(),
                                    .device = sea_.device(),
                                    .transfer = frame.transfer_path(),
                                    .width_px = frame.screen().width(),
                                    .height_px = frame.screen().height(),
                                    .has_meshes = !sea_.meshes().empty(),
                                    .terrain = sea_.terrain(),
                                    .map = &map_,
                                    .quality = shown_quality_,
                                    .scenes = &scene_list_,
                                    .open_scene = listed(options_),
                                    .recording = record_.progress(),
                                    .undo = scenes_.undo_words(),
                                    .redo = scenes_.redo_words(),
                                    .can_save = !scenes_.has_file() || is_unsaved_ || scenes_.has_moved()});
  if (state_.shows_panels) edits.scene = std::max(edits.scene, draw_highlight_panel(state_, sea_.meshes()));
  if (state_.shows_panels) edits.scene = std::max(edits.scene, draw_cloud_panel(state_, sea_));
  files_.draw();
  int width = 1, height = 1;
  glfwGetFramebufferSize(window(), &width, &height);
  record_.draw({width, height});
  quit_.draw(record_.progress());
  panels_.end();
  if (!panels_.is_in_use() && std::exchange(kept_look_, state_.look) != state_.look)
    write_look(state_file("look"), state_.look);
  return edits;
}

void Viewer::apply(const PanelEdits& edits) {
  if (edits.is_camera_moved && is_on_path_) leave_path();
  if (edits.wanted_place && pilot_.go_to(state_, sea_, *edits.wanted_place)) leave_path();
  // The sea follows a slider while it is held, unless that would hold up the slider.
  constexpr double quick_s = 0.1;
  const bool follows = edits.scene == Edit::going_on && sea_.edit_s() < quick_s;
  if (edits.scene == Edit::done || edits.scene == Edit::refused || follows) editing_.finish(edits.scene);
  if (edits.scene != Edit::none) take_path(state_.scene);
  if (edits.object) editing_.do_to_object(*edits.object, screen());
  if (edits.wanted_scene) intake_.open(*edits.wanted_scene);
  if (edits.action) act({*edits.action});
  if (edits.cancels_recording) record_.cancel();
  if (edits.wanted_file) files_.open(*edits.wanted_file);
  if (state_.edit.browsed) files_.browse(*std::exchange(state_.edit.browsed, {}));
  if (edits.wants_original) {
    state_.scene = options_.scene;
    take_path(options_.scene);
    reset_camera();
    editing_.finish(Edit::done);
  }
}

void Viewer::report(const std::function<std::string()>& work) {
  attempt([&] { state_.message = {.text = work()}; });
}

void Viewer::attempt(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    state_.message = fault_message(error);
  }
}

void Viewer::take_screenshot() {
  report([&] {
    const auto path = unused_image_name(options_.scene_name.empty() ? "offing" : options_.scene_name);
    sea_.write(path, Existing::keep);
    return fmt::format("wrote {}", whole_name(path));
  });
}

void Viewer::record_frame() {
  sea_.record(*recorder_);
  if (!recorder_->is_complete()) return;
  recorder_->finish();
  is_recorded_ = true;
}

void show_window(const ViewOptions& options, const CancelToken& cancel) {
  keep_large_arrays_apart();  // scenes come and go, and a window stays open for hours
  Viewer viewer(options, cancel);
  while (!cancel.cancelled() && viewer.turn()) {
  }
  const bool has_video = options.recording && !options.recording->video.empty();
  const bool lacks_video = has_video && viewer.recorded() < options.recording->count();
  if (!cancel.cancelled() && !lacks_video) return;
  if (options.recording) throw stopped_recording(*options.recording, viewer.recorded());
  throw Error(ErrorKind::cancelled, "offing-view: the window was closed by a signal",
              "Ctrl Q or the window's own button closes it without an error");
}

}  // namespace offing::present
