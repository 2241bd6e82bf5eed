#include "present/output/scene_images.h"

#include <utility>

#include "host/base/log.h"
#include "host/scene/prepare/moving_view.h"
#include "host/scene/prepare/own_billboards.h"
#include "host/scene/prepare/scene_meshes.h"
#include "host/scene/prepare/scene_terrain.h"
#include "host/scene/prepare/world_scene.h"
#include "host/world/cloud_grower.h"

namespace offing::present {
namespace {

world::WorldParameters with_particles(const ocl::Device& device, world::WorldParameters parameters,
                                      const CancelToken& cancel) {
  world::grow_clouds(device, parameters, cancel);
  return parameters;
}

}  // namespace

SceneImages::SceneImages(const scene::Scene& scene, const ocl::DeviceInfo& device,
                         const FrameSettings& settings, const CancelToken& cancel)
    : context_(GlContext::headless()),
      device_(ocl::Device::open_shared(device, ocl::Profiling::off, context_.share_properties())),
      scene_(scene),
      world_(device_, with_particles(device_, scene::prepare_shown_world(scene_), cancel)),
      lighting_at_(scene::lighting_of(scene_, world_.terrain())),
      frame_(context_, device_, settings) {
  if (const auto billboards = scene::own_billboards(scene_)) frame_.set_billboards(device_, *billboards);
  spdlog::info("OpenGL {} ({}, {}); OpenCL {}; transfer {}", context_.capabilities().version,
               context_.capabilities().renderer, context_.capabilities().platform, device_.info().name,
               to_string(frame_.transfer_path()));
}

bool SceneImages::draw(double time_s, double first_s, const ImageSize& size, const CancelToken& cancel,
                       HighlightShow highlights) {
  if (cancel.cancelled()) return false;
  warn_of_eye(time_s);
  scene::ViewScene view = scene::show_at(world_, scene_, time_s);
  view.camera.width_px = size.width;
  view.camera.height_px = size.height;
  exposure_ = light_meter_.exposure(world_, view.camera, view.exposure_ev);
  if (cancel.cancelled()) return false;
  frame_.draw(world_, {.camera = view.camera,
                       .exposure = exposure_,
                       .highlights = highlights,
                       .lighting_at = lighting_at_,
                       .first_s = first_s});
  return !cancel.cancelled();
}

std::optional<HighlightLayer> SceneImages::draw_highlights(double time_s, double first_s,
                                                           const ImageSize& size, const CancelToken& cancel,
                                                           HighlightShow highlights) {
  if (!draw(time_s, first_s, size, cancel, highlights)) return std::nullopt;
  const PictureLight alone = read_light(frame_.light());
  if (highlights == HighlightShow::unobstructed) return highlight_layer(alone, exposure_);
  if (!draw(time_s, first_s, size, cancel, HighlightShow::hidden)) return std::nullopt;
  const PictureLight without = read_light(frame_.light());
  if (!draw(time_s, first_s, size, cancel)) return std::nullopt;
  return highlight_layer(alone, read_light(frame_.light()), without, exposure_);
}

/// Warns of a misplaced eye, once.
void SceneImages::warn_of_eye(double time_s) {
  if (has_warned_ || !world_.terrain()) return;
  const auto warning =
      scene::eye_warning(*world_.terrain(), scene::view_at(scene_, time_s), scene_.has_sea());
  if (!warning) return;
  spdlog::warn("at {:g} s: {}", time_s, *warning);
  has_warned_ = true;
}

}  // namespace offing::present
