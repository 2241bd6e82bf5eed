#include "present/passes/water/water_views.h"

#include <algorithm>
#include <cmath>

#include "present/passes/camera_projection.h"

namespace offing::present {
namespace {

constexpr double margin = 1.25;  // width of both pictures over that of the water's

Camera smaller(const Camera& camera, int longer_px) {
  const int own_px = std::max(camera.width_px, camera.height_px);
  return scaled_camera(camera, std::min(1.0, static_cast<double>(longer_px) / own_px));
}

/// Waves mirror and bend rays to what lies beside the picture too.
Camera wider(Camera camera, double by) {
  camera.vertical_field_of_view_rad = 2.0 * std::atan(by * std::tan(0.5 * camera.vertical_field_of_view_rad));
  return camera;
}

void begin(RenderTarget& target, const Camera& camera) {
  if (target.width() != camera.width_px || target.height() != camera.height_px) {
    target =
        RenderTarget(camera.width_px, camera.height_px, GL_RGBA16F, RenderTarget::Depth::single_precision);
  }
  target.bind();
  glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  glClearDepth(0.0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

}  // namespace

void WaterViews::draw(world::World& world, const FrameRequest& request, int longer_px,
                      const DryPasses& passes, Transfer& transfer) {
  FrameRequest of_view = request;
  of_view.camera = wider(smaller(request.camera, longer_px), margin);
  has_beneath_ = longer_px > 0 && (!world.meshes().empty() || world.terrain() != nullptr);
  has_mirrored_things_ = has_beneath_;
  mirrors_clouds_ = longer_px > 0 && world.clouds() != nullptr && request.quality.mirrors_finely;
  has_mirrored_ = has_mirrored_things_ || mirrors_clouds_;
  if (has_mirrored_) draw_mirrored(world, of_view, passes, transfer);
  if (has_beneath_) draw_beneath(world, of_view, passes, transfer);
}

void WaterViews::draw_mirrored(world::World& world, const FrameRequest& request, const DryPasses& passes,
                               Transfer& transfer) {
  FrameRequest from_below = request;
  from_below.camera = mirrored(request.camera, world.sea_level_m());
  begin(mirrored_, from_below.camera);
  // One ray a pixel: no pixel is covered in part.
  world.see_mirrored_terrain(from_below.camera);
  if (world.terrain() != nullptr && world.terrain()->mirrored() != nullptr) {
    mirrored_terrain_.prepare(*world.terrain()->mirrored(), transfer);
    mirrored_.bind();
    mirrored_terrain_.draw(from_below.camera, TerrainPass::Part::covered);
  }
  // Meshes alone reach below the plane.
  passes.meshes.draw_plainly(world, from_below, passes.environment, passes.shadows, MeshPart::above_sea,
                             mirrored_);
  if (mirrors_clouds_) {
    world.see_mirrored_clouds(from_below.camera);
    mirrored_clouds_.prepare(world.device(), drawn_clouds(world), from_below.camera, mirrored_, transfer);
    mirrored_.bind();
    mirrored_clouds_.draw(above_level(from_below.camera, world.sea_level_m()), world.parameters().atmosphere,
                          passes.environment);
  }
  mirrored_.fill_levels();
}

void WaterViews::draw_beneath(world::World& world, const FrameRequest& request, const DryPasses& passes,
                              Transfer& transfer) {
  begin(beneath_, request.camera);
  world.see_terrain_beneath(request.camera);
  if (world.terrain() != nullptr && world.terrain()->beneath() != nullptr) {
    terrain_beneath_.prepare(*world.terrain()->beneath(), transfer);
    beneath_.bind();
    terrain_beneath_.draw(request.camera, TerrainPass::Part::covered);
  }
  passes.meshes.draw_plainly(world, request, passes.environment, passes.shadows, MeshPart::all, beneath_);
}

void WaterViews::bind(const ShaderProgram& program, int first_unit) const {
  const auto bind_view = [&](bool has_any, const RenderTarget& view, const char* light, const char* depth,
                             int unit) {
    bind_sampler(program, light, unit, has_any ? view.texture() : 0);
    bind_sampler(program, depth, unit + 1, has_any ? view.depth_texture() : 0);
  };
  bind_view(has_mirrored_, mirrored_, "mirrored_light", "mirrored_depth", first_unit);
  bind_view(has_beneath_, beneath_, "beneath_light", "beneath_depth", first_unit + 2);
}

void WaterViews::describe(glsl::WaterUniforms& water) const {
  water.image_has_clouds = mirrors_clouds_ ? 1.0f : 0.0f;
  water.views_margin = static_cast<float>(margin);
}

}  // namespace offing::present
