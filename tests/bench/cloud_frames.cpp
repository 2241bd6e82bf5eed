// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include <algorithm>
#include <array>
#include <filesystem>
#include <span>

#include <fmt/format.h>

#include "host/clouds/image/cloud_image.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/prepare/scene_clouds.h"
#include "host/scene/prepare/world_scene.h"
#include "tests/bench/cloud_counts.h"
#include "tests/bench/renderer.h"

namespace offing::bench {
namespace {

using present::ImageSize;
using present::Stage;

constexpr int cloud_stage_frames = 40;

/// How much of the picture clouds cover more than half.
double covered_share(world::World& world, const Camera& camera) {
  world.at(0.0, camera.eye_m.y);
  world.see_clouds(camera);
  const world::WorldClouds& clouds = *world.clouds();
  clouds::CloudImage picture(world.device(), clouds::billboard_textures());
  picture.fit(camera.width_px, camera.height_px);
  picture.draw({.particles = clouds.particles(),
                .sprites = clouds.sprites(),
                .order = clouds.order(),
                .count = clouds.count(),
                .origin_m = clouds.sky_origin_m(),
                .resolved = clouds.resolved()},
               camera);
  const auto image = picture.image().read();
  const auto covered =
      std::count_if(image.begin(), image.end(), [](const auto& texel) { return texel[3] > 0.5f; });
  return static_cast<double>(covered) / static_cast<double>(image.size());
}

/// Frames of an eye that moves from one to the next, so that particles are sorted and lit toward it in each.
class CloudFrames {
 public:
  CloudFrames(const scene::Scene& scene, ImageSize size, const Settings& settings, const Sinks& sinks)
      : renderer_(settings.device, scene::prepare_world(scene), scene.view, size),
        blocks_(settings.blocks),
        sinks_(sinks) {
    count();
  }

  /// Puts the clouds of another scene into the sky, seen by the same eye.
  void show(const scene::Scene& scene) {
    renderer_.world().set_clouds(scene::prepare_clouds(scene));
    count();
  }

  void measure(const std::string& name) {
    std::vector<double> frame_ms;
    for (int i = 0; i < blocks_; ++i) frame_ms.push_back(block_ms([&] { draw_next(); }));
    row(name, frame_ms, fmt::format("; {:.1f} fps", 1000.0 / median(frame_ms)));
  }

  void measure_stages(const std::string& name) {
    renderer_.wait_for_stages();
    std::array<std::vector<double>, present::stage_count> stage_ms;
    for (int i = 0; i < cloud_stage_frames; ++i) {
      draw_next();
      for (std::size_t s = 0; s < present::stage_count; ++s)
        stage_ms[s].push_back(renderer_.stage_ms(static_cast<Stage>(s)));
    }
    for (const Stage stage :
         {Stage::simulate, Stage::transfer, Stage::sky, Stage::water, Stage::clouds, Stage::tone}) {
      const std::vector<double>& times_ms = stage_ms[static_cast<std::size_t>(stage)];
      if (median(times_ms) > 0.0) row(fmt::format("{}_{}", name, to_string(stage)), times_ms);
    }
  }

 private:
  void count() {
    share_ = covered_share(renderer_.world(), renderer_.view().camera);
    size_ = static_cast<int>(renderer_.world().clouds()->count());
  }
  void draw_next() {
    step_ = (step_ + 1) % 32;
    renderer_.draw_next({0.5 * step_, 0.0, 0.0});
  }
  void row(const std::string& name, const std::vector<double>& ms, const std::string& note = "") {
    sinks_.row({.name = name,
                .size = size_,
                .ours_ms = median(ms),
                .peer = fmt::format("{}; {:.0f} % covered{}", renderer_.gl_renderer(), 100.0 * share_, note),
                .spread = relative_spread(ms)});
  }

  Renderer renderer_;
  int blocks_, size_ = 0, step_ = 0;
  double share_ = 0.0;
  const Sinks& sinks_;
};

/// A cumulus in a sky without a sea, from so near that it covers half of the picture.
scene::Scene cumulus(double distance_m, const std::string& how) {
  return scene::parse_scene(fmt::format("version = 1\n[sun]\nazimuth_deg = 75\nelevation_deg = 35\n"
                                        "[camera]\ny_m = 550\nz_m = {}\npitch_deg = 17\n{}",
                                        distance_m, how),
                            "cumulus.toml", "");
}

/// About 1,000 particles, grown.
scene::Scene grown_cumulus() {
  return cumulus(1200.0, "[clouds]\nquality = 1.08\n[[cloud]]\ngenus = \"cumulus\"\ny_m = 650\n");
}

/// Of so many particles, sampled.
scene::Scene cumulus_of(int count) {
  return cumulus(1040.0, fmt::format("[[cloud]]\ngenus = \"cumulus\"\ny_m = 650\nmodelling = \"sampled\"\n"
                                     "target_particles = {}\n",
                                     count));
}

}  // namespace

void bench_cloud_frames(const Settings& settings, const Sinks& sinks) {
  // The shipped cumulus over its sea, from so near that it covers half of the picture.
  scene::Scene shipped = scene::load_scene(std::filesystem::path(OFFING_SCENES) / "cumulus.toml");
  shipped.view.camera.eye_m = {0.0, 500.0, 1250.0};
  CloudFrames frames(shipped, {640, 360}, settings, sinks);
  frames.measure("clouds_frame_cumulus");
  frames.measure_stages("clouds_frame_cumulus");
  {
    CloudFrames alone(grown_cumulus(), {640, 360}, settings, sinks);
    alone.measure("clouds_frame_alone");
    alone.measure_stages("clouds_frame_alone");
  }
  const auto measure_all = [&](const std::string& name, ImageSize size, std::span<const int> counts) {
    CloudFrames sampled(cumulus_of(counts.front()), size, settings, sinks);
    for (const int count : counts) {
      if (count > most_drawn_particles) continue;
      sampled.show(cumulus_of(count));
      sampled.measure(name);
    }
  };
  measure_all("clouds_frame_360", {640, 360}, cloud_counts);
  measure_all("clouds_frame_1024", {1280, 1024}, paper_cloud_counts);
}

}  // namespace offing::bench
