#pragma once

#include <vector>

#include "host/base/height_map.h"
#include "host/base/work.h"
#include "host/terrain/analysis/viewshed.h"

namespace offing::terrain {

/// How high above each post [rows][columns] a target must be to be seen, m: 0 where the post itself is seen,
/// NaN beyond the radius. The parameters' own target height does not count. The surface is that of Viewshed;
/// each line is walked cell by cell in double precision, in which the slope up to the ground has its greatest
/// value in closed form. Takes time in proportion to posts and cells along a line: 5 s a core for 1025 x 1025
/// posts. Works on all cores. Throws what require_valid() throws, and Error(cancelled).
std::vector<float> needed_heights(const HeightMap& map, const ViewshedParameters& parameters,
                                  const CancelToken& cancel);

}  // namespace offing::terrain
