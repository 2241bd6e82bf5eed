#include "host/cli/terrain/flight_recorder.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <sys/resource.h>

#include "host/cli/pictures/terrain_render.h"
#include "host/sky/sun_position.h"
#include "host/terrain/cast/image_rays.h"

namespace offing::cli {

FlightRecorder::FlightRecorder(const ocl::Device& device, const Camera& first, double latitude_deg)
    : device_(device),
      sky_(device, atmosphere_),
      shade_(device),
      hits_(device, terrain::pixel_count(first), "terrain hits"),
      image_(device, terrain::pixel_count(first), "terrain image") {
  const TerrainScenery scenery;
  sky_.at({.sun_direction = sky::direction_of(scenery.sun_azimuth_rad, scenery.sun_elevation_rad),
           .eye_altitude_m = std::max(0.0, first.eye_m.y)});
  light_ = world::terrain_light(sky_.read_illuminance(), atmosphere_, world::cover_lines(latitude_deg));
}

double FlightRecorder::draw(terrain::TiledField& field, const Camera& camera, double ahead_m) {
  const auto start = std::chrono::steady_clock::now();
  field.look(camera, ahead_m);
  field.cast(camera, hits_);
  shade_.at(field, camera, hits_, {light_, sky_.params(), sky_.view_table()}, image_);
  device_.finish();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

FrameTimes frame_times(std::vector<double> seconds) {
  std::sort(seconds.begin(), seconds.end());
  const auto at = [&](double share) {
    return seconds[static_cast<std::size_t>(std::ceil(share * static_cast<double>(seconds.size()))) - 1];
  };
  return {at(0.5), at(0.99), seconds.back()};
}

std::size_t peak_resident_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

}  // namespace offing::cli
