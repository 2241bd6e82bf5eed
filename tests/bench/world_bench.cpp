// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include <array>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "host/scene/file/scene_file.h"
#include "host/scene/prepare/moving_view.h"
#include "host/scene/prepare/world_scene.h"
#include "tests/bench/renderer.h"

namespace offing::bench {
namespace {

using present::Stage;
using scene::Scene;

constexpr int stage_blocks = 12;
// A block has so many frames, one of them with a slice of the cloudy sky's map.
constexpr int slice_frames = present::Frame::slice_frames;

Scene without_terrain(Scene scene) {
  scene.terrain = {};
  return scene;
}

Scene without_clouds(Scene scene) {
  scene.clouds.clear();
  scene.cloud_layers.clear();
  return scene;
}

/// And without what floats on it.
Scene without_sea(Scene scene) {
  scene.ocean.is_given = false;
  scene.ocean.wakes.clear();
  scene.bodies.clear();
  scene.meshes.clear();
  scene.lights.clear();
  return scene;
}

/// Frames of an eye that moves.
class WorldFrames {
 public:
  WorldFrames(const Scene& scene, const Settings& settings)
      : renderer_(settings.device, scene::prepare_world(scene), scene::view_at(scene, 0.0), {640, 360}) {}

  std::vector<double> frames_ms(int blocks) {
    std::vector<double> ms;
    for (int i = 0; i < blocks; ++i) {
      const double ms_of_block = block_ms([&] {
        for (int frame = 0; frame < slice_frames; ++frame) draw_next();
      });
      ms.push_back(ms_of_block / slice_frames);
    }
    return ms;
  }

  std::array<std::vector<double>, present::stage_count> stages_ms() {
    renderer_.wait_for_stages();
    std::array<std::vector<double>, present::stage_count> ms;
    for (int i = 0; i < stage_blocks; ++i) {
      for (std::vector<double>& of_stage : ms) of_stage.push_back(0.0);
      for (int frame = 0; frame < slice_frames; ++frame) {
        draw_next();
        for (std::size_t s = 0; s < present::stage_count; ++s)
          ms[s].back() += renderer_.stage_ms(static_cast<Stage>(s)) / slice_frames;
      }
    }
    return ms;
  }

  const std::string& gl_renderer() const { return renderer_.gl_renderer(); }

 private:
  void draw_next() {
    step_ = (step_ + 1) % 32;
    renderer_.draw_next({0.1 * step_, 0.0, 0.0});
  }

  Renderer renderer_;
  int step_ = 0;
};

}  // namespace

void bench_world(const Settings& settings, const Sinks& sinks) {
  const Scene world = scene::load_scene(std::filesystem::path(OFFING_SCENES) / "world.toml");
  const std::array<std::pair<const char*, Scene>, 3> parts{
      {{"world_sea_and_ship", without_clouds(without_terrain(world))},
       {"world_island", without_clouds(without_sea(world))},
       {"world_clouds", without_terrain(without_sea(world))}}};
  double sum_ms = 0.0;
  for (const auto& [name, scene] : parts) {
    WorldFrames frames(scene, settings);
    const std::vector<double> ms = frames.frames_ms(settings.blocks);
    sum_ms += median(ms);
    sinks.row({.name = name,
               .size = world.ocean.parameters.size,
               .ours_ms = median(ms),
               .peer = frames.gl_renderer(),
               .spread = relative_spread(ms)});
  }
  WorldFrames frames(world, settings);
  const std::vector<double> ms = frames.frames_ms(settings.blocks);
  sinks.row({.name = "world_frame",
             .size = world.ocean.parameters.size,
             .ours_ms = median(ms),
             .peer = "sum of its parts",
             .peer_ms = sum_ms,
             .ratio = sum_ms / median(ms),
             .spread = relative_spread(ms)});
  const auto stages = frames.stages_ms();
  for (std::size_t s = 0; s < present::stage_count; ++s) {
    if (median(stages[s]) == 0.0) continue;
    sinks.row({.name = fmt::format("world_frame_{}", to_string(static_cast<Stage>(s))),
               .size = world.ocean.parameters.size,
               .ours_ms = median(stages[s]),
               .peer = frames.gl_renderer(),
               .spread = relative_spread(stages[s])});
  }
}

}  // namespace offing::bench
