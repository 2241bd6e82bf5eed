#include "host/base/cloud_volume.h"

#include <cmath>

#include <fmt/format.h>

#include "host/base/error.h"

namespace offing {
namespace {

/// `what` and its arguments make the message, only where it is needed: there may be 10^8 values to check.
template <typename... Arguments>
void require(bool holds, fmt::format_string<const Arguments&...> what, const Arguments&... arguments) {
  if (holds) return;
  throw Error(ErrorKind::bad_input, "cloud volume: " + fmt::format(what, arguments...),
              "check the file or the program that made it");
}

}  // namespace

void require_valid(const CloudVolume& volume) {
  require(volume.cell_m > 0.0 && std::isfinite(volume.cell_m), "expected a cell above 0 m, found {:g}",
          volume.cell_m);
  require(volume.extinction_per_m > 0.0 && std::isfinite(volume.extinction_per_m),
          "expected an extinction above 0, found {:g}", volume.extinction_per_m);
  require(std::isfinite(volume.origin_m.x) && std::isfinite(volume.origin_m.y) &&
              std::isfinite(volume.origin_m.z),
          "expected a finite origin");
  double bricks = 1.0;
  for (const int count : volume.bricks) {
    require(count >= 0, "expected no negative count of bricks, found {}", count);
    bricks *= count;
  }
  require(bricks == static_cast<double>(volume.brick_of.size()), "expected {:g} places of bricks, found {}",
          bricks, volume.brick_of.size());
  const std::size_t kept = volume.density.size() / CloudVolume::cells_of_brick;
  require(volume.density.size() % CloudVolume::cells_of_brick == 0,
          "expected whole bricks of {} cells, found {} cells", CloudVolume::cells_of_brick,
          volume.density.size());
  require(volume.albedo.empty() || volume.albedo.size() == volume.density.size(),
          "expected an albedo for each of {} cells, found {}", volume.density.size(), volume.albedo.size());
  for (const std::int32_t place : volume.brick_of) {
    require(place == CloudVolume::no_brick || (place >= 0 && static_cast<std::size_t>(place) < kept),
            "expected places below {}, found {}", kept, place);
  }
  for (const float density : volume.density) {
    require(density >= 0.0f && std::isfinite(density), "expected finite densities of 0 or more, found {}",
            density);
  }
}

}  // namespace offing
