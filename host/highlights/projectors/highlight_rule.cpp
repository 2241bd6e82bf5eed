#include "host/highlights/projectors/highlight_rule.h"

#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/parameter_check.h"

namespace offing::highlights {
namespace {

void require_finite(std::string_view name, const std::optional<glm::dvec3>& place_m) {
  if (!place_m || (std::isfinite(place_m->x) && std::isfinite(place_m->y) && std::isfinite(place_m->z)))
    return;
  throw Error(ErrorKind::bad_input,
              fmt::format("highlight: {}: expected three finite numbers, found {:g} {:g} {:g}", name,
                          place_m->x, place_m->y, place_m->z),
              fmt::format("give {} a place of the mesh, in metres", name));
}

}  // namespace

void require_valid(const HighlightRule& rule) {
  require_finite("nearest_m", rule.nearest_m);
  require_finite("pin_m", rule.pin_m);
  require_finite("mask_m", rule.mask_m);
  require_within("highlight.mask_radius_m", rule.mask_radius_m, 0.0, 1e12);
  const HighlightControls& controls = rule.controls;
  require_within("highlight.offset", controls.offset.x, -most_offset, most_offset);
  require_within("highlight.offset", controls.offset.y, -most_offset, most_offset);
  require_within("highlight.rotation_rad", controls.rotation_rad, -1e6, 1e6);
  require_within("highlight.upright", controls.upright, 0.0, 1.0);
  require_within("highlight.scale", controls.scale, 1e-3, 1e3);
  require_within("highlight.anisotropy", controls.anisotropy, -1.0, 1.0);
  require_within("highlight.squareness", controls.squareness, 0.0, 1.0);
  require_within("highlight.split", controls.split, 1.0, most_copies);
  require_within("highlight.split_gap", controls.split_gap, 0.0, 100.0);
  for (int channel = 0; channel < 3; ++channel)
    require_within("highlight.colour", controls.colour[channel], 0.0, 1e6);
  require_within("highlight.opacity", controls.opacity, 0.0, 1.0);
  require_within("highlight.softness", controls.softness, 0.0, 1.0);
}

}  // namespace offing::highlights
