#include "present/panels/panel_layer.h"

#include <algorithm>

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
  const bool has_events = window == nullptr || ImGui_ImplGlfw_InitForOpenGL(window, true);
  if (!has_events || !ImGui_ImplOpenGL3_Init("#version 330 core")) {
    throw Error(ErrorKind::device, "panels: they cannot be drawn with this OpenGL",
                "pictures need none: --headless -o out.png");
  }
  keep_opengl_loaded();
}

PanelLayer::~PanelLayer() {
  ImGui_ImplOpenGL3_Shutdown();
  if (window_ != nullptr) ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

bool PanelLayer::close_popups() {
  if (!ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel)) return false;
  ImGui::SetWindowFocus(nullptr);  // which closes all that belong to another window
  return true;
}

bool PanelLayer::is_in_use() const {
  return ImGui::IsAnyItemActive() || ImGui::GetIO().WantTextInput || has_waiting_input();
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
  if (window_ != nullptr) ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

void PanelLayer::end() {
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void PanelLayer::repeat() {
  if (ImDrawData* drawn = ImGui::GetDrawData()) ImGui_ImplOpenGL3_RenderDrawData(drawn);
}

}  // namespace offing::present
