#include "present/passes/frame.h"

#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "present/passes/camera_projection.h"

namespace offing::present {
namespace {

/// The camera whose rays see the ground.
Camera terrain_camera(const FrameRequest& request) {
  return scaled_camera(request.camera, request.quality.ray_scale());
}

bool is_obstructed(const FrameRequest& request) {
  return request.highlights != HighlightShow::unobstructed;
}

LayerLight light_of_layers(const FrameRequest& request) {
  return is_alone(request.highlights) ? LayerLight::left_out : LayerLight::drawn;
}

/// Whether one picture shows about the sky that another did: flight and time lapse do, bookmarks do not.
bool goes_on_from(const SkySight& before, const SkySight& now) {
  constexpr double farthest_m = 100.0, longest_s = 2.0, least_sun_cosine = 0.9998;  // 1.1 degrees
  return glm::distance(before.eye_m, now.eye_m) < farthest_m &&
         std::abs(now.time_s - before.time_s) < longest_s &&
         glm::dot(before.sun_direction, now.sun_direction) > least_sun_cosine;
}

}  // namespace

Frame::Frame(const GlContext& context, const ocl::Device& device, const FrameSettings& settings)
    : capabilities_(context.capabilities()),
      terrain_sampling_(settings.terrain),
      transfer_(context, device, settings.transfer),
      sky_(settings.sky_step_px),
      water_(context.capabilities(), settings.water),
      meshes_(context.capabilities()) {}

void Frame::fit(int width, int height) {
  if (light_.width() == width && light_.height() == height) return;
  light_ = RenderTarget(width, height, GL_RGBA16F, RenderTarget::Depth::single_precision);
  under_ = RenderTarget(width, height, GL_RGBA16F, RenderTarget::Depth::none);
}

void Frame::set_detail(const FrameSettings& settings) {
  terrain_sampling_ = settings.terrain;
  water_.set_detail(settings.water);
  sky_.set_step(settings.sky_step_px);
}

bool Frame::draw_light(world::World& world, const FrameRequest& request, bool sees_terrain) {
  light_.bind();
  glClearDepth(0.0);
  glClear(GL_DEPTH_BUFFER_BIT);
  if (sees_terrain) {
    const StageTimes::Scope stage(times_, Stage::terrain);
    terrain_.draw(request.camera, TerrainPass::Part::covered);
  }
  if (world.has_sea() && !is_under_) {
    const StageTimes::Scope stage(times_, Stage::water);
    const bool is_whole = water_.draw(world, request,
                                      {.meshes = meshes_,
                                       .shadows = shadows_,
                                       .environment = sky_.environment(),
                                       .cloudy_sky = cloudy_sky_},
                                      light_, transfer_);
    if (!is_whole) return false;
  }
  {
    // Where nothing else is.
    const StageTimes::Scope stage(times_, Stage::sky);
    sky_.draw(request.camera, light_);
  }
  if (is_alone(request.highlights)) {
    // Of what stands before highlights only the depth counts.
    light_.bind();
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClear(GL_COLOR_BUFFER_BIT | (is_obstructed(request) ? 0u : GL_DEPTH_BUFFER_BIT));
  }
  if (!world.meshes().empty()) {
    const StageTimes::Scope stage(times_, Stage::meshes);
    meshes_.draw(world, request, sky_.environment(), shadows_, light_);
    light_.bind();
  }
  if (sees_terrain && is_obstructed(request)) {
    const StageTimes::Scope stage(times_, Stage::terrain);
    terrain_.draw(request.camera, TerrainPass::Part::edges, light_of_layers(request));
  }
  return request.is_wanted();
}

void Frame::draw_clouds(world::World& world, const FrameRequest& request) {
  run_stage(times_, Stage::clouds, world.device(), [&] { world.see_clouds(request.camera); });
  const StageTimes::Scope stage(times_, Stage::clouds);
  clouds_.prepare(world.device(), drawn_clouds(world), request.camera, light_, transfer_);
  light_.bind();
  clouds_.draw(above_level(request.camera, world.sea_level_m()), world.parameters().atmosphere,
               sky_.environment(), CloudPass::AirFrom::eye, light_of_layers(request));
}

void Frame::draw_cloudy_sky(world::World& world, const FrameRequest& request) {
  if (world.clouds() == nullptr || !world.has_sea()) {
    cloudy_sky_.forget();
    return;
  }
  const auto& [x, y, z] = world.parameters().sun.sun_direction;
  const SkySight sight{request.camera.eye_m, {x, y, z}, world.time_s()};
  const SkySight before = std::exchange(sky_sight_, sight);
  const bool keeps = request.sky == SkyRefresh::slice && cloudy_sky_.has_map() && goes_on_from(before, sight);
  if (keeps && ++frames_of_slice_ < slice_frames) return;
  frames_of_slice_ = 0;
  // Level water mirrors what the eye's mirror image sees.
  const double level_m = world.sea_level_m();
  const bool is_below = request.camera.eye_m.y < level_m;
  const Camera from_below = is_below ? request.camera : mirrored(request.camera, level_m);
  run_stage(times_, Stage::clouds, world.device(),
            [&] { is_below ? world.see_clouds(from_below) : world.see_mirrored_clouds(from_below); });
  const StageTimes::Scope stage(times_, Stage::clouds);
  cloudy_sky_.draw(world.device(),
                   {.drawn = drawn_clouds(world),
                    .air = world.parameters().atmosphere,
                    .clear_sky = sky_.environment(),
                    .sea_level_m = level_m},
                   from_below.eye_m, keeps ? SkyRefresh::slice : SkyRefresh::whole, transfer_);
}

void Frame::show_light(const FrameRequest& request, bool shows_steps) {
  const StageTimes::Scope stage(times_, Stage::tone);
  const int width = request.camera.width_px, height = request.camera.height_px;
  // Not before: until now it has held the last picture.
  if (screen_.width() != width || screen_.height() != height)
    screen_ = RenderTarget(width, height, GL_RGBA8, RenderTarget::Depth::none);
  screen_.bind();
  tone_.draw(light(), shows_steps ? 1.0 : request.exposure,
             shows_steps ? TonePass::Curve::none : TonePass::Curve::filmic);
}

bool Frame::draw(world::World& world, const FrameRequest& request) {
  fit(request.camera.width_px, request.camera.height_px);
  // Depth is 1 at the near plane and 0 at infinity.
  if (capabilities_.has_clip_control) glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  if (world.terrain()) {
    run_stage(times_, Stage::terrain, world.device(),
              [&] { world.see_terrain(terrain_camera(request), terrain_sampling_, request.tiles); });
  }
  if (!world.meshes().empty()) {
    run_stage(times_, Stage::meshes, world.device(),
              [&] { world.see_meshes(request.camera.eye_m, request.lighting_at, request.first_s); });
  }
  if (!request.is_wanted()) return false;
  const bool sees_terrain = world.terrain() && world.terrain()->is_in_reach();
  const bool shows_steps = sees_terrain && request.terrain == TerrainShow::steps;
  is_under_ = !shows_steps && UnderwaterPass::is_under(world, request.camera);
  {
    const StageTimes::Scope stage(times_, Stage::transfer);
    if (world.has_sea() && !is_under_ && !shows_steps) water_.prepare(world, transfer_);
    sky_.prepare(world.sky());
    if (world.has_sea() || !world.meshes().empty()) shadows_.prepare(world, request.camera.eye_m);
    meshes_.prepare(world);
    if (sees_terrain) terrain_.prepare(world.terrain()->image(), transfer_);
  }
  if (shows_steps) {
    const StageTimes::Scope stage(times_, Stage::terrain);
    light_.bind();
    terrain_.draw_steps();
  } else {
    draw_cloudy_sky(world, request);
    if (!request.is_wanted() || !draw_light(world, request, sees_terrain)) return false;
    if (world.clouds() != nullptr && is_obstructed(request)) draw_clouds(world, request);
    // Water before the eye takes no light from highlights alone: their picture is not drawn anew.
    if (is_alone(request.highlights)) is_under_ = false;
    if (is_under_) {
      const StageTimes::Scope stage(times_, Stage::water);
      underwater_.draw(world, request.camera,
                       {.light = light_, .environment = sky_.environment(), .cloudy_sky = cloudy_sky_},
                       under_);
    }
  }
  show_light(request, shows_steps);
  require_no_gl_error("frame");
  return true;
}

}  // namespace offing::present
