#pragma once

#include <cstddef>
#include <vector>

#include "host/base/camera.h"
#include "host/ocl/device.h"
#include "host/sky/clear_sky.h"
#include "host/terrain/shading/terrain_shade.h"
#include "host/terrain/tiles/tiled_field.h"
#include "host/world/terrain_light.h"

namespace offing::cli {

/// Draws the frames of a flight on a device and times them: rays and light, under one sky.
class FlightRecorder {
 public:
  FlightRecorder(const ocl::Device& device, const Camera& first, double latitude_deg);

  /// Draws the frame; returns the seconds that it took, the choice of tiles included.
  double draw(terrain::TiledField& field, const Camera& camera, double ahead_m);

  /// What the last frame's rays hit.
  std::vector<TerrainHit> read_hits() const { return hits_.read(); }

 private:
  ocl::Device device_;
  sky::Atmosphere atmosphere_;
  sky::ClearSky sky_;
  TerrainLight light_;
  terrain::TerrainShade shade_;
  ocl::Buffer<TerrainHit> hits_;
  ocl::Buffer<terrain::Texel> image_;
};

/// Frame times by rank.
struct FrameTimes {
  double median_s = 0.0, slowest_hundredth_s = 0.0, worst_s = 0.0;
};
FrameTimes frame_times(std::vector<double> seconds);

/// Largest memory that the process has had, bytes.
std::size_t peak_resident_bytes();

}  // namespace offing::cli
