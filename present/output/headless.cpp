#include "present/output/headless.h"

#include <functional>
#include <utility>

#include <fmt/format.h>

#include "host/base/progress.h"
#include "host/command_line/print_results.h"
#include "host/scene/prepare/moving_view.h"
#include "host/scene/prepare/own_billboards.h"
#include "host/scene/prepare/scene_meshes.h"
#include "host/scene/prepare/scene_terrain.h"
#include "host/scene/prepare/world_scene.h"
#include "host/world/cloud_grower.h"
#include "present/gl/gl_context.h"
#include "present/output/image_file.h"
#include "present/output/recorder.h"
#include "present/passes/frame.h"
#include "present/passes/sky/light_meter.h"

namespace offing::present {
namespace {

/// Ahead of the world, which could not be stopped.
world::WorldParameters with_particles(const ocl::Device& device, world::WorldParameters parameters,
                                      const CancelToken& cancel) {
  if (parameters.clouds)
    parameters.clouds = world::CloudGrower(device).grown(std::move(*parameters.clouds), cancel);
  return parameters;
}

class ImageMaker {
 public:
  ImageMaker(const ViewOptions& options, const CancelToken& cancel)
      : context_(GlContext::headless()),
        device_(ocl::Device::open_shared(ocl::select_device(options.device), ocl::Profiling::off,
                                         context_.share_properties())),
        scene_(options.scene),
        world_(device_, with_particles(device_, scene::prepare_shown_world(scene_), cancel)),
        lighting_at_(scene::lighting_of(scene_, world_.terrain())),
        frame_(context_, device_, frame_settings(options.detail.value_or(Detail::high), options.transfer)),
        size_(options.size.value_or(ImageSize{})) {
    if (const auto billboards = scene::own_billboards(scene_)) frame_.set_billboards(device_, *billboards);
    spdlog::info("OpenGL {} ({}, {}); OpenCL {}; transfer {}", context_.capabilities().version,
                 context_.capabilities().renderer, context_.capabilities().platform, device_.info().name,
                 to_string(frame_.transfer_path()));
  }

  /// Puts the picture that was made, at an exposure, where it belongs.
  using Write = std::function<void(const Frame&, double exposure)>;

  /// A picture of a sequence that begins at `first_s`. False, with nothing written, when asked to stop.
  bool make(double time_s, double first_s, const CancelToken& cancel, const Write& write) {
    if (cancel.cancelled()) return false;
    warn_of_eye(time_s);
    scene::ViewScene view = scene::show_at(world_, scene_, time_s);
    view.camera.width_px = size_.width;
    view.camera.height_px = size_.height;
    const double exposure = light_meter_.exposure(world_, view.camera, view.exposure_ev);
    if (cancel.cancelled()) return false;
    frame_.draw(
        world_,
        {.camera = view.camera, .exposure = exposure, .lighting_at = lighting_at_, .first_s = first_s});
    if (cancel.cancelled()) return false;
    write(frame_, exposure);
    return true;
  }

 private:
  /// Warns once, for the first picture whose eye needs it.
  void warn_of_eye(double time_s) {
    if (has_warned_ || !world_.terrain()) return;
    const auto warning =
        scene::eye_warning(*world_.terrain(), scene::view_at(scene_, time_s), scene_.has_sea());
    if (!warning) return;
    spdlog::warn("at {:g} s: {}", time_s, *warning);
    has_warned_ = true;
  }

  GlContext context_;
  ocl::Device device_;
  scene::Scene scene_;
  world::World world_;
  highlights::LightingAt lighting_at_;
  Frame frame_;
  LightMeter light_meter_;
  ImageSize size_;
  bool has_warned_ = false;
};

}  // namespace

void make_images(const ViewOptions& options, const CancelToken& cancel) {
  ImageMaker maker(options, cancel);
  if (!options.output.empty()) {
    const bool is_made =
        maker.make(options.time_s, options.time_s, cancel, [&](const Frame& frame, double exposure) {
          write_image(options.output, frame, options.time_s, exposure, options.existing);
        });
    if (!is_made) cancel.throw_if_cancelled();
    print_summary("{}\n", options.output.string());
  }
  if (!options.recording) return;
  const Recording& recording = *options.recording;
  Recorder recorder(recording);
  {
    Progress progress(recording.count(), "frames", options.verbosity);
    for (int frame = recording.frames.first; frame <= recording.frames.last; ++frame) {
      const double time_s = frame / recording.frames_per_second;
      const auto write = [&](const Frame& drawn, double exposure) {
        recorder.write(drawn, time_s, exposure);
      };
      if (!maker.make(time_s, recording.first_s(), cancel, write)) {
        throw stopped_recording(recording, recorder.count());
      }
      progress.advance();
    }
  }
  recorder.finish();
  print_summary("{}\n", shown_outputs(recording));
}

}  // namespace offing::present
