#include "present/panels/panel_layer.h"

#include <algorithm>
#include <cmath>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
// The order matters: the backends build on imgui.h.
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>

#include "host/base/error.h"
#include "present/panels/imgui_versions.h"

namespace offing::present {
namespace {

constexpr float usual_text_px = 16.0f;

float monitor_scale(GLFWwindow* window) {
  if (window == nullptr) return 1.0f;
  float scale = 1.0f, ignored = 1.0f;
  glfwGetWindowContentScale(window, &scale, &ignored);
  // Some systems scale the window's units themselves.
  int units = 0, pixels = 0;
  glfwGetWindowSize(window, &units, nullptr);
  glfwGetFramebufferSize(window, &pixels, nullptr);
  if (units > 0 && pixels > 0) scale *= static_cast<float>(units) / static_cast<float>(pixels);
  return std::clamp(scale, 0.5f, 4.0f);
}

}  // namespace

PanelLayer::PanelLayer(GLFWwindow* window, std::optional<double> scale) : window_(window), scale_(scale) {
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  ImGui::GetIO().ConfigDragClickToInputText = true;  // as sliders do
  if (window != nullptr && !imgui_keeps_input) keys_.emplace(window);
  const bool has_events = window == nullptr || ImGui_ImplGlfw_InitForOpenGL(window, true);
  if (!has_events || !ImGui_ImplOpenGL3_Init("#version 330 core")) {
    throw Error(ErrorKind::device, "panels: they cannot be drawn with this OpenGL",
                "pictures need none: --headless -o out.png");
  }
  keep_opengl_loaded();
  if (keys_) keys_->listen();
}

PanelLayer::~PanelLayer() {
  ImGui_ImplOpenGL3_Shutdown();
  if (window_ != nullptr) ImGui_ImplGlfw_Shutdown();
  keys_.reset();
  ImGui::DestroyContext();
}

bool PanelLayer::close_popups() {
  if (!ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel)) return false;
  ImGui::SetWindowFocus(nullptr);  // which closes all that belong to another window
  return true;
}

bool PanelLayer::is_in_use() const {
  const bool are_keys_waiting = keys_ && keys_->are_waiting();
  return ImGui::IsAnyItemActive() || ImGui::GetIO().WantTextInput || has_waiting_input() || are_keys_waiting;
}

float PanelLayer::scale() const {
  return scale_ ? static_cast<float>(*scale_) : monitor_scale(window_);
}

void PanelLayer::set_look(const Look& look) {
  const float text_px = usual_text_px * look.text_scale * scale();
  if (look_ == look && text_px_ == text_px) return;
  look_ = look;
  text_px_ = text_px;
  set_style(look.theme, text_px);
  fonts_.set_height(text_px);
}

void PanelLayer::begin() {
  if (!look_) set_look({});
  ImGui_ImplOpenGL3_NewFrame();
  if (fonts_.update()) renew_font_texture();
  if (keys_) keys_->pass();
  if (window_ != nullptr) ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

std::vector<PanelLayer::Part> PanelLayer::parts_of(const ImDrawData& panels) {
  std::vector<Part> parts;
  const ImVec2 scale = panels.FramebufferScale, size = panels.DisplaySize;
  for (int i = 0; i < panels.CmdListsCount; ++i) {
    ImVec2 low = size, high(0.0f, 0.0f);
    for (const ImDrawVert& vertex : panels.CmdLists[i]->VtxBuffer) {
      low = {std::min(low.x, vertex.pos.x), std::min(low.y, vertex.pos.y)};
      high = {std::max(high.x, vertex.pos.x), std::max(high.y, vertex.pos.y)};
    }
    Part part{.left = static_cast<int>(std::floor(scale.x * std::max(low.x, 0.0f))),
              .bottom = static_cast<int>(std::floor(scale.y * (size.y - std::min(high.y, size.y)))),
              .right = static_cast<int>(std::ceil(scale.x * std::min(high.x, size.x))),
              .top = static_cast<int>(std::ceil(scale.y * (size.y - std::max(low.y, 0.0f))))};
    if (part.left >= part.right || part.bottom >= part.top) continue;
    // What lies over others is one part with them.
    const auto overlaps = [&](const Part& other) {
      return other.left < part.right && part.left < other.right && other.bottom < part.top &&
             part.bottom < other.top;
    };
    for (auto other = parts.begin(); other != parts.end();) {
      if (!overlaps(*other)) {
        ++other;
        continue;
      }
      part = {std::min(part.left, other->left), std::min(part.bottom, other->bottom),
              std::max(part.right, other->right), std::max(part.top, other->top)};
      parts.erase(other);
      other = parts.begin();
    }
    parts.push_back(part);
  }
  return parts;
}

void PanelLayer::end() {
  ImGui::Render();
  ImDrawData* panels = ImGui::GetDrawData();
  const int width = static_cast<int>(panels->DisplaySize.x * panels->FramebufferScale.x);
  const int height = static_cast<int>(panels->DisplaySize.y * panels->FramebufferScale.y);
  parts_.clear();
  if (width <= 0 || height <= 0) return;
  GLint framebuffer = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
  if (drawn_.width() != width || drawn_.height() != height)
    drawn_ = RenderTarget(width, height, GL_RGBA8, RenderTarget::Depth::none);
  drawn_.bind();
  glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(panels);
  glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(framebuffer));
  parts_ = parts_of(*panels);
  repeat();
}

void PanelLayer::repeat() {
  constexpr int drawn_unit = 0;
  if (parts_.empty()) return;
  if (!copy_) {
    copy_.emplace(
        ShaderStages{.vertex = {shader_file("screen.vert")}, .fragment = {shader_file("panels.frag")}});
    no_vertices_ = GlVertexArray::make();
  }
  glViewport(0, 0, drawn_.width(), drawn_.height());
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glEnable(GL_SCISSOR_TEST);
  glBindVertexArray(no_vertices_->name());
  copy_->use();
  bind_sampler(*copy_, "drawn", drawn_unit, drawn_.texture());
  for (const Part& part : parts_) {
    glScissor(part.left, part.bottom, part.right - part.left, part.top - part.bottom);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_BLEND);
}

}  // namespace offing::present
