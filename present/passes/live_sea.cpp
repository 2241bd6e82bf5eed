#include "present/passes/live_sea.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "host/base/error.h"
#include "host/base/host_memory.h"
#include "host/base/log.h"
#include "host/scene/prepare/moving_view.h"
#include "host/scene/prepare/own_billboards.h"
#include "host/scene/prepare/scene_clouds.h"
#include "host/scene/prepare/scene_meshes.h"
#include "host/scene/prepare/scene_terrain.h"
#include "host/scene/prepare/world_scene.h"
#include "host/scene/schema/scene_elements.h"
#include "present/gl/stage_times.h"
#include "present/output/image_file.h"

namespace offing::present {
namespace {

world::WorldParameters with_particles(CloudBuilder& builder, world::WorldParameters parameters,
                                      const CancelToken* cancel) {
  const CancelToken none;
  if (parameters.clouds) {
    parameters.clouds = builder.grow(std::move(*parameters.clouds), cancel != nullptr ? *cancel : none);
  }
  return parameters;
}

}  // namespace

LiveSea::LiveSea(const GlContext& context, const LiveSeaSettings& settings, const scene::Scene& scene)
    : context_(context),
      settings_(settings.frame),
      still_settings_(settings.still.value_or(settings.frame)),
      cancel_(settings.cancel),
      watch_(settings.watch),
      device_(ocl::Device::open_shared(ocl::select_device(settings.device), ocl::Profiling::on,
                                       context.share_properties())) {
  make(scene, settings.first);
}

void LiveSea::make(const scene::Scene& scene, std::optional<FirstView> view) {
  constexpr std::chrono::milliseconds between_looks{50};
  WorldOpening opening(device_, scene, view, cancel_);
  if (watch_) watch_(opening.step());
  auto frame = std::make_unique<Frame>(context_, device_, settings_);
  while (!opening.wait_for(between_looks)) {
    if (watch_) watch_(opening.step());
  }
  OpenedWorld opened = opening.take();
  lakes_.stop();
  filled_lakes_.clear();
  if (const auto billboards = scene::own_billboards(scene)) frame->set_billboards(device_, *billboards);
  builder_ = std::move(opened.builder);
  world_ = std::move(opened.world);
  frame_ = std::move(frame);
  light_meter_ = {};
  request_ = {.time_s = opened.scene.time.start_s, .camera = opened.scene.view.camera};
  ++revision_;
  const bool come_clouds_later = opened.with_clouds.has_value();
  take_scene(std::move(opened.scene), std::move(opened.with_clouds));
  if (come_clouds_later) builder_->begin(wanted_, Haste::let_finish);
  is_drawn_ = false;
}

std::unique_ptr<Frame> LiveSea::new_frame(const scene::Scene& scene) const {
  auto frame = std::make_unique<Frame>(context_, device_, settings_);
  if (const auto billboards = scene::own_billboards(scene)) frame->set_billboards(device_, *billboards);
  return frame;
}

void LiveSea::take_scene(scene::Scene scene, std::optional<scene::Scene> wanted) {
  warning_ = scene::steepness_warning(scene, world_->parameters().ocean.gerstner_waves);
  scene.set_at.clear();
  if (wanted) wanted->set_at.clear();
  next_ = scene_ = std::move(scene);
  wanted_ = wanted ? std::move(*wanted) : scene_;
}

void LiveSea::open(const scene::Scene& scene) {
  make(scene, {});
}

void LiveSea::try_out(world::World& world, const FrameRequest& request) const {
  world.set_eye({request.camera.eye_m.x, request.camera.eye_m.z});
  world.at(request.time_s, request.camera.eye_m.y);
  world.see_clouds(request.camera);
  device_.finish();
}

void LiveSea::change(const std::function<void()>& work) {
  ++revision_;
  const world::WorldParameters before = world_->parameters();
  const std::shared_ptr<world::WorldBodies> bodies = world_->shared_bodies();
  try {
    work();
    try_out(*world_, request_);
    frame_->forget();
  } catch (const Error&) {
    // Any part may have changed; what it was made of needs no file again.
    world_ = std::make_unique<world::World>(device_, before);
    world_->keep_bodies(bodies);
    throw;
  }
}

void LiveSea::warn() {
  std::string warning = scene::steepness_warning(scene_, world_->parameters().ocean.gerstner_waves);
  if (warning_.empty() && !warning.empty()) spdlog::warn("{}", warning);
  warning_ = std::move(warning);
}

std::map<std::string_view, double> LiveSea::computed_values() const {
  const ocean::FoamParameters& foam = world_->parameters().ocean.foam;
  if (!world_->has_sea() || !foam.fraction || foam.onset_jacobian) return {};
  return {{"ocean.foam.fraction", *foam.fraction}};
}

void LiveSea::begin_edit(const scene::Scene& scene, Haste haste) {
  const auto start = std::chrono::steady_clock::now();
  // All except clouds and new lakes is shown at once.
  scene::take_values(scene::all_but_clouds, scene, next_);
  if (!scene_.lakes.empty()) filled_lakes_ = scene_.lakes;
  if (scene::has_lakes_to_fill(scene_, next_))
    next_.lakes = scene::is_other_ground(scene_, next_) ? std::vector<scene::LakeScene>() : scene_.lakes;
  try {
    change([&] { scene::edit_world_below(*world_, scene_, next_); });
  } catch (const Error&) {
    scene::take_values(scene::everything, scene_, next_);
    throw;
  }
  scene::take_values(scene::everything, next_, scene_);
  const bool are_other_clouds = scene::are_other_clouds(wanted_, scene);
  scene::take_values(scene::everything, scene, wanted_);
  if (are_other_clouds) builder_->begin(wanted_, haste);
  fill_lakes(haste);
  warn();
  edit_s_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void LiveSea::show_clouds(BuiltClouds built) {
  scene::Scene now = scene_;
  scene::copy_clouds(built.scene, now);
  change([&] {
    // With the first cloud, or without the last one, the sea may come or go.
    scene::edit_world_below(*world_, scene_, now);
    world_->set_clouds(built.sky);
  });
  if (built.billboards) frame_->set_billboards(device_, *built.billboards);
  next_ = scene_ = std::move(now);
  warn();
}

/// Begins to fill lakes that are wanted and not shown.
void LiveSea::fill_lakes(Haste haste) {
  if (!scene::has_lakes_to_fill(scene_, wanted_)) return lakes_.stop();
  const world::TerrainParameters& ground = *world_->parameters().terrain;
  if (lakes_.is_busy() && (haste == Haste::let_finish || lakes_.is_asked_for(wanted_, ground))) return;
  lakes_.begin(wanted_, scene_.lakes, ground);
}

/// The edit to blame is the one that made the lake; where the lake was there before, the one that moved the
/// ground or the sea below it.
UnmadePart LiveSea::unmade_lakes(const Error& error) const {
  using Lakes = std::vector<scene::LakeScene>;
  const auto has = [](const Lakes& lakes, const scene::LakeScene& lake) {
    return std::ranges::any_of(
        lakes, [&](const scene::LakeScene& each) { return scene::are_filled_alike(each, lake); });
  };
  Lakes unmade;
  if (const auto* fault = dynamic_cast<const scene::LakeError*>(&error)) {
    for (const std::size_t lake : fault->lakes()) unmade.push_back(wanted_.lakes.at(lake));
  } else {
    unmade = wanted_.lakes;
  }
  std::erase_if(unmade, [&](const scene::LakeScene& lake) { return has(filled_lakes_, lake); });
  return {error, [unmade, has](const scene::Scene& before, const scene::Scene& after) {
            if (unmade.empty())
              return scene::is_other_ground(before, after) || before.sea_level_m() != after.sea_level_m();
            return std::ranges::any_of(unmade, [&](const scene::LakeScene& lake) {
              return has(after.lakes, lake) && !has(before.lakes, lake);
            });
          }};
}

bool LiveSea::take_lakes() {
  try {
    std::optional<SceneLakes> filled = lakes_.take();
    if (!filled) return false;
    const world::TerrainParameters& ground = *world_->parameters().terrain;
    if (filled->are_on(ground)) {
      world::TerrainParameters terrain = ground;
      terrain.lakes = std::move(filled->terrain.lakes);
      change([&] { world_->set_terrain(terrain); });
      scene_.lakes = next_.lakes = std::move(filled->lakes);
    }
  } catch (const Error& error) {
    if (lakes_.is_asked_for(wanted_, *world_->parameters().terrain)) throw unmade_lakes(error);
    fill_lakes(Haste::let_finish);  // those of an edit since then
    return false;
  }
  // What was edited while they were filled.
  if (scene::differ_in(scene::all_but_clouds, scene_, wanted_))
    begin_edit(scene::Scene(wanted_), Haste::let_finish);
  return true;
}

bool LiveSea::take_made() {
  const bool has_lakes = take_lakes();
  auto made = builder_->take();
  if (!made) return has_lakes;
  try {
    if (const Error* fault = std::get_if<Error>(&*made)) throw *fault;
    show_clouds(std::get<BuiltClouds>(std::move(*made)));
  } catch (const Error& error) {
    throw UnmadePart(error, scene::are_other_clouds);
  }
  return true;
}

void LiveSea::edit(const scene::Scene& scene) {
  begin_edit(scene, Haste::interrupt);
  builder_->wait();
  while (lakes_.is_busy()) {
    take_made();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  take_made();
}

void LiveSea::reload() {
  ++revision_;
  auto frame = new_frame(scene_);
  auto builder = std::make_unique<CloudBuilder>(device_.info(), scene_);
  auto world = std::make_unique<world::World>(
      device_, with_particles(*builder, scene::prepare_world(scene_, scene::Warnings::left_out), nullptr));
  try_out(*world, request_);
  frame->draw(*world, request_);  // some shaders are compiled where they are needed first
  world_ = std::move(world);
  frame_ = std::move(frame);
  builder_ = std::move(builder);
  if (scene::are_other_clouds(scene_, wanted_)) builder_->begin(wanted_, Haste::let_finish);
  give_back_freed_memory();
}

double LiveSea::surface_height_m(double x_m, double z_m) {
  double height_m = -std::numeric_limits<double>::infinity();
  if (world_->has_sea()) {
    const std::array<ocean::WaterPoint, 1> point{{{x_m, z_m}}};
    height_m = world_->sample(point, {.fields = ocean::WaterQuery::Fields::surface}).front().height_m +
               world_->sea_level_m();
  }
  if (terrain() == nullptr) return height_m;
  const std::optional<double> below_m = terrain()->surface_m(x_m, z_m);
  return below_m ? std::max(height_m, *below_m) : height_m;
}

void LiveSea::simulate(const FrameRequest& request) {
  run_stage(frame_->times(), Stage::simulate, device_, [&] {
    show_view(*world_, {.time_s = request.time_s, .quality = request.quality}, request.camera.eye_m);
  });
}

bool LiveSea::draw(FrameRequest request, PictureKind kind) {
  const scene::ViewScene now = scene::view_at(scene_, request.time_s);
  scene::set_view(*world_, now);
  scene::set_meshes_at(*world_, scene_, request.time_s);
  simulate(request);
  request.exposure = light_meter_.exposure(*world_, request.camera, now.exposure_ev);
  frame_->set_detail(kind == PictureKind::still ? still_settings_ : settings_);
  if (!request.is_wanted() || !frame_->draw(*world_, request)) return false;
  request.goes_on = {};  // the caller's, who is asked no more
  request_ = std::move(request);
  // What the scene before held, and what the compilers of shaders took for the first picture.
  if (!std::exchange(is_drawn_, true)) give_back_freed_memory();
  return true;
}

void LiveSea::write(const std::filesystem::path& path, Existing existing) const {
  write_image(path, *frame_, request_.time_s, request_.exposure, existing);
}

}  // namespace offing::present
