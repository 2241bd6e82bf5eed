// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include <cstddef>
#include <filesystem>
#include <vector>

#include "host/cli/ocean/frame_maker.h"
#include "host/cli/pictures/contact_sheet.h"
#include "host/cli/pictures/sea_map.h"
#include "host/scene/file/scene_file.h"
#include "tests/bench/benches.h"
#include "tests/bench/measure.h"

namespace offing::bench {
namespace {

constexpr FrameRange frames{0, 23};

/// What a bake draws a preview from: a frame of the shipped storm.
struct Storm {
  Storm(const ocl::Device& device, int size) {
    scene::Scene scene = scene::load_scene(OFFING_SCENES "/storm.toml");
    scene.ocean.parameters.size = size;
    sea = scene::prepare_sea(scene);
    cli::BakeSettings settings;
    settings.channels.set(static_cast<std::size_t>(cli::ChannelGroup::foam));
    frame = cli::FrameMaker(device, sea, settings).make(frames.last);
    hs_m = ocean::integrate_sea_state(sea.spectrum).hs_m;
  }

  RgbImage draw() const {
    std::vector<cli::SeaMapCascade> cascades;
    for (std::size_t i = 0; i < frame.cascades.size(); ++i) {
      cascades.push_back(
          {sea.parameters.cascades[i].patch_length_m, &frame.cascades[i].surface, frame.cascades[i].foam});
    }
    return cli::draw_sea_map(cascades, {sea.parameters.gerstner_waves, frame.time_s}, hs_m);
  }

  scene::Sea sea;
  cli::BakedFrame frame;
  double hs_m = 0.0;
};

void bench_size(const ocl::Device& device, int size, int blocks, const Sinks& sinks) {
  const Storm storm(device, size);
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "offing-bench-preview.png";
  cli::ContactSheet sheet(frames, [&](int) { return file; });
  const auto measure = [&](const char* name, const char* what, const Work& work) {
    std::vector<double> times_ms;
    for (int block = 0; block < blocks; ++block) times_ms.push_back(block_ms(work));
    sinks.row({.name = name,
               .size = size,
               .ours_ms = median(times_ms),
               .peer = what,
               .spread = relative_spread(times_ms)});
  };
  measure("preview", "none; drawn, written, and kept for the contact sheet", [&] {
    const RgbImage picture = storm.draw();
    write_png(file, picture, Existing::replace, PngCompression::fast);
    sheet.keep(frames.first, picture);
  });
  measure("preview_draw", "none; drawn alone", [&] { storm.draw(); });
  for (int frame = frames.first; frame <= frames.last; ++frame) sheet.keep(frame, storm.draw());
  measure("preview_sheet", "none; contact sheet of 24 frames, once a bake",
          [&] { write_png(file, sheet.draw(), Existing::replace, PngCompression::fast); });
  std::filesystem::remove(file);
}

}  // namespace

void bench_previews(const ocl::Device& device, const Settings& settings, const Sinks& sinks) {
  for (const int size : settings.sizes) bench_size(device, size, settings.blocks, sinks);
}

}  // namespace offing::bench
