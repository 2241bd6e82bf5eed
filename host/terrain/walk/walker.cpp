#include "host/terrain/walk/walker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "host/base/error.h"
#include "host/terrain/field/terrain_posts.h"

namespace offing::terrain {
namespace {

constexpr double fastest_mps = 1000.0;
// Parts of a step are at most this long, so that no patch is stepped over but at its corners.
constexpr double longest_part_cells = 0.25;
constexpr double longest_rest_s = 0.5, least_progress_m = 1e-3;

void require(bool is_valid, const char* name, const char* expected, double found) {
  if (is_valid) return;
  throw Error(ErrorKind::bad_input, fmt::format("walker: {}: expected {}, found {:g}", name, expected, found),
              "give a number within that range");
}

/// Up the slope.
glm::dvec2 gradient_of(const glm::dvec3& normal) {
  return glm::dvec2(-normal.x, -normal.z) / normal.y;
}

}  // namespace

void require_valid(const WalkerParameters& parameters) {
  const auto [eye_height_m, slope_limit_rad, gravity_mps2] = parameters;
  require(eye_height_m >= 0.0 && eye_height_m <= 1000.0, "eye_height_m", "0 ... 1000 m", eye_height_m);
  require(slope_limit_rad >= 0.01 && slope_limit_rad <= 1.5, "slope_limit_rad", "0.01 ... 1.5",
          slope_limit_rad);
  require(gravity_mps2 >= 0.01 && gravity_mps2 <= 1000.0, "gravity_mps2", "0.01 ... 1000 m/s^2",
          gravity_mps2);
}

Walker::Walker(TerrainPosts posts, const WalkerParameters& parameters)
    : posts_(std::move(posts)),
      parameters_(parameters),
      least_normal_y_(std::cos(parameters.slope_limit_rad)),
      friction_(std::tan(parameters.slope_limit_rad)) {
  require_valid(parameters);
  reset(0.5 * posts_.width_m(), 0.5 * posts_.depth_m());
}

void Walker::reset(double x_m, double z_m, double time_s) {
  const auto terrain = terrain_at(posts_, x_m, z_m);
  if (!terrain) {
    throw Error(ErrorKind::bad_input,
                fmt::format("walker: expected a place within the map, found {:g}, {:g} m", x_m, z_m),
                fmt::format("it reaches from 0 to {:g} m and {:g} m", posts_.width_m(), posts_.depth_m()));
  }
  require(std::isfinite(time_s), "time_s", "a finite time", time_s);
  start_s_ = time_s_ = time_s;
  steps_ = 0;
  feet_ = {.place_m = {x_m, terrain->height_m, z_m}};
  if (!holds(terrain->normal)) begin_fall(feet_);
  show(feet_);
}

void Walker::advance_to(double time_s, glm::dvec2 wanted_mps) {
  require(std::isfinite(time_s), "time_s", "a finite time", time_s);
  const double speed_mps = glm::length(wanted_mps);
  require(speed_mps <= fastest_mps, "wanted velocity", "at most 1000 m/s", speed_mps);
  if (time_s <= time_s_) return;
  time_s_ = time_s;
  while (start_s_ + static_cast<double>(steps_ + 1) * step_s <= time_s) {
    step(feet_, step_s, wanted_mps);
    ++steps_;
  }
  // What is left of the time shows, but is taken again as part of its whole step.
  Feet feet = feet_;
  const double rest_s = time_s - (start_s_ + static_cast<double>(steps_) * step_s);
  if (rest_s > 0.0) step(feet, rest_s, wanted_mps);
  show(feet);
}

glm::dvec2 Walker::within_map(glm::dvec2 place_m) const {
  const glm::dvec2 extent_m(posts_.width_m(), posts_.depth_m());
  return glm::clamp(place_m, glm::dvec2(0.0), extent_m);
}

bool Walker::holds(const glm::dvec3& normal) const {
  return normal.y >= least_normal_y_;
}

void Walker::step(Feet& feet, double duration_s, glm::dvec2 wanted_mps) const {
  const glm::dvec2 falling_mps(feet.velocity_mps.x, feet.velocity_mps.z);
  const double way_m = glm::length(feet.is_falling ? falling_mps : wanted_mps) * duration_s;
  const double part_m = longest_part_cells * std::min(posts_.spacing_x_m, posts_.spacing_z_m);
  const double parts = std::max(1.0, std::ceil(way_m / part_m));
  for (double part = 0.0; part < parts; ++part) {
    if (feet.is_falling) {
      fall(feet, duration_s / parts);
    } else {
      walk(feet, duration_s / parts, wanted_mps);
    }
  }
}

void Walker::walk(Feet& feet, double duration_s, glm::dvec2 wanted_mps) const {
  const glm::dvec2 from_m(feet.place_m.x, feet.place_m.z);
  const auto go_to = [&](glm::dvec2 place_m, double height_m) {
    const glm::dvec3 next_m(place_m.x, height_m, place_m.y);
    feet.velocity_mps = (next_m - feet.place_m) / duration_s;
    feet.place_m = next_m;
  };
  const glm::dvec2 wanted_m = within_map(from_m + duration_s * wanted_mps);
  const TerrainPoint ahead = *terrain_at(posts_, wanted_m.x, wanted_m.y);
  if (wanted_m == from_m || holds(ahead.normal)) return go_to(wanted_m, ahead.height_m);
  if (ahead.height_m < feet.place_m.y) {
    const glm::dvec2 velocity_mps = (wanted_m - from_m) / duration_s;
    feet.velocity_mps = {velocity_mps.x, 0.0, velocity_mps.y};
    begin_fall(feet);
    return fall(feet, duration_s);
  }
  // Along the steep ground's contours, or along the border of its cell.
  const glm::dvec2 uphill = glm::normalize(gradient_of(ahead.normal));
  const double against_mps = std::max(0.0, glm::dot(wanted_mps, uphill));
  for (const glm::dvec2 along_mps :
       {wanted_mps - against_mps * uphill, glm::dvec2(wanted_mps.x, 0.0), glm::dvec2(0.0, wanted_mps.y)}) {
    const glm::dvec2 place_m = within_map(from_m + duration_s * along_mps);
    const TerrainPoint terrain = *terrain_at(posts_, place_m.x, place_m.y);
    if (holds(terrain.normal)) return go_to(place_m, terrain.height_m);
  }
  feet.velocity_mps = glm::dvec3(0.0);
}

void Walker::begin_fall(Feet& feet) const {
  feet.is_falling = true;
  feet.lowest_m = feet.place_m.y;
  feet.held_s = 0.0;
}

void Walker::fall(Feet& feet, double duration_s) const {
  glm::dvec3& velocity_mps = feet.velocity_mps;
  const double gained_mps = parameters_.gravity_mps2 * duration_s;
  const glm::dvec2 ahead_m =
      glm::dvec2(feet.place_m.x + duration_s * velocity_mps.x, feet.place_m.z + duration_s * velocity_mps.z);
  const glm::dvec2 place_m = within_map(ahead_m);
  if (place_m.x != ahead_m.x) velocity_mps.x = 0.0;
  if (place_m.y != ahead_m.y) velocity_mps.z = 0.0;
  const TerrainPoint terrain = *terrain_at(posts_, place_m.x, place_m.y);
  const double height_m = feet.place_m.y + duration_s * (velocity_mps.y - 0.5 * gained_mps);
  velocity_mps.y -= gained_mps;
  feet.place_m = {place_m.x, std::max(height_m, terrain.height_m), place_m.y};
  feet.held_s = feet.place_m.y < feet.lowest_m - least_progress_m ? 0.0 : feet.held_s + duration_s;
  if (feet.held_s == 0.0) feet.lowest_m = feet.place_m.y;
  if (height_m > terrain.height_m) return;
  if (holds(terrain.normal) || feet.held_s >= longest_rest_s) {
    feet.is_falling = false;
    feet.velocity_mps = glm::dvec3(0.0);
    return;
  }
  // The ground takes what goes into it, and of the rest what it rubs off in return (Coulomb).
  const double into_mps = std::max(0.0, -glm::dot(velocity_mps, terrain.normal));
  const glm::dvec3 along_mps = velocity_mps + into_mps * terrain.normal;
  const double speed_mps = glm::length(along_mps);
  velocity_mps =
      speed_mps > 0.0 ? along_mps * std::max(0.0, 1.0 - friction_ * into_mps / speed_mps) : along_mps;
}

void Walker::show(const Feet& feet) {
  shown_ = {.eye_m = feet.place_m + glm::dvec3(0.0, parameters_.eye_height_m, 0.0),
            .velocity_mps = feet.velocity_mps,
            .is_falling = feet.is_falling};
}

}  // namespace offing::terrain
