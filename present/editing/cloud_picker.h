#pragma once

#include <optional>
#include <vector>

#include "host/world/world_clouds.h"
#include "present/editing/cloud_edits.h"
#include "present/editing/particle_picks.h"

namespace offing::present {

/// The clouds of a scene as they are shown at a time. `view` may lag behind the scene, and be none.
struct ShownClouds {
  const scene::Scene& scene;
  const world::WorldClouds* view = nullptr;
  double time_s = 0.0;
};

/// Where a part is and how large: of a whole cloud the middle of the box around its balls or its particles,
/// and half the box's longest edge.
Sphere sphere_of(const ShownClouds& shown, const CloudPart& part);

/// The ball that a ray passes nearest to its middle, in its radii, of those that it meets; after `last`,
/// where that is one of them, the next one. Nothing where it meets none.
std::optional<CloudPart> pick_ball(const ShownClouds& shown, const Ray& ray,
                                   const std::optional<CloudPart>& last);

/// The cloud whose particle a ray meets first; nothing where there is none, or it is a layer's.
std::optional<CloudPart> pick_cloud(const ShownClouds& shown, const Ray& ray);

/// Balls, or whole clouds, whose middles a box on the screen shows.
enum class PartKind { balls, clouds };
std::vector<CloudPart> parts_in(const ShownClouds& shown, const Screen& screen, const ClipBox& box,
                                PartKind kind);

}  // namespace offing::present
