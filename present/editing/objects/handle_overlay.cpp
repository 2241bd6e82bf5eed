#include "present/editing/objects/handle_overlay.h"

#include <array>
#include <optional>
#include <vector>

namespace offing::present {
namespace {

constexpr ImU32 rim_colour = IM_COL32(120, 230, 120, 255);
constexpr std::array<ImU32, 3> colours_of_axes{IM_COL32(240, 80, 80, 255), IM_COL32(110, 220, 90, 255),
                                               IM_COL32(90, 140, 255, 255)};

ImU32 axis_colour(ObjectHandle handle, ObjectHandle first) {
  return colours_of_axes[static_cast<std::size_t>(handle) - static_cast<std::size_t>(first)];
}

void draw_rings(ImDrawList& list, const std::vector<ObjectHandlePlace>& places) {
  for (std::size_t i = 0; i < places.size();) {
    const ObjectHandle ring = places[i].handle;
    if (ring < ObjectHandle::turn_x) return;
    std::vector<ImVec2> points;
    for (; i < places.size() && places[i].handle == ring; ++i)
      points.push_back(screen_point(places[i].place_px));
    const int count = static_cast<int>(points.size());
    list.AddPolyline(points.data(), count, handle_shade, ImDrawFlags_Closed, 3.0f);
    list.AddPolyline(points.data(), count, axis_colour(ring, ObjectHandle::turn_x), ImDrawFlags_Closed, 1.5f);
  }
}

}  // namespace

void draw_object_handles(ImDrawList& list, const Screen& screen, const Sphere& sphere, HandleSet handles) {
  const std::optional<glm::dvec2> middle_px = pixel_of(screen, sphere.centre_m);
  if (!middle_px) return;
  const ImVec2 middle = screen_point(*middle_px);
  const std::vector<ObjectHandlePlace> places = object_handle_places(screen, sphere, handles);
  draw_rings(list, places);
  for (const ObjectHandlePlace& place : places) {
    const ImVec2 at = screen_point(place.place_px);
    const ImVec2 low(at.x - 5.0f, at.y - 5.0f), high(at.x + 5.0f, at.y + 5.0f);
    if (place.handle >= ObjectHandle::turn_x) continue;
    if (place.handle <= ObjectHandle::z) {
      const ImU32 colour = axis_colour(place.handle, ObjectHandle::x);
      list.AddLine(middle, at, colour, 2.0f);
      list.AddCircleFilled(at, 6.0f, colour);
      list.AddCircle(at, 6.0f, handle_shade);
    } else if (place.handle <= ObjectHandle::plane_z) {
      list.AddRectFilled(low, high, axis_colour(place.handle, ObjectHandle::plane_x));
      list.AddRect(low, high, handle_shade);
    } else if (place.handle == ObjectHandle::radius) {
      list.AddRectFilled(low, high, rim_colour);
      list.AddRect(low, high, handle_shade);
    } else {
      list.AddCircleFilled(at, 6.0f, selected_colour);
      list.AddCircle(at, 6.0f, handle_shade);
    }
  }
}

}  // namespace offing::present
