#include "host/base/cloud_volume.h"

#include <cmath>

#include <fmt/format.h>

#include "host/base/error.h"

namespace offing {
namespace {

void require(bool holds, const std::string& what) {
  if (holds) return;
  throw Error(ErrorKind::bad_input, "cloud volume: " + what, "the file or program that made it is at fault");
}

}  // namespace

void require_valid(const CloudVolume& volume) {
  require(volume.cell_m > 0.0 && std::isfinite(volume.cell_m),
          fmt::format("expected a cell above 0 m, found {:g}", volume.cell_m));
  require(volume.extinction_per_m > 0.0 && std::isfinite(volume.extinction_per_m),
          fmt::format("expected an extinction above 0, found {:g}", volume.extinction_per_m));
  require(std::isfinite(volume.origin_m.x) && std::isfinite(volume.origin_m.y) &&
              std::isfinite(volume.origin_m.z),
          "expected a finite origin");
  double bricks = 1.0;
  for (const int count : volume.bricks) {
    require(count >= 0, fmt::format("expected no negative count of bricks, found {}", count));
    bricks *= count;
  }
  require(bricks == static_cast<double>(volume.brick_of.size()),
          fmt::format("expected {:g} places of bricks, found {}", bricks, volume.brick_of.size()));
  const std::size_t kept = volume.density.size() / CloudVolume::cells_of_brick;
  require(volume.density.size() % CloudVolume::cells_of_brick == 0,
          fmt::format("expected whole bricks of {} cells, found {} cells", CloudVolume::cells_of_brick,
                      volume.density.size()));
  require(volume.albedo.empty() || volume.albedo.size() == volume.density.size(),
          fmt::format("expected an albedo for each of {} cells, found {}", volume.density.size(),
                      volume.albedo.size()));
  for (const std::int32_t place : volume.brick_of) {
    require(place == CloudVolume::no_brick || (place >= 0 && static_cast<std::size_t>(place) < kept),
            fmt::format("expected places below {}, found {}", kept, place));
  }
  for (const float density : volume.density) {
    require(density >= 0.0f && std::isfinite(density),
            fmt::format("expected finite densities of 0 or more, found {}", density));
  }
}

}  // namespace offing
