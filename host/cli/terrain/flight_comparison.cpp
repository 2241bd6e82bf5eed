#include "host/cli/terrain/flight_comparison.h"

#include <algorithm>
#include <cmath>

#include "host/terrain/cast/image_rays.h"

namespace offing::cli {

void FlightComparison::add(const ocl::Device& device, const Camera& camera,
                           const std::vector<bool>& sky_flown, const std::vector<TerrainHit>& loaded) {
  ocl::Buffer<float> distances(device, terrain::pixel_count(camera), "distances");
  field_.cast(camera, distances);
  const std::vector<float> map_m = distances.read();
  ++result_.frames;
  result_.pixels += map_m.size();
  for (std::size_t i = 0; i < map_m.size(); ++i) {
    const bool is_ground = std::isfinite(map_m[i]);
    if (is_ground) {
      result_.holes_flown += sky_flown[i] ? 1 : 0;
      result_.holes_loaded += loaded[i].kind == TERRAIN_MISS ? 1 : 0;
      if (loaded[i].kind != TERRAIN_MISS) {
        errors_.push_back(std::abs(loaded[i].distance_m - map_m[i]) / std::max(map_m[i], 1e-3f));
      }
    } else {
      result_.raised += loaded[i].kind == TERRAIN_MISS ? 0 : 1;
    }
  }
}

FlightComparison::Result FlightComparison::result() const {
  Result result = result_;
  if (errors_.empty()) return result;
  std::vector<float> errors = errors_;
  const auto at = [&](double share) {
    const auto place =
        errors.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(errors.size() - 1));
    std::nth_element(errors.begin(), place, errors.end());
    return static_cast<double>(*place);
  };
  result.median_error = at(0.5);
  result.worst_hundredth_error = at(0.99);
  return result;
}

}  // namespace offing::cli
