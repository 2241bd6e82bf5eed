#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

struct GLFWwindow;

namespace offing::present {

/// What the context at hand can do, as it reports it.
struct GlCapabilities {
  int major = 0, minor = 0;
  std::string version;   ///< GL_VERSION
  std::string renderer;  ///< GL_RENDERER
  std::string platform;  ///< how the context was made: "EGL surfaceless", "EGL device", "window"
  /// The CPU draws: pictures are kept small, without multisampling and anisotropic filters.
  bool is_software = false;
  bool has_clip_control = false;        ///< depth from 0 to 1 in clip space, which reversed depth wants
  bool has_persistent_mapping = false;  ///< GL_ARB_buffer_storage
  float largest_anisotropy = 1.0f;      ///< 1: no anisotropic filter
};

struct WindowSettings {
  std::string title = "Offing";
  int width = 1280, height = 720;
  bool is_maximised = false;
};

/// An OpenGL core context of version 4.5, 4.1 or 3.3, the highest that there is, current on the thread that
/// made it until its end. All other OpenGL objects are made after it and go before it.
class GlContext {
 public:
  /// A context without a window, a display server or a graphics device: EGL's surfaceless platform, else its
  /// devices one after another. Throws Error(no_device) that says what each way lacked.
  static GlContext headless();
  /// A context with a window. Throws Error(no_device) if there is no display server or no context.
  static GlContext window(const WindowSettings& settings);

  GlContext(GlContext&&) noexcept;
  GlContext& operator=(GlContext&&) noexcept;
  ~GlContext();

  const GlCapabilities& capabilities() const;

  /// The window, nullptr without one.
  GLFWwindow* window_handle() const;

  /// What clCreateContext needs to share objects with this context (cl_khr_gl_sharing): pairs of property and
  /// value without the closing zero; empty where that cannot be.
  std::vector<std::intptr_t> share_properties() const;

 private:
  struct State;
  explicit GlContext(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Throws Error(device) that names `where` if OpenGL has recorded an error since the last call.
void require_no_gl_error(const char* where);

}  // namespace offing::present
