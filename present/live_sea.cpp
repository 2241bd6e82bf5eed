#include "present/live_sea.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>
#include <optional>
#include <utility>

#include "host/base/error.h"
#include "host/base/log.h"
#include "host/scene/moving_view.h"
#include "host/scene/own_puffs.h"
#include "host/scene/scene_meshes.h"
#include "host/scene/world_scene.h"
#include "present/device_stage.h"
#include "present/picture_file.h"

namespace offing::present {

LiveSea::LiveSea(const GlContext& context, const LiveSeaSettings& settings, const scene::OceanScene& scene)
    : context_(context),
      settings_(settings.frame),
      device_(ocl::Device::open_shared(ocl::select_device(settings.device), ocl::Profiling::on,
                                       context.share_properties())),
      scene_(scene),
      world_(std::make_unique<world::World>(device_, scene::prepare_shown_world(scene_))),
      frame_(std::make_unique<Frame>(context, device_, settings.frame)) {
  if (const auto puffs = scene::own_puffs(scene_)) frame_->set_puffs(device_, *puffs);
  warning_ = scene::steepness_warning(scene_, world_->parameters().trochoids);
  // What was written where has been checked: edits are not to be warned of as if they were in the file.
  scene_.set_at.clear();
}

void LiveSea::try_out(world::World& world) const {
  world.at(view_.time_s, view_.camera.eye_m.y);
  world.see_clouds(view_.camera);
  device_.finish();
}

void LiveSea::edit(const scene::OceanScene& scene) {
  const auto start = std::chrono::steady_clock::now();
  scene::OceanScene edited = scene;
  edited.set_at.clear();
  const world::WorldParameters before = world_->parameters();
  const auto folders = [](const scene::OceanScene& of) {
    return std::pair(of.cloud_settings.crisp_puffs, of.cloud_settings.soft_puffs);
  };
  std::optional<clouds::PuffTextures> puffs;
  if (folders(scene_) != folders(edited)) {
    puffs = scene::own_puffs(edited);
    if (!puffs) puffs = clouds::puff_textures();
  }
  try {
    scene::edit_world(*world_, scene_, edited);
    try_out(*world_);
  } catch (const Error&) {
    // Any part may have changed; what it was made of needs no file again.
    world_ = std::make_unique<world::World>(device_, before);
    throw;
  }
  if (puffs) frame_->set_puffs(device_, *puffs);
  scene_ = std::move(edited);
  std::string warning = scene::steepness_warning(scene_, world_->parameters().trochoids);
  if (warning_.empty() && !warning.empty()) spdlog::warn("{}", warning);
  warning_ = std::move(warning);
  edit_s_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void LiveSea::reload() {
  auto frame = std::make_unique<Frame>(context_, device_, settings_);
  if (const auto puffs = scene::own_puffs(scene_)) frame->set_puffs(device_, *puffs);
  auto world =
      std::make_unique<world::World>(device_, scene::prepare_world(scene_, scene::Warnings::left_out));
  try_out(*world);
  world_ = std::move(world);
  frame_ = std::move(frame);
}

double LiveSea::surface_height_m(double x_m, double z_m) {
  double height_m = -std::numeric_limits<double>::infinity();
  if (world_->has_sea()) {
    const std::array<ocean::WaterPoint, 1> point{{{x_m, z_m}}};
    height_m = world_->sample(point, {.fields = ocean::WaterQuery::Fields::surface}).front().height_m;
  }
  if (ground() == nullptr) return height_m;
  const std::optional<terrain::GroundPoint> below = ground()->ground_at(x_m, z_m);
  return below ? std::max(height_m, below->height_m) : height_m;
}

void LiveSea::simulate(const SeaView& view) {
  run_stage(frame_->times(), Stage::simulate, device_, [&] { world_->at(view.time_s, view.camera.eye_m.y); });
}

void LiveSea::draw(const SeaView& view) {
  const scene::ViewScene now = scene::view_at(scene_, view.time_s);
  view_ = view;
  scene::set_view(*world_, now);
  scene::set_meshes_at(*world_, scene_, view.time_s);
  simulate(view);
  exposure_ = light_meter_.exposure(*world_, view.camera, now.exposure_ev);
  frame_->draw(*world_, {.camera = view.camera,
                         .exposure = exposure_,
                         .debug = view.debug,
                         .fill = view.fill,
                         .ground = view.ground,
                         .meshes = view.meshes,
                         .tiles = view.tiles,
                         .ground_scale = view.ground_scale,
                         .lighting_at = view.lighting_at,
                         .first_s = view.first_s});
}

void LiveSea::write(const std::filesystem::path& path) const {
  write_picture(path, *frame_, view_.time_s, exposure_);
}

}  // namespace offing::present
