#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "present/gl/gl_objects.h"
#include "present/gl/render_target.h"
#include "present/gl/shader_program.h"
#include "present/panels/look.h"
#include "present/panels/panel_fonts.h"
#include "present/panels/panel_keys.h"

struct GLFWwindow;
struct ImDrawData;

namespace offing::present {

/// ImGui in a window or, without one, on the bound framebuffer: begin, any panels, end. One at a time.
class PanelLayer {
 public:
  /// With a window, events reach the panels after the callbacks that it has already; nullptr: no events but
  /// those that a test feeds. No file remembers where panels were. `scale`: of panels and letters; absent:
  /// that of the window's monitor.
  explicit PanelLayer(GLFWwindow* window, std::optional<double> scale = {});
  PanelLayer(const PanelLayer&) = delete;
  PanelLayer& operator=(const PanelLayer&) = delete;
  ~PanelLayer();

  /// A text of the next frame that may have letters of any language, UTF-8.
  void need(std::string_view text) { fonts_.need(text); }
  /// Closes lists, menus and dialogs that have popped up; false if there were none.
  bool close_popups();
  /// Whether an item is held or takes text, which panels then have to follow without input too.
  bool is_in_use() const;
  /// How many of the window's units one of a usual monitor is.
  float scale() const;
  /// Letters and colours of the frames from here on.
  void set_look(const Look& look);
  void begin();
  /// Draws the panels onto the bound framebuffer.
  void end();
  /// Draws what end() drew last, once more: a copy of its pixels, at a fifth of the time.
  void repeat();

 private:
  /// A part of the framebuffer, in pixels.
  struct Part {
    int left, bottom, right, top;
  };
  /// Of these panels, none over another.
  static std::vector<Part> parts_of(const ImDrawData& panels);

  GLFWwindow* window_;
  std::optional<PanelKeys> keys_;  // before ImGui 1.87
  std::optional<double> scale_;
  PanelFonts fonts_;
  std::optional<Look> look_;
  float text_px_ = 0.0f;
  RenderTarget drawn_;  // what end() drew, premultiplied
  std::vector<Part> parts_;
  std::optional<ShaderProgram> copy_;
  std::optional<GlVertexArray> no_vertices_;
};

}  // namespace offing::present
