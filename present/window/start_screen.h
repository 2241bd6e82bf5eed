#pragma once

#include <string>

#include "present/panels/panel_layer.h"
#include "present/passes/world_opening.h"

struct GLFWwindow;

namespace offing::present {

/// What a window shows while a scene is opened: over its picture, which work is being done and how far it is.
class StartScreen {
 public:
  StartScreen(GLFWwindow* window, PanelLayer& panels) : window_(window), panels_(panels) {}

  /// Draws it and takes the window's events, so that its system does not take it for dead.
  void show(const std::string& title, const OpeningStep& step);

 private:
  GLFWwindow* window_;
  PanelLayer& panels_;
};

}  // namespace offing::present
