#include "present/passes/water/hull_mask.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include <glm/matrix.hpp>

namespace offing::present {
namespace {

constexpr int channels = 4;
// Where a map has no hull: higher than any water, so that the rim is below the underside.
constexpr float no_hull_m = 1e9f;

std::vector<float> texels_of(const std::vector<std::shared_ptr<const bodies::HullMap>>& maps) {
  std::vector<float> texels;
  for (const auto& map : maps) {
    for (std::size_t i = 0; i < map->bottom_m.size(); ++i) {
      texels.insert(texels.end(),
                    {std::min(map->bottom_m[i], no_hull_m), std::max(map->rim_m[i], -no_hull_m), 0.0f, 0.0f});
    }
  }
  return texels;
}

/// Columns, rows and metres of a hull's map by the place from the eye.
std::array<glm::vec4, 3> planes_of(const world::WorldBodies& bodies, std::size_t body, double time_s,
                                   const glm::dvec3& eye_m) {
  const world::BodySettings& settings = bodies.settings()[body];
  const bodies::HullMap& map = *settings.map;
  const bodies::BodyPose pose = bodies.pose(body, time_s);
  const glm::dmat3 to_hull = glm::transpose(glm::mat3_cast(pose.turn));
  const glm::dvec3 eye_in_hull_m = to_hull * (eye_m - pose.mass_centre_m) + settings.body.mass_centre_m;
  const glm::dvec3 origin_m(map.low_x_m, 0.0, map.low_z_m), cell_m(map.cell_x_m, 1.0, map.cell_z_m);
  std::array<glm::vec4, 3> planes{};
  std::size_t next = 0;
  for (const int axis : {0, 2, 1}) {
    const glm::dvec3 along(to_hull[0][axis], to_hull[1][axis], to_hull[2][axis]);
    planes[next++] = {glm::vec3(along / cell_m[axis]),
                      static_cast<float>((eye_in_hull_m[axis] - origin_m[axis]) / cell_m[axis])};
  }
  return planes;
}

/// Where a hull is not drawn, water is.
bool is_drawn(const world::World& world, const world::BodySettings& settings) {
  return settings.mesh >= world.meshes().size() || world.meshes()[settings.mesh].is_visible();
}

}  // namespace

void HullMask::prepare(const world::World& world, const Camera& camera, glsl::SurfaceUniforms& grid) {
  std::vector<std::shared_ptr<const bodies::HullMap>> maps;
  if (const world::WorldBodies* bodies = world.bodies()) {
    for (std::size_t body = 0; body < bodies->size() && maps.size() < glsl::most_hulls; ++body) {
      if (!is_drawn(world, bodies->settings()[body])) continue;
      std::ranges::copy(planes_of(*bodies, body, world.time_s(), camera.eye_m),
                        grid.hull_planes + 3 * maps.size());
      maps.push_back(bodies->settings()[body].map);
    }
  }
  grid.hull_count = static_cast<int>(maps.size());
  // Without a hull an empty map is there, for drivers that want one.
  if (maps != maps_ || texture_.count() == 0) {
    texture_ = TextureArray({.width = maps.empty() ? 1 : bodies::HullMap::columns,
                             .height = maps.empty() ? 1 : bodies::HullMap::rows,
                             .layers = std::max(1, static_cast<int>(maps.size())),
                             .channels = channels});
    const std::vector<float> texels = maps.empty() ? std::vector<float>(channels) : texels_of(maps);
    texture_.specify(texels.data());
    maps_ = std::move(maps);
  }
}

void HullMask::bind(const ShaderProgram& program, int unit) const {
  texture_.bind(unit);
  program.set("hull_maps", unit);
}

}  // namespace offing::present
