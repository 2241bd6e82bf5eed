#pragma once

#include <vector>

#include "host/base/triangle_mesh.h"
#include "host/highlights/search/highlight_points.h"

namespace offing::test {

/// Highlight points of one light by brute force in double precision: on each face Newton's method for N(b) x
/// H(x(b)) = 0 with N interpolated and H of the place itself; kept where all weights are >= -slack. Points of
/// neighbours may coincide.
std::vector<highlights::HighlightPoint> reference_points(const TriangleMesh& mesh,
                                                         const highlights::Source& eye,
                                                         const highlights::Source& light, double slack);

}  // namespace offing::test
