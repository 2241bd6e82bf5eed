// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include <array>
#include <filesystem>

#include <fmt/format.h>

#include "host/ocean/surface/cascades.h"
#include "host/ocean/surface/gerstner_choice.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/prepare/moving_view.h"
#include "host/scene/prepare/world_scene.h"
#include "tests/bench/renderer.h"

namespace offing::bench {
namespace {

using present::Stage;

constexpr int stage_frames = 40;

/// Blocks of frames; then, with an end to each stage, of the stages.
void measure(Renderer& renderer, const std::string& name, int size, int blocks, const Sinks& sinks) {
  const auto row = [&](const std::string& row_name, const std::vector<double>& ms) {
    sinks.row({.name = row_name,
               .size = size,
               .ours_ms = median(ms),
               .peer = renderer.gl_renderer(),
               .spread = relative_spread(ms)});
  };
  std::vector<double> frame_ms;
  for (int i = 0; i < blocks; ++i) frame_ms.push_back(block_ms([&] { renderer.draw_next(); }));
  row(name, frame_ms);

  renderer.wait_for_stages();
  std::array<std::vector<double>, present::stage_count> stage_ms;
  for (int i = 0; i < stage_frames; ++i) {
    renderer.draw_next();
    for (std::size_t s = 0; s < present::stage_count; ++s) {
      stage_ms[s].push_back(renderer.stage_ms(static_cast<Stage>(s)));
    }
  }
  for (const Stage stage : {Stage::simulate, Stage::terrain, Stage::transfer, Stage::sky, Stage::water,
                            Stage::meshes, Stage::tone}) {
    const std::vector<double>& times_ms = stage_ms[static_cast<std::size_t>(stage)];
    // A sea alone has no stage of ground, nor ground alone one of water.
    if (median(times_ms) > 0.0) row(fmt::format("{}_{}", name, to_string(stage)), times_ms);
  }
}

}  // namespace

void bench_render(const Settings& settings, const Sinks& sinks) {
  const scene::Scene rough = scene::load_scene(std::filesystem::path(OFFING_SCENES) / "rough.toml");
  {
    Renderer renderer(settings.device, scene::prepare_world(rough), rough.view, {640, 360});
    measure(renderer, "render_rough", rough.ocean.parameters.size, settings.blocks, sinks);
  }
  for (const std::string name : {"valley_fly", "valley_walk"}) {
    const scene::Scene valley = scene::load_scene(std::filesystem::path(OFFING_SCENES) / (name + ".toml"));
    const world::WorldParameters parameters = scene::prepare_world(valley);
    for (const present::ImageSize size : {present::ImageSize{640, 360}, present::ImageSize{1280, 720}}) {
      Renderer renderer(settings.device, parameters, scene::view_at(valley, 0.0), size);
      measure(renderer, fmt::format("render_{}_{}", name, size.height), valley.terrain.fractal.posts,
              settings.blocks, sinks);
    }
  }
  for (const int size : settings.sizes) {
    // The paper's frame: one patch, 16 Gerstner waves on 128 x 128 points, 1280 x 1024 pixels.
    scene::Scene paper = rough;
    paper.ocean.parameters.size = size;
    paper.ocean.patch_lengths_m = {rough.ocean.patch_lengths_m.front() / 2.0};
    paper.ocean.gerstner_count = 16;
    Renderer renderer(settings.device, scene::prepare_world(paper), paper.view, {1280, 1024});
    measure(renderer, "render_paper", size, settings.blocks, sinks);
  }
}

}  // namespace offing::bench
