#pragma once

#include "host/highlights/search/highlight_points.h"
#include "host/highlights/search/surface_place.h"

namespace offing::highlights {

/// A place of a surface as if a highlight stood there: its normal and curvatures, interpolated as the search
/// for highlights does. n_dot_h, light and orientation are those of a point made by default.
HighlightPoint pinned_point(const HighlightSurface& surface, const SurfacePlace& place);

}  // namespace offing::highlights
