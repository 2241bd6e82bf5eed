#include "present/editing/objects/handle_overlay.h"

#include <array>
#include <optional>

namespace offing::present {
namespace {

constexpr ImU32 rim_colour = IM_COL32(120, 230, 120, 255);
constexpr std::array<ImU32, 3> colours_of_axes{IM_COL32(240, 80, 80, 255), IM_COL32(110, 220, 90, 255),
                                               IM_COL32(90, 140, 255, 255)};
constexpr double knob_radius = 6.0, knob_half_side = 5.0;

ImU32 axis_colour(ObjectHandle handle, ObjectHandle first) {
  return colours_of_axes[static_cast<std::size_t>(handle) - static_cast<std::size_t>(first)];
}

void draw_rings(const OverlayPainter& painter, const std::vector<ObjectHandlePlace>& places) {
  for (std::size_t i = 0; i < places.size();) {
    const ObjectHandle ring = places[i].handle;
    if (ring < ObjectHandle::turn_x) return;
    std::vector<glm::dvec2> points;
    for (; i < places.size() && places[i].handle == ring; ++i) points.push_back(places[i].place_px);
    painter.outline(points, handle_shade, 3.0);
    painter.outline(points, axis_colour(ring, ObjectHandle::turn_x), 1.5);
  }
}

}  // namespace

OverlayPainter::OverlayPainter(const Screen& screen)
    : list_(*ImGui::GetBackgroundDrawList()),
      scale_(static_cast<double>(ImGui::GetIO().DisplaySize.x) / screen.size_px.x) {}

ImVec2 OverlayPainter::at(glm::dvec2 place) const {
  return {length(place.x), length(place.y)};
}

void OverlayPainter::line(glm::dvec2 from, glm::dvec2 to, ImU32 colour, double width) const {
  list_.AddLine(at(from), at(to), colour, length(width));
}

void OverlayPainter::outline(const std::vector<glm::dvec2>& points, ImU32 colour, double width) const {
  std::vector<ImVec2> drawn;
  for (const glm::dvec2 point : points) drawn.push_back(at(point));
  list_.AddPolyline(drawn.data(), static_cast<int>(drawn.size()), colour, ImDrawFlags_Closed, length(width));
}

void OverlayPainter::disc(glm::dvec2 middle, double radius, ImU32 colour) const {
  list_.AddCircleFilled(at(middle), length(radius), colour);
}

void OverlayPainter::circle(glm::dvec2 middle, double radius, ImU32 colour) const {
  list_.AddCircle(at(middle), length(radius), colour, 0, length(1.0));
}

void OverlayPainter::rectangle(glm::dvec2 low, glm::dvec2 high, ImU32 colour) const {
  list_.AddRectFilled(at(low), at(high), colour);
}

void OverlayPainter::frame(glm::dvec2 low, glm::dvec2 high, ImU32 colour) const {
  list_.AddRect(at(low), at(high), colour, 0.0f, 0, length(1.0));
}

void OverlayPainter::triangle(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, ImU32 colour) const {
  list_.AddTriangleFilled(at(a), at(b), at(c), colour);
}

void OverlayPainter::knob(glm::dvec2 middle, ImU32 colour) const {
  disc(middle, knob_radius, colour);
  circle(middle, knob_radius, handle_shade);
}

void OverlayPainter::square_knob(glm::dvec2 middle, ImU32 colour) const {
  rectangle(middle - knob_half_side, middle + knob_half_side, colour);
  frame(middle - knob_half_side, middle + knob_half_side, handle_shade);
}

glm::dvec2 OverlayPainter::pointer() const {
  const ImVec2 place = ImGui::GetIO().MousePos;
  return glm::dvec2(place.x, place.y) / scale_;
}

void OverlayPainter::shaded_line(glm::dvec2 from, glm::dvec2 to, ImU32 colour) const {
  line(from, to, handle_shade, 2.5);
  line(from, to, colour, 1.0);
}

void draw_object_handles(const OverlayPainter& painter, const Screen& screen, const Sphere& sphere,
                         HandleSet handles) {
  const std::optional<glm::dvec2> middle_px = pixel_of(screen, sphere.centre_m);
  if (!middle_px) return;
  const std::vector<ObjectHandlePlace> places = object_handle_places(screen, sphere, handles);
  draw_rings(painter, places);
  for (const ObjectHandlePlace& place : places) {
    if (place.handle >= ObjectHandle::turn_x) continue;
    if (place.handle <= ObjectHandle::z) {
      const ImU32 colour = axis_colour(place.handle, ObjectHandle::x);
      painter.line(*middle_px, place.place_px, colour, 2.0);
      painter.knob(place.place_px, colour);
    } else if (place.handle <= ObjectHandle::plane_z) {
      painter.square_knob(place.place_px, axis_colour(place.handle, ObjectHandle::plane_x));
    } else if (place.handle == ObjectHandle::radius || place.handle == ObjectHandle::side) {
      painter.square_knob(place.place_px, rim_colour);
    } else {
      painter.knob(place.place_px, selected_colour);
    }
  }
}

void explain_object_handle(const OverlayPainter& painter, const Screen& screen, const Sphere& sphere,
                           HandleSet handles) {
  const std::optional<ObjectHandle> handle =
      object_handle_at(object_handle_places(screen, sphere, handles), painter.pointer());
  if (handle) explain_handle(handle_help(*handle));
}

void explain_handle(const std::string& help) {
  if (ImGui::GetIO().WantCaptureMouse || ImGui::IsMouseDown(ImGuiMouseButton_Left)) return;
  ImGui::SetTooltip("%s", help.c_str());
}

}  // namespace offing::present
