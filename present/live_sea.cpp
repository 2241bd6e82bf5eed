#include "present/live_sea.h"

#include <utility>

#include "host/scene/world_scene.h"
#include "host/sky/sun_position.h"
#include "present/exposure.h"
#include "present/picture_file.h"

namespace offing::present {

LiveSea::LiveSea(const GlContext& context, const LiveSeaSettings& settings, const scene::OceanScene& scene)
    : context_(context),
      settings_(settings.frame),
      device_(ocl::Device::open_shared(ocl::select_device(settings.device), ocl::Profiling::on,
                                       context.share_properties())),
      scene_(scene),
      world_(std::make_unique<world::World>(device_, scene::prepare_world(scene))),
      frame_(std::make_unique<Frame>(context, device_, settings.frame)) {
  // What was written where has been checked: edits are not to be warned of as if they were in the file.
  scene_.set_at.clear();
}

std::unique_ptr<world::World> LiveSea::world_of(const scene::OceanScene& scene) const {
  auto world = std::make_unique<world::World>(device_, scene::prepare_world(scene));
  world->at(view_.time_s, view_.camera.eye_m.y);  // what is compiled or allocated at first use
  device_.finish();
  return world;
}

void LiveSea::make(const scene::OceanScene& scene) {
  scene::OceanScene edited = scene;
  edited.set_at.clear();
  world_ = world_of(edited);
  scene_ = std::move(edited);
}

void LiveSea::turn_sun(const scene::ViewScene& view) {
  scene_.view = view;
  world_->set_sun(sky::direction_of(view.sun_azimuth_rad, view.sun_elevation_rad), 1.0);
}

void LiveSea::reload() {
  auto frame = std::make_unique<Frame>(context_, device_, settings_);
  world_ = world_of(scene_);
  frame_ = std::move(frame);
}

void LiveSea::simulate(const SeaView& view) {
  const StageTimes::Scope stage(frame_->times(), Stage::simulate);
  const ocl::Event start = device_.mark();
  world_->at(view.time_s, view.camera.eye_m.y);
  const ocl::Event end = device_.mark();
  device_.finish();
  frame_->times().add_device_ms(Stage::simulate, 1e3 * (end.end_s() - start.end_s()));
}

void LiveSea::draw(const SeaView& view) {
  view_ = view;
  simulate(view);
  exposure_ = exposure_for(world_->sky(), view.camera, view.exposure_ev);
  frame_->draw(*world_,
               {.camera = view.camera, .exposure = exposure_, .debug = view.debug, .fill = view.fill});
}

void LiveSea::write(const std::filesystem::path& path) const {
  write_picture(path, *frame_, view_.time_s, exposure_);
}

}  // namespace offing::present
