#pragma once

#include "host/highlights/projectors/highlight_rule.h"
#include "host/highlights/projectors/projector.h"
#include "host/highlights/search/surface_walk.h"

namespace offing::highlights {

/// A projector with the place of the surface under its middle.
struct PlacedProjector {
  Projector projector;
  SurfacePlace place;
};

/// Widths changed by squareness, anisotropy and scale, in this order, and axes by upright and the rotation.
Projector reshaped(const Projector& projector, const HighlightControls& controls);

/// The same `way_m` further, in its own right and up, over the surface: its middle and its axes go along.
PlacedProjector moved(const HighlightSurface& surface, const PlacedProjector& placed,
                      const glm::dvec2& way_m);

/// How far along right the middle of a copy is, and how wide each one is: shares of the width of the one that
/// was split.
struct CopyPlace {
  double middle = 0.0, width = 1.0;
};
CopyPlace copy_place(const HighlightControls& controls, int copy);

}  // namespace offing::highlights
