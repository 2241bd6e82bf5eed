#include "present/window/start_screen.h"

#include <algorithm>

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

namespace offing::present {

void StartScreen::show(const std::string& title, const OpeningStep& step) {
  glfwPollEvents();
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, width, height);
  glClearColor(0.05f, 0.07f, 0.09f, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT);
  const std::string text = fmt::format("{}\npreparing {}", title, step.work);
  panels_.need(text);
  panels_.begin();
  const ImVec2 screen = ImGui::GetIO().DisplaySize, padding = ImGui::GetStyle().WindowPadding;
  const ImVec2 bar(16.0f * ImGui::GetFontSize(), ImGui::GetFrameHeight());
  const ImVec2 words = ImGui::CalcTextSize(text.c_str());
  // ImGui hides a window in its first frame unless it is given a size; the next frame may be a second away.
  ImGui::SetNextWindowSize(ImVec2(std::max(bar.x, words.x) + 2.0f * padding.x,
                                  words.y + ImGui::GetStyle().ItemSpacing.y + bar.y + 2.0f * padding.y));
  ImGui::SetNextWindowPos(ImVec2(0.5f * screen.x, 0.5f * screen.y), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
  constexpr ImGuiWindowFlags plain =
      ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoSavedSettings;
  ImGui::Begin("start", nullptr, plain);
  ImGui::TextUnformatted(text.c_str());
  // Where the share is not known, a dot that moves shows that work goes on.
  constexpr int places = 24;
  const auto place = static_cast<int>(glfwGetTime() * 8.0) % places;
  if (step.share) {
    ImGui::ProgressBar(static_cast<float>(*step.share), bar);
  } else {
    std::string dots(places, '.');
    dots[static_cast<std::size_t>(place)] = 'o';
    ImGui::TextUnformatted(dots.c_str());
  }
  ImGui::End();
  panels_.end();
  glfwSwapBuffers(window_);
}

}  // namespace offing::present
