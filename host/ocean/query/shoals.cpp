#include "host/ocean/query/shoals.h"

#include <cmath>
#include <utility>

#include "host/base/error.h"
#include "kernels/shared/query_params.h"

namespace offing::ocean {
namespace {

ShoalMap device_map(const DepthMap& depths, double deepest_m) {
  constexpr double tile_m = SURFACE_QUERY_TILE_M;
  const double tile_x = std::nearbyint(depths.origin_x_m / tile_m);
  const double tile_z = std::nearbyint(depths.origin_z_m / tile_m);
  return {.tile_x = static_cast<int>(tile_x),
          .tile_z = static_cast<int>(tile_z),
          .origin_x_m = static_cast<float>(depths.origin_x_m - tile_x * tile_m),
          .origin_z_m = static_cast<float>(depths.origin_z_m - tile_z * tile_m),
          .columns_per_m = static_cast<float>(1.0 / depths.spacing_x_m),
          .rows_per_m = static_cast<float>(1.0 / depths.spacing_z_m),
          .columns = depths.columns,
          .rows = depths.rows,
          .deepest_m = static_cast<float>(deepest_m)};
}

const DepthMap& checked(const std::shared_ptr<const DepthMap>& depths, const ShoalTable& table) {
  if (!depths || table.shares().empty()) {
    throw Error(ErrorKind::bad_usage, "shoals: expected depths and a table of shares, found none",
                "make both first");
  }
  require_valid_depths(*depths);
  return *depths;
}

}  // namespace

Shoals::Shoals(const ocl::Device& device, std::shared_ptr<const DepthMap> depths, const ShoalTable& table)
    : map_(device, 1, "shoals") {
  const ShoalMap map = device_map(checked(depths, table), table.deepest_m());
  map_.write(std::span(&map, 1));
  depths_m_ = ocl::Buffer<float>(device, depths->depths_m, "depths over shoals");
  shares_ = ocl::Buffer<float>(device, table.shares(), "shares over shoals");
  instant_ = {.depths = std::move(depths), .table = table};
}

}  // namespace offing::ocean
