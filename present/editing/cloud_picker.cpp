#include "present/editing/cloud_picker.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "host/clouds/particles/particle_motion.h"

namespace offing::present {
namespace {

std::vector<Sphere> particles_of(const ShownClouds& shown, std::size_t cloud) {
  std::vector<Sphere> spheres;
  if (shown.view == nullptr) return spheres;
  const std::vector<CloudParticle> particles = shown_particles(*shown.view, cloud);
  if (particles.empty()) return spheres;
  const glm::dvec3 origin_m = clouds::cloud_origin_m(shown.view->parameters().clouds[cloud], shown.time_s);
  for (const CloudParticle& particle : particles) {
    spheres.push_back({origin_m + glm::dvec3(particle.x, particle.y, particle.z), particle.radius});
  }
  return spheres;
}

}  // namespace

Sphere sphere_of(const ShownClouds& shown, const CloudPart& part) {
  std::vector<Sphere> spheres = balls_of(shown.scene, part.cloud, shown.time_s);
  if (part.ball) return spheres[*part.ball];
  if (spheres.empty()) spheres = particles_of(shown, part.cloud);
  if (spheres.empty()) {
    return {origin_of_cloud(shown.scene, part.cloud, shown.time_s),
            shown.scene.clouds[part.cloud].scale * shown.scene.clouds[part.cloud].shape.size_m};
  }
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
  for (const Sphere& sphere : spheres) {
    low = glm::min(low, sphere.centre_m - sphere.radius_m);
    high = glm::max(high, sphere.centre_m + sphere.radius_m);
  }
  const glm::dvec3 half_m = 0.5 * (high - low);
  return {low + half_m, std::max({half_m.x, half_m.y, half_m.z})};
}

std::optional<CloudPart> pick_ball(const ShownClouds& shown, const Ray& ray,
                                   const std::optional<CloudPart>& last) {
  std::vector<std::pair<double, CloudPart>> met;
  for (std::size_t cloud = 0; cloud < shown.scene.clouds.size(); ++cloud) {
    if (is_hidden(shown.scene, cloud)) continue;
    const std::vector<Sphere> spheres = balls_of(shown.scene, cloud, shown.time_s);
    for (std::size_t ball = 0; ball < spheres.size(); ++ball) {
      const std::optional<double> miss = miss_of(ray, spheres[ball]);
      if (miss && *miss <= 1.0) met.emplace_back(*miss, CloudPart{cloud, ball});
    }
  }
  if (met.empty()) return {};
  std::stable_sort(met.begin(), met.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  const auto found =
      std::find_if(met.begin(), met.end(), [&](const auto& hit) { return hit.second == last; });
  if (found == met.end()) return met.front().second;
  return met[static_cast<std::size_t>(found - met.begin() + 1) % met.size()].second;
}

std::optional<CloudPart> pick_cloud(const ShownClouds& shown, const Ray& ray) {
  if (shown.view == nullptr) return {};
  std::optional<std::size_t> nearest;
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t cloud = 0; cloud < shown.view->parameters().clouds.size(); ++cloud) {
    for (const Sphere& particle : particles_of(shown, cloud)) {
      const std::optional<double> miss = miss_of(ray, particle);
      // Half the radius: the rim of a particle cannot be seen.
      if (!miss || *miss > 0.5) continue;
      const double distance_m = glm::distance(ray.origin_m, particle.centre_m);
      if (distance_m >= least_m) continue;
      least_m = distance_m;
      nearest = cloud;
    }
  }
  if (!nearest || *nearest >= shown.scene.clouds.size()) return {};
  return CloudPart{*nearest, {}};
}

std::vector<CloudPart> parts_in(const ShownClouds& shown, const Screen& screen, const ClipBox& box,
                                PartKind kind) {
  const glm::dvec2 a = pixel_of_clip(screen, box.low), b = pixel_of_clip(screen, box.high);
  const glm::dvec2 low = glm::min(a, b), high = glm::max(a, b);
  const auto is_in = [&](const Sphere& sphere) {
    const std::optional<glm::dvec2> px = pixel_of(screen, sphere.centre_m);
    return px && px->x >= low.x && px->x <= high.x && px->y >= low.y && px->y <= high.y;
  };
  std::vector<CloudPart> parts;
  for (std::size_t cloud = 0; cloud < shown.scene.clouds.size(); ++cloud) {
    if (is_hidden(shown.scene, cloud)) continue;
    if (kind == PartKind::clouds) {
      if (is_in(sphere_of(shown, {cloud, {}}))) parts.push_back({cloud, {}});
      continue;
    }
    const std::vector<Sphere> spheres = balls_of(shown.scene, cloud, shown.time_s);
    for (std::size_t ball = 0; ball < spheres.size(); ++ball) {
      if (is_in(spheres[ball])) parts.push_back({cloud, ball});
    }
  }
  return parts;
}

}  // namespace offing::present
