#pragma once

#include <vector>

#include "host/highlights/search/highlight_points.h"

namespace offing::highlights {

/// Of points of one light on neighbouring faces that are one point within a tenth of a mean edge, the one
/// with the largest N.H, the first of equals. For searches that decide face by face.
std::vector<HighlightPoint> merged_points(const HighlightSurface& surface,
                                          const std::vector<HighlightPoint>& points);

}  // namespace offing::highlights
