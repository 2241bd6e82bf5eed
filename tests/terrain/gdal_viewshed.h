#pragma once

#include <cstdint>
#include <vector>

#include "host/base/height_map.h"
#include "host/terrain/viewshed.h"

namespace offing::test {

/// What GDAL's viewshed says, [rows][columns], 255 seen and 0 not, of an observer at a post: an approximate
/// sweep over the posts. The map's heights as they are, voids filled.
std::vector<std::uint8_t> gdal_viewshed(const offing::HeightMap& map,
                                        const terrain::ViewshedParameters& parameters);

}  // namespace offing::test
