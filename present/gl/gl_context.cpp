#include "present/gl/gl_context.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>
#include <string_view>
#include <utility>

#include <epoxy/gl.h>
// The order matters: epoxy declares OpenGL first.
#include <epoxy/egl.h>
#include <epoxy/glx.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/log.h"

namespace offing::present {
namespace {

// OpenCL's properties of a shared context (cl_khr_gl_sharing), whose header only host/ocl includes.
constexpr std::intptr_t cl_gl_context_khr = 0x2008;
constexpr std::intptr_t cl_egl_display_khr = 0x2009;
constexpr std::intptr_t cl_glx_display_khr = 0x200A;

struct GlVersion {
  int major, minor;
};
constexpr std::array<GlVersion, 3> wanted_versions{{{4, 5}, {4, 1}, {3, 3}}};

std::string text_of(GLenum name) {
  const GLubyte* text = glGetString(name);
  return text ? reinterpret_cast<const char*>(text) : "";
}

// The renderers of Mesa and Google that draw on the CPU.
bool is_software_renderer(std::string renderer) {
  std::transform(renderer.begin(), renderer.end(), renderer.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  constexpr std::array<std::string_view, 3> names{"llvmpipe", "softpipe", "swiftshader"};
  return std::any_of(names.begin(), names.end(),
                     [&](std::string_view name) { return renderer.find(name) != std::string::npos; });
}

GlCapabilities read_capabilities(const std::string& platform) {
  GlCapabilities found;
  glGetIntegerv(GL_MAJOR_VERSION, &found.major);
  glGetIntegerv(GL_MINOR_VERSION, &found.minor);
  found.version = text_of(GL_VERSION);
  found.renderer = text_of(GL_RENDERER);
  found.platform = platform;
  found.is_software = is_software_renderer(found.renderer);
  found.has_clip_control = epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_ARB_clip_control");
  found.has_persistent_mapping = epoxy_gl_version() >= 44 || epoxy_has_gl_extension("GL_ARB_buffer_storage");
  if (epoxy_has_gl_extension("GL_ARB_texture_filter_anisotropic") ||
      epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic")) {
    glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &found.largest_anisotropy);
  }
  return found;
}

void GLAPIENTRY log_message(GLenum source, GLenum type, GLuint, GLenum severity, GLsizei length,
                            const GLchar* message, const void*) {
  if (source == GL_DEBUG_SOURCE_SHADER_COMPILER) return;  // ShaderProgram reports these
  const std::string_view text(message, static_cast<std::size_t>(length));
  if (type == GL_DEBUG_TYPE_ERROR) {
    spdlog::error("OpenGL: {}", text);
  } else if (severity != GL_DEBUG_SEVERITY_NOTIFICATION && type != GL_DEBUG_TYPE_PERFORMANCE) {
    spdlog::debug("OpenGL: {}", text);
  }
}

void report_messages() {
  if (epoxy_gl_version() < 43 && !epoxy_has_gl_extension("GL_KHR_debug")) return;
  glEnable(GL_DEBUG_OUTPUT);
  glDebugMessageCallback(log_message, nullptr);
}

}  // namespace

struct GlContext::State {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  bool has_glfw = false;
  GLFWwindow* window = nullptr;
  GlCapabilities capabilities;

  State() = default;
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    if (window) glfwDestroyWindow(window);
    if (has_glfw) glfwTerminate();
    if (display == EGL_NO_DISPLAY) return;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    eglTerminate(display);
  }

  /// Takes over a display; what it lacks, or nothing.
  std::string start(EGLDisplay opened);
};

std::string GlContext::State::start(EGLDisplay opened) {
  if (opened == EGL_NO_DISPLAY) return "no display";
  if (!eglInitialize(opened, nullptr, nullptr)) return fmt::format("EGL error {:#x}", eglGetError());
  display = opened;
  if (!epoxy_has_egl_extension(display, "EGL_KHR_surfaceless_context"))
    return "no contexts without a surface";
  if (!epoxy_has_egl_extension(display, "EGL_KHR_no_config_context")) return "no contexts without a format";
  if (!eglBindAPI(EGL_OPENGL_API)) return "no OpenGL but OpenGL ES";
  for (const GlVersion version : wanted_versions) {
    const std::array<EGLint, 7> wish{EGL_CONTEXT_MAJOR_VERSION,
                                     version.major,
                                     EGL_CONTEXT_MINOR_VERSION,
                                     version.minor,
                                     EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                     EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                     EGL_NONE};
    context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wish.data());
    if (context == EGL_NO_CONTEXT) continue;
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) return {};
    eglDestroyContext(display, context);
    context = EGL_NO_CONTEXT;
  }
  return "no core context of version 3.3 or later";
}

