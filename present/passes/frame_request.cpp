#include "present/passes/frame_request.h"

#include <epoxy/gl.h>

namespace offing::present {

std::string_view to_string(WaterShow show) {
  constexpr std::array<std::string_view, all_water_shows.size()> names{
      "none", "height",    "slope",     "jacobian",  "foam",     "footprint",
      "grid", "cascade 0", "cascade 1", "cascade 2", "cascade 3"};
  return names[static_cast<std::size_t>(show)];
}

bool FrameRequest::is_wanted() const {
  if (!goes_on) return true;
  glFinish();
  return goes_on();
}

std::string_view to_string(MeshShow show) {
  constexpr std::array<std::string_view, all_mesh_shows.size()> names{"light",      "curvature", "directions",
                                                                      "projectors", "regions",   "ids"};
  return names[static_cast<std::size_t>(show)];
}

}  // namespace offing::present
