// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#pragma once

#include <string>
#include <vector>

#include "host/base/height_map.h"

namespace offing::bench {

struct NamedMap {
  std::string name;
  HeightMap map;
};

/// Made valleys of size + 1 posts a side: the same 20 km of ground, whatever the size.
NamedMap valleys(int size);

enum class RealMaps { andes_and_cape_flattery, all };

/// Real ground of which OFFING_TEST_DATA names the folder; none where it is not set.
std::vector<NamedMap> real_maps(RealMaps which);

}  // namespace offing::bench
