#include "present/viewer.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include "host/base/error.h"
#include "host/scene/world_scene.h"
#include "host/sky/sun_position.h"
#include "present/exposure.h"
#include "present/frame.h"
#include "present/frame_limiter.h"
#include "present/panel_layer.h"
#include "present/panels.h"
#include "present/picture_file.h"
#include "present/window_input.h"

namespace offing::present {
namespace {

// Where the CPU draws, more pixels than these make frames too slow.
constexpr PictureSize software_size{640, 360};

PictureSize window_size(const ViewOptions& options, const GlCapabilities& capabilities) {
  return options.size.value_or(capabilities.is_software ? software_size : PictureSize{});
}

class Viewer {
 public:
  explicit Viewer(const ViewOptions& options)
      : options_(options),
        context_(GlContext::window({.title = title(options)})),
        device_(ocl::Device::open_shared(ocl::select_device(options.device), ocl::Profiling::on,
                                         context_.share_properties())),
        world_(std::make_unique<world::World>(device_, scene::prepare_world(options.scene))),
        frame_(std::make_unique<Frame>(context_, device_, frame_settings())),
        state_{.scene = options.scene,
               .camera = FreeCamera(options.scene.view.camera),
               .clock = SceneClock(options.time_s, 1.0 / options.scene.frames_per_second)},
        good_scene_(options.scene),
        input_(window()),
        panels_(window()) {
    const PictureSize size = window_size(options, context_.capabilities());
    glfwSetWindowSize(window(), size.width, size.height);
    glfwSwapInterval(1);
    spdlog::info("OpenGL {} ({}); OpenCL {}; transfer {}", context_.capabilities().version,
                 context_.capabilities().renderer, device_.info().name, to_string(frame_->transfer_rung()));
  }

  void run(const CancelToken& cancel) {
    double last_s = glfwGetTime();
    int recorded = 0;
    while (!glfwWindowShouldClose(window()) && !is_quitting_ && !cancel.cancelled()) {
      glfwPollEvents();
      const double now_s = glfwGetTime(), wall_s = now_s - std::exchange(last_s, now_s);
      for (const ViewAction action : input_.take_actions()) act(action);
      state_.camera.advance(input_.take_camera_input(), wall_s);
      state_.clock.advance(wall_s);
      if (options_.recording) {
        const Recording& recording = *options_.recording;
        state_.clock.set_time((recording.frames.first + recorded) / recording.frames_per_second);
      }
      if (!show()) continue;
      if (options_.recording) {
        write_picture(options_.recording->name.of(options_.recording->frames.first + recorded), *frame_,
                      state_.clock.time_s(), exposure_);
        is_quitting_ = options_.recording->frames.first + ++recorded > options_.recording->frames.last;
      }
      limiter_.wait(state_.frame_limit_hz);
    }
  }

 private:
  static std::string title(const ViewOptions& options) {
    return options.scene_name.empty() ? "Offing" : fmt::format("Offing: {}", options.scene_name);
  }

  FrameSettings frame_settings() const {
    const Detail usual = context_.capabilities().is_software ? Detail::low : Detail::high;
    return {.water = water_detail(options_.detail.value_or(usual)), .transfer = options_.transfer};
  }

  GLFWwindow* window() const { return context_.window_handle(); }

  /// One frame on the screen; false where there is nothing to draw on.
  bool show() {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window(), &width, &height);
    if (width == 0 || height == 0) {
      glfwWaitEventsTimeout(0.1);  // minimised
      return false;
    }
    const double scale = state_.render_scale * software_scale(width, height);
    Camera& camera = state_.camera.camera();
    camera.width_px = std::max(1, static_cast<int>(std::lround(width * scale)));
    camera.height_px = std::max(1, static_cast<int>(std::lround(height * scale)));
    simulate();
    exposure_ = exposure_for(world_->sky(), camera, state_.scene.view.exposure_ev);
    frame_->draw(*world_,
                 {.camera = camera, .exposure = exposure_, .debug = state_.debug, .fill = state_.fill});
    present_to(width, height);
    glfwSwapBuffers(window());
    frame_->times().end_frame();
    return true;
  }

  double software_scale(int width, int height) const {
    if (!context_.capabilities().is_software || options_.size) return 1.0;
    const double pixels = static_cast<double>(width) * height;
    return std::min(1.0, std::sqrt(software_size.width * software_size.height / pixels));
  }

  void simulate() {
    const StageTimes::Scope stage(frame_->times(), Stage::simulate);
    const ocl::Event start = device_.mark();
    world_->at(state_.clock.time_s(), state_.camera.camera().eye_m.y);
    const ocl::Event end = device_.mark();
    device_.finish();
    frame_->times().add_device_ms(Stage::simulate, 1e3 * (end.end_s() - start.end_s()));
  }

