#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "host/base/cloud_volume.h"
#include "host/base/error.h"
#include "host/io/vdb/vdb_volume.h"

namespace offing::vdb {

/// Names of what our volumes say beside OpenVDB's own: extinction, 1/m, of density 1.
inline constexpr const char* extinction_name = "extinction_per_m";
inline constexpr const char* bricks_name = "bricks";  ///< of the whole volume, from index 0 on

/// Place in a brick of ours, which has x in neighbouring values, of a value of an OpenVDB leaf, which has z
/// there.
constexpr std::size_t place_in_brick(std::size_t leaf_offset) {
  constexpr std::size_t n = CloudVolume::brick_cells;
  return (leaf_offset % n) * n * n + (leaf_offset / n % n) * n + leaf_offset / (n * n);
}

/// "cloud.vdb: density: expected ..., got ...".
inline Error bad_vdb(const std::filesystem::path& path, std::string_view place, std::string_view expected,
                     std::string_view got, std::string hint) {
  return {ErrorKind::bad_input,
          fmt::format("{}: {}{}expected {}, got {}", one_line(path.string()), place,
                      place.empty() ? "" : ": ", expected, got),
          std::move(hint)};
}

/// The part of a file that is read, for errors: "grid density".
struct PartOfVdb {
  std::filesystem::path path;
  std::string place;
};

inline Error broken_vdb(const PartOfVdb& part, std::string_view got) {
  return bad_vdb(part.path, part.place, "a whole OpenVDB file", got, "copy or write the file again");
}

/// Sets values below 0 by no more than rounding to 0 and throws Error(bad_input), by fail(index, expected,
/// hint), for the first that is not finite or further below.
template <typename Fail>
void clamp_density(std::vector<float>& density, const Fail& fail) {
  float least = 0.0f, most = 0.0f;
  for (std::size_t i = 0; i < density.size(); ++i) {
    if (!(density[i] - density[i] == 0.0f)) fail(i, "finite values", "repair the simulation that made it");
    least = std::min(least, density[i]);
    most = std::max(most, density[i]);
  }
  if (least >= 0.0f) return;
  const double lowest = -vdb_rounding * most;
  for (std::size_t i = 0; i < density.size(); ++i) {
    if (density[i] < lowest) fail(i, "values from 0 on", "clamp it to 0, or name a grid that is a density");
    density[i] = std::max(density[i], 0.0f);
  }
}

}  // namespace offing::vdb
