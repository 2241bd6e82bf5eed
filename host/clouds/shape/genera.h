#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "host/clouds/shape/cloud_parameters.h"

namespace offing::clouds {

/// Where clouds of a genus are found: World Meteorological Organization 2017, International cloud atlas,
/// heights of middle latitudes, and common thicknesses.
struct GenusRange {
  std::string_view name;
  double lowest_base_m, highest_base_m;  ///< above the sea
  double thickness_m;                    ///< of the preset
  double width_m;                        ///< of the preset, along its longer side
};

GenusRange range_of(Genus genus);

/// In the order of menus.
inline constexpr std::array all_genera{Genus::cirrus,        Genus::stratus,     Genus::cumulus,
                                       Genus::stratocumulus, Genus::altocumulus, Genus::cumulonimbus,
                                       Genus::lenticular,    Genus::funnel};

/// Genus by its name, "cumulus". Throws Error(bad_input) that lists the names.
Genus genus_named(std::string_view name);

/// A cloud of a genus (C6, C15), its base at y = 0 of its axes (the ground's end of a funnel hangs below),
/// its position at the middle of the genus' heights over the world's origin. Another seed is another cloud of
/// the same kind; size stretches all its lengths.
CloudParameters preset(Genus genus, std::uint64_t seed = 1, double size = 1.0);

}  // namespace offing::clouds
