// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include "tests/bench/terrain/terrain_frames.h"

#include <algorithm>
#include <numbers>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "host/sky/clear_sky.h"
#include "host/sky/sun_position.h"
#include "host/terrain/cast/image_rays.h"
#include "host/terrain/shading/terrain_shade.h"
#include "host/world/terrain_light.h"
#include "tests/bench/terrain/terrain_cameras.h"

namespace offing::bench {
namespace {

constexpr double sun_azimuth_rad = 225.0 / 180.0 * std::numbers::pi;
constexpr double sun_elevation_rad = 30.0 / 180.0 * std::numbers::pi;

struct FrameTime {
  double ms = 0.0;      ///< median over the blocks
  double spread = 0.0;  ///< of the blocks
};

FrameTime frame_time(const Work& frame, int blocks) {
  std::vector<double> times_ms;
  for (int i = 0; i < blocks; ++i) times_ms.push_back(block_ms(frame));
  return {median(times_ms), relative_spread(times_ms)};
}

}  // namespace

void bench_terrain_frames(const ocl::Device& device, const NamedMap& named, terrain::HeightField& field,
                          const Settings& settings, const Sinks& sinks) {
  const int blocks = std::min(settings.blocks, 5);
  const sky::Atmosphere atmosphere;
  sky::ClearSky sky(device, atmosphere);
  terrain::TerrainShade shade(device);
  terrain::ReliefSurface relief(device);
  const std::vector<TerrainCamera> cameras = terrain_cameras(named.map);
  for (const int rays : {1, 16}) {
    for (const char* drawn : {"fly", "walk", "relief_walk"}) {
      const bool has_relief = std::string_view(drawn) == "relief_walk";
      const std::string_view way = has_relief ? "walk" : drawn;
      FrameTime mean;
      double count = 0.0;
      for (const auto& [camera_way, camera] : cameras) {
        if (camera_way != way) continue;
        sky.at({.sun_direction = sky::direction_of(sun_azimuth_rad, sun_elevation_rad)},
               std::max(0.0, camera.eye_m.y));
        const TerrainLight light = world::terrain_light(sky.read_illuminance(), atmosphere, {}, 0.0);
        const std::size_t pixels = terrain::pixel_count(camera);
        ocl::Buffer<TerrainHit> hits(device, pixels, "hits");
        ocl::Buffer<terrain::Texel> image(device, pixels, "image");
        const FrameTime time = frame_time(
            [&] {
              relief.at(field, camera, 1.7, {.strength = has_relief ? 1.0 : 0.0});
              field.cast(camera, relief, hits);
              shade.at(field, camera, hits, {light, sky.params(), sky.view_table()}, image,
                       {.sampling = {.rays = rays}, .relief = &relief});
              device.finish();
            },
            blocks);
        mean.ms += time.ms;
        mean.spread += time.spread;
        ++count;
      }
      sinks.row(
          {.name = fmt::format("terrain_{}_{}_{}", rays == 1 ? "frame" : "smooth_frame", drawn, named.name),
           .size = named.map.columns,
           .ours_ms = mean.ms / count,
           .peer = "none",
           .spread = mean.spread / count});
    }
  }
}

}  // namespace offing::bench
