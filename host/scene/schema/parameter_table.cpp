#include "host/scene/schema/parameter_table.h"

#include <algorithm>

#include "host/scene/schema/sections.h"

namespace offing::scene {

namespace {

// The largest counts keep hostile scenes cheap, but for those of bodies: the shaders of the water keep so
// many dry (present/passes/water/hull_mask.glsl).
constexpr std::size_t max_bookmarks = 64, max_lights = 32, max_lakes = 16, max_meshes = 256, max_bodies = 16;
constexpr std::size_t max_cloud_layers = 64, max_clouds = 4096;

/// The sections of a scene.
Schema<Scene> scene_schema() {
  Schema<Scene> scene;
  scene.section(&Scene::world, world_schema())
      .section(&Scene::time, time_schema())
      .section(&Scene::wind, wind_schema())
      .section(&Scene::ocean, ocean_schema())
      .section(&Scene::view, camera_schema())
      .section(&Scene::view, walk_schema())
      .section(&Scene::view, render_schema())
      .list(&Scene::bookmarks, max_bookmarks, bookmark_schema())
      .section(&Scene::view, sun_schema())
      .section(&Scene::view, sky_schema())
      .section(&Scene::terrain, terrain_schema())
      .list(&Scene::lakes, max_lakes, lake_schema())
      .list(&Scene::lights, max_lights, light_schema())
      .list(&Scene::meshes, max_meshes, mesh_schema())
      .list(&Scene::bodies, max_bodies, body_schema())
      .section(&Scene::cloud_settings, clouds_schema())
      .list(&Scene::cloud_layers, max_cloud_layers, cloud_layer_schema())
      .list(&Scene::clouds, max_clouds, cloud_schema());
  return scene;
}

}  // namespace

std::span<const Parameter> parameter_table() {
  static const SchemaTable table(scene_schema().node());
  return table.rows();
}

const Parameter* find_parameter(std::string_view key) {
  for (const Parameter& parameter : parameter_table()) {
    if (parameter.key == key) {
      return &parameter;
    }
  }
  return nullptr;
}

const Parameter* find_by_alias(std::string_view key) {
  const auto row = std::ranges::find(parameter_table(), key, &Parameter::alias);
  return row == parameter_table().end() ? nullptr : &*row;
}

}  // namespace offing::scene
