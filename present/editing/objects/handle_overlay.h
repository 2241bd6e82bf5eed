#pragma once

#include <string>
#include <vector>

#include <imgui.h>

#include "present/editing/objects/object_handles.h"

namespace offing::present {

/// What handles and outlines of what is selected are drawn in.
inline constexpr ImU32 selected_colour = IM_COL32(255, 200, 40, 255), handle_shade = IM_COL32(0, 0, 0, 160);

/// Draws behind ImGui's windows, all places and lengths in pixels of a screen.
class OverlayPainter {
 public:
  explicit OverlayPainter(const Screen& screen);

  void line(glm::dvec2 from, glm::dvec2 to, ImU32 colour, double width) const;
  /// Through all points, and back to the first one.
  void outline(const std::vector<glm::dvec2>& points, ImU32 colour, double width) const;
  void disc(glm::dvec2 middle, double radius, ImU32 colour) const;
  void circle(glm::dvec2 middle, double radius, ImU32 colour) const;
  void rectangle(glm::dvec2 low, glm::dvec2 high, ImU32 colour) const;
  void frame(glm::dvec2 low, glm::dvec2 high, ImU32 colour) const;
  void triangle(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, ImU32 colour) const;
  /// Of a handle: a disc or a square with a dark edge.
  void knob(glm::dvec2 middle, ImU32 colour) const;
  void square_knob(glm::dvec2 middle, ImU32 colour) const;
  /// Where the mouse is.
  glm::dvec2 pointer() const;
  /// Over a bright and a dark picture.
  void shaded_line(glm::dvec2 from, glm::dvec2 to, ImU32 colour) const;

 private:
  ImVec2 at(glm::dvec2 place) const;
  float length(double px) const { return static_cast<float>(scale_ * px); }

  ImDrawList& list_;
  double scale_;  // ImGui's pixels of one of the screen
};

/// Draws the handles of a sphere.
void draw_object_handles(const OverlayPainter& painter, const Screen& screen, const Sphere& sphere,
                         HandleSet handles);
/// Shows help on the handle under the mouse.
void explain_object_handle(const OverlayPainter& painter, const Screen& screen, const Sphere& sphere,
                           HandleSet handles);
/// Shows help on a handle beside the mouse, but not while a mouse button is held or over a panel.
void explain_handle(const std::string& help);

}  // namespace offing::present