GlContext::GlContext(std::unique_ptr<State> state) : state_(std::move(state)) {}
GlContext::GlContext(GlContext&&) noexcept = default;
GlContext& GlContext::operator=(GlContext&&) noexcept = default;
GlContext::~GlContext() = default;

GlContext GlContext::headless() {
  std::string lacks;
  const auto started = [&](const char* platform, EGLDisplay display) {
    auto state = std::make_unique<State>();
    const std::string lack = state->start(display);
    if (lack.empty()) {
      state->capabilities = read_capabilities(platform);
      return state;
    }
    lacks += fmt::format("{}{}: {}", lacks.empty() ? "" : "; ", platform, lack);
    state.reset();
    return state;
  };
  const auto made = [](std::unique_ptr<State> state) {
    report_messages();
    spdlog::debug("OpenGL: {} on {}, {}", state->capabilities.version, state->capabilities.renderer,
                  state->capabilities.platform);
    return GlContext(std::move(state));
  };

  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
    const EGLDisplay display =
        eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (auto state = started("EGL surfaceless", display)) return made(std::move(state));
  } else {
    lacks = "EGL surfaceless: not offered";
  }
  std::array<EGLDeviceEXT, 16> devices{};
  EGLint device_count = 0;
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device")) {
    eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &device_count);
  }
  for (EGLint i = 0; i < device_count; ++i) {
    const EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr);
    if (auto state = started("EGL device", display)) return made(std::move(state));
  }
  throw Error(
      ErrorKind::no_device,
      fmt::format("OpenGL without a window: expected a driver that offers it, found none ({})", lacks),
      "install a driver with EGL, such as the Debian packages libegl1 and libgl1-mesa-dri");
}

GlContext GlContext::window(const WindowSettings& settings) {
  constexpr const char* hint =
      "run it on a machine with a display server, or under xvfb-run; --headless draws without one";
  auto state = std::make_unique<State>();
  const auto fault = [] {
    const char* description = nullptr;
    glfwGetError(&description);
    return std::string(description ? description : "no reason given");
  };
  if (!glfwInit()) {
    throw Error(ErrorKind::no_device, fmt::format("window: expected a display server: {}", fault()), hint);
  }
  state->has_glfw = true;
  for (const GlVersion version : wanted_versions) {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, version.major);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, version.minor);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);  // frames are drawn elsewhere and copied
    glfwWindowHint(GLFW_MAXIMIZED, settings.is_maximised ? GLFW_TRUE : GLFW_FALSE);
    state->window =
        glfwCreateWindow(settings.width, settings.height, settings.title.c_str(), nullptr, nullptr);
    if (state->window) break;
  }
  if (!state->window) {
    throw Error(ErrorKind::no_device, fmt::format("window: expected an OpenGL 3.3 core context: {}", fault()),
                hint);
  }
  glfwMakeContextCurrent(state->window);
  state->capabilities = read_capabilities("window");
  report_messages();
  return GlContext(std::move(state));
}

const GlCapabilities& GlContext::capabilities() const {
  return state_->capabilities;
}

GLFWwindow* GlContext::window_handle() const {
  return state_->window;
}

std::vector<std::intptr_t> GlContext::share_properties() const {
  const auto pointer = [](auto* handle) { return reinterpret_cast<std::intptr_t>(handle); };
  if (state_->context != EGL_NO_CONTEXT) {
    return {cl_gl_context_khr, pointer(state_->context), cl_egl_display_khr, pointer(state_->display)};
  }
  if (GLXContext context = glXGetCurrentContext()) {
    return {cl_gl_context_khr, pointer(context), cl_glx_display_khr, pointer(glXGetCurrentDisplay())};
  }
  return {};
}

void require_no_gl_error(const char* where) {
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR) return;
  while (glGetError() != GL_NO_ERROR) {
  }
  throw Error(ErrorKind::device, fmt::format("OpenGL: {}: error {:#x}", where, error),
              "run again with --verbose and report what the driver says");
}

}  // namespace offing::present
