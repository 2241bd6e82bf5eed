// The maps that a bake writes of each cascade, and the files and channels that have them in each layout.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "host/cli/ocean/bake_settings.h"
#include "host/cli/ocean/frame_maker.h"

namespace offing::cli {

struct BakedMap {
  struct Channel {
    std::string name;  ///< in the file
    const std::vector<float>& (*values)(const BakedFrame::CascadeFields&);
  };
  std::string_view name;          ///< "displacement"
  std::string_view unit;          ///< "m", "m/s"; empty: dimensionless
  std::size_t cascade = 0;        ///< those of wake windows come after all cascades
  std::string file;               ///< what its file's name begins with: "ocean.c0", "ocean.c0_displacement"
  std::vector<Channel> channels;  ///< of a vector: its x, y and z in the axes of the files
};

/// All maps of a bake: cascade by cascade, then wake window by window, those of one file together.
std::vector<BakedMap> baked_maps(const BakeSettings& settings, std::size_t cascades);

/// Throws Error(bad_usage) for groups that the layout has no files for.
void require_maps(const BakeSettings& settings);

/// Makes what is written of a frame agree with the channels of MapAxes::z_up: north is minus south.
void turn_z_up(BakedFrame& frame);

}  // namespace offing::cli