  void present_to(int width, int height) {
    const StageTimes::Scope stage(frame_->times(), Stage::panels);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, frame_->screen().framebuffer());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, frame_->screen().width(), frame_->screen().height(), 0, 0, width, height,
                      GL_COLOR_BUFFER_BIT, GL_LINEAR);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, width, height);
    panels_.begin();
    const PanelEdits edits = draw_panels(state_, {.times = frame_->times(),
                                                  .capabilities = context_.capabilities(),
                                                  .device = device_.info(),
                                                  .transfer = frame_->transfer_rung(),
                                                  .width_px = frame_->screen().width(),
                                                  .height_px = frame_->screen().height()});
    panels_.end();
    if (edits.is_sun_changed) turn_sun();
    if (edits.is_sea_changed) make_world();
  }

  void turn_sun() {
    const scene::ViewScene& view = state_.scene.view;
    world_->set_sun(sky::direction_of(view.sun_azimuth_rad, view.sun_elevation_rad), 1.0);
  }

  /// The world of the edited scene; where that cannot be, the message says why and the scene is as it was.
  void make_world() {
    try {
      auto world = std::make_unique<world::World>(device_, scene::prepare_world(state_.scene));
      world_ = std::move(world);
      good_scene_ = state_.scene;
      state_.message.clear();
    } catch (const Error& error) {
      state_.message = fmt::format("{}\n{}", error.what(), error.hint());
      const scene::ViewScene view = state_.scene.view;
      state_.scene = good_scene_;
      state_.scene.view = view;
    }
  }

  /// Kernels and shaders from the folders that OFFING_KERNEL_PATH and OFFING_SHADER_PATH name, or as built
  /// in; the last good ones stay where new ones do not compile.
  void reload() {
    try {
      auto frame = std::make_unique<Frame>(context_, device_, frame_settings());
      auto world = std::make_unique<world::World>(device_, scene::prepare_world(state_.scene));
      world->at(state_.clock.time_s(), state_.camera.camera().eye_m.y);  // builds what is built at first use
      device_.finish();
      frame_ = std::move(frame);
      world_ = std::move(world);
      state_.message = "kernels and shaders are read again";
    } catch (const Error& error) {
      state_.message = fmt::format("{}\n{}", error.what(), error.hint());
    }
  }

  void take_screenshot() {
    const std::string scene = options_.scene_name.empty() ? "offing" : options_.scene_name;
    int number = 1;
    std::filesystem::path path;
    do {
      path = fmt::format("{}_{:03}.png", scene, number++);
    } while (std::filesystem::exists(path));
    try {
      write_picture(path, *frame_, state_.clock.time_s(), exposure_);
      state_.message = fmt::format("wrote {}", std::filesystem::absolute(path).string());
    } catch (const Error& error) {
      state_.message = fmt::format("{}\n{}", error.what(), error.hint());
    }
  }

  void toggle_fullscreen() {
    if (glfwGetWindowMonitor(window()) != nullptr) {
      glfwSetWindowMonitor(window(), nullptr, window_x_, window_y_, window_width_, window_height_, 0);
      return;
    }
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    if (mode == nullptr) return;
    glfwGetWindowPos(window(), &window_x_, &window_y_);
    glfwGetWindowSize(window(), &window_width_, &window_height_);
    glfwSetWindowMonitor(window(), monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
  }

  void act(ViewAction action) {
    switch (action) {
      case ViewAction::toggle_help:
        state_.shows_help = !state_.shows_help;
        break;
      case ViewAction::toggle_panels:
        state_.shows_panels = !state_.shows_panels;
        break;
      case ViewAction::toggle_pause:
        state_.clock.toggle_pause();
        break;
      case ViewAction::step_forward:
        state_.clock.step(1);
        break;
      case ViewAction::step_back:
        state_.clock.step(-1);
        break;
      case ViewAction::slower:
        state_.clock.set_scale(0.5 * state_.clock.scale());
        break;
      case ViewAction::faster:
        state_.clock.set_scale(2.0 * state_.clock.scale());
        break;
      case ViewAction::real_time:
        state_.clock.set_scale(1.0);
        break;
      case ViewAction::toggle_wireframe:
        state_.fill = state_.fill == Fill::solid ? Fill::wireframe : Fill::solid;
        break;
      case ViewAction::next_debug_view: {
        const auto next = static_cast<std::size_t>(state_.debug) + 1;
        state_.debug = all_debug_views[next % all_debug_views.size()];
        break;
      }
      case ViewAction::take_screenshot:
        take_screenshot();
        break;
      case ViewAction::reload:
        reload();
        break;
      case ViewAction::toggle_fullscreen:
        toggle_fullscreen();
        break;
      case ViewAction::reset_camera:
        state_.camera.reset();
        break;
      case ViewAction::quit:
        is_quitting_ = true;
        break;
    }
  }

  const ViewOptions& options_;
  GlContext context_;
  ocl::Device device_;
  std::unique_ptr<world::World> world_;
  std::unique_ptr<Frame> frame_;
  ViewState state_;
  scene::OceanScene good_scene_;  // of world_
  WindowInput input_;
  PanelLayer panels_;
  FrameLimiter limiter_;
  double exposure_ = 1.0;
  bool is_quitting_ = false;
  int window_x_ = 0, window_y_ = 0, window_width_ = 0, window_height_ = 0;  // before full screen
};

}  // namespace

void show_window(const ViewOptions& options, const CancelToken& cancel) {
  Viewer(options).run(cancel);
  cancel.throw_if_cancelled();
}

}  // namespace offing::present
