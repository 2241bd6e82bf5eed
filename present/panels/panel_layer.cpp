#include "present/panels/panel_layer.h"

#include <imgui.h>
// The order matters: the backends build on imgui.h.
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>

#include "host/base/error.h"
#include "present/panels/imgui_versions.h"

namespace offing::present {

PanelLayer::PanelLayer(GLFWwindow* window) : window_(window) {
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  ImGui::StyleColorsDark();
  ImGui::GetStyle().WindowRounding = 4.0f;
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

void PanelLayer::begin() {
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
