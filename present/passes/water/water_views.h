#pragma once

#include "host/world/world.h"
#include "present/gl/render_target.h"
#include "present/gl/shader_program.h"
#include "present/gl/transfer.h"
#include "present/passes/clouds/cloud_pass.h"
#include "present/passes/clouds/cloud_shadows.h"
#include "present/passes/frame_request.h"
#include "present/passes/meshes/mesh_pass.h"
#include "present/passes/sky/cloudy_sky.h"
#include "present/passes/terrain/terrain_pass.h"
#include "present/passes/water/water_uniforms.h"

namespace offing::present {

/// Passes that show what is not water, prepared for a picture.
struct DryPasses {
  MeshPass& meshes;
  const CloudShadows& shadows;
  GLuint environment;  ///< the map of SkyPass
  const CloudySky& cloudy_sky;
};

/// What is not water, as small pictures that the water's shader looks things up in (O13): what level water at
/// height 0 mirrors, meshes, ground and clouds, drawn from the eye's mirror image; and what lies in and
/// behind the water, meshes and ground, drawn from the eye itself. Light is premultiplied, with how much of a
/// pixel is covered; the sky shows through.
class WaterViews {
 public:
  WaterViews() = default;

  /// Draws both, `longer_px` pixels along the picture's longer side or as many as it has itself; none with 0.
  /// What has nothing to show is left out.
  void draw(world::World& world, const FrameRequest& request, int longer_px, const DryPasses& passes,
            Transfer& transfer);
  /// Whether the last draw() has something mirrored, with a depth or clouds alone, and something beneath.
  bool has_mirrored() const { return has_mirrored_; }
  bool has_mirrored_things() const { return has_mirrored_things_; }
  bool has_beneath() const { return has_beneath_; }
  /// Gives them to a program in use (water_views.glsl), by unit_count texture units.
  void bind(const ShaderProgram& program, int first_unit) const;
  /// Fills in the uniforms that this shader reads of them.
  void describe(glsl::WaterUniforms& water) const;
  static constexpr int unit_count = 4;

 private:
  void draw_mirrored(world::World& world, const FrameRequest& request, const DryPasses& passes,
                     Transfer& transfer);
  void draw_beneath(world::World& world, const FrameRequest& request, const DryPasses& passes,
                    Transfer& transfer);

  TerrainPass mirrored_terrain_, terrain_beneath_;
  CloudPass mirrored_clouds_;
  RenderTarget mirrored_, beneath_;
  bool has_mirrored_ = false, has_mirrored_things_ = false, has_beneath_ = false;
  bool mirrors_clouds_ = false;
};

}  // namespace offing::present
