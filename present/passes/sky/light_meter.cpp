#include "present/passes/sky/light_meter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

namespace offing::present {
namespace {

constexpr int meter_columns = 9, meter_rows = 7;
// What the mean of the sky comes out at before the tone curve, where 1 is white.
constexpr double key = 0.36;
// What white in all the light on meshes comes out at: colours in half of it are half as bright.
constexpr double mesh_key = 1.8;
// Below this light, deep dusk, pictures grow dark as the eye's do.
constexpr double least_kcdpm2 = 1e-4;

// Of ground between woods and scree.
constexpr double mean_albedo = 0.2;

double level_ground_kcdpm2(const world::World& world) {
  const sky::Illuminance& light = world.illuminance();
  const double level_sun = std::max(0.0, static_cast<double>(world.sky().params().sun_direction_y));
  return mean_albedo / std::numbers::pi *
         (level_sun * sky::luminance(light.sun_klx) + sky::luminance(light.sky_klx));
}

/// Light of a white surface that faces all light there is.
double white_kcdpm2(const world::World& world) {
  double sum_klx = sky::luminance(world.illuminance().sky_klx) + sky::luminance(world.illuminance().sun_klx);
  for (const world::Light& light : world.parameters().lights) {
    const glm::dvec3 klx = light.illuminance_klx * light.colour;
    sum_klx += sky::luminance({klx.r, klx.g, klx.b});
  }
  return sum_klx / std::numbers::pi;
}

std::vector<glm::dvec3> metered_rays(const Camera& camera) {
  std::vector<glm::dvec3> rays;
  for (int row = 0; row < meter_rows; ++row) {
    for (int column = 0; column < meter_columns; ++column) {
      const glm::dvec2 clip((2.0 * column + 1.0) / meter_columns - 1.0, (2.0 * row + 1.0) / meter_rows - 1.0);
      rays.push_back(glm::normalize(ray_direction(camera, clip)));
    }
  }
  return rays;
}

/// How far a ray from an eye ends on ground rather than on water, 0 ... 1: smooth in the place of the eye, as
/// a ray that just touches ground is of half of each. `phase`, below 1, shifts the places that are tried, so
/// that rays side by side do not find an edge at once.
double land_share(const world::World& world, const Camera& camera, const glm::dvec3& ray, double phase) {
  constexpr int steps = 32;
  constexpr double soft_rad = 0.04;  // between two rows of a common camera's rays
  constexpr double soft_m = 1.0;     // of height at the water's edge
  const double above_sea_m = camera.eye_m.y - world.sea_level_m();
  if (ray.y >= 0.0 || above_sea_m <= 0.0) return 0.0;
  const double end_m = above_sea_m / -ray.y;
  const auto ground_over_m = [&](double distance_m) {
    const glm::dvec3 place_m = camera.eye_m + distance_m * ray;
    const std::optional<double> ground_m = world.terrain()->surface_m(place_m.x, place_m.z);
    return ground_m ? *ground_m - place_m.y : -std::numeric_limits<double>::infinity();
  };
  double share = std::max(0.0, 0.5 + ground_over_m(end_m) / soft_m);
  for (int step = 1; step <= steps && share < 1.0; ++step) {
    const double part = (step - phase) / steps, distance_m = end_m * part * part;
    share = std::max(share, 0.5 + 0.5 * ground_over_m(distance_m) / (soft_rad * distance_m));
  }
  return std::min(share, 1.0);
}

/// The same of all metered rays; empty where all below the horizon is one of the two. Maps in tiles would
/// have to be read far away: their seas count as open.
std::vector<double> land_shares(const world::World& world, const Camera& camera) {
  if (!world.has_sea() || !world.terrain() || !world.terrain()->parameters().map) return {};
  std::vector<double> shares;
  constexpr int stride = 4;  // between phases of rays side by side
  const std::vector<glm::dvec3> rays = metered_rays(camera);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const double phase = static_cast<double>(i * stride % meter_columns) / meter_columns;
    shares.push_back(land_share(world, camera, rays[i], phase));
  }
  return shares;
}

std::vector<std::array<double, 3>> metered_directions(const Camera& camera, bool has_water) {
  std::vector<std::array<double, 3>> directions;
  for (const glm::dvec3& ray : metered_rays(camera)) {
    // Water mirrors the sky above it; grazing rays see it higher up, where waves turn toward the eye.
    const glm::dvec3 mirrored = glm::normalize(glm::dvec3(ray.x, std::abs(ray.y) + 0.02, ray.z));
    const glm::dvec3 seen = has_water || ray.y >= 0.0 ? mirrored : ray;
    directions.push_back({seen.x, seen.y, seen.z});
  }
  return directions;
}

}  // namespace

double LightMeter::exposure(const world::World& world, const Camera& camera, double ev) {
  if (!world.meshes().empty() && !world.has_sea() && !world.terrain()) {
    return mesh_key * std::exp2(ev) / (white_kcdpm2(world) + least_kcdpm2);
  }
  const sky::ClearSky& sky = world.sky();
  const bool has_water = world.has_sea() || !world.terrain();
  std::vector<std::array<double, 3>> directions = metered_directions(camera, has_water);
  std::vector<double> shares = land_shares(world, camera);
  if (sky.revision() != revision_ || directions != directions_ || has_water != has_water_ ||
      shares != land_shares_) {
    const double ground_kcdpm2 = level_ground_kcdpm2(world);
    const sky::SkyLight light = sky.read_light(directions);
    double log_sum = 0.0;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const bool is_ground = !has_water && directions[i][1] < 0.0;
      const double land = is_ground ? 1.0 : shares.empty() ? 0.0 : shares[i];
      if (land > 0.0) log_sum += land * std::log(ground_kcdpm2 + least_kcdpm2);
      if (land < 1.0) log_sum += (1.0 - land) * std::log(sky::luminance(light.sky_kcdpm2[i]) + least_kcdpm2);
    }
    mean_stops_ = log_sum / std::log(2.0) / static_cast<double>(directions.size());
    revision_ = sky.revision();
    has_water_ = has_water;
    directions_ = std::move(directions);
    land_shares_ = std::move(shares);
  }
  return key * std::exp2(ev - mean_stops_);
}

}  // namespace offing::present
