// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#pragma once

#include <string>
#include <vector>

#include "host/base/camera.h"
#include "host/base/height_map.h"

namespace offing::bench {

struct TerrainCamera {
  std::string way;  ///< "fly" or "walk"
  Camera camera;
};

/// The cameras of scenes/bench_terrain.toml on this map: those that fly, then those that walk. Throws
/// Error(bad_input) for a file that is not as that one is.
std::vector<TerrainCamera> terrain_cameras(const HeightMap& map);

}  // namespace offing::bench
