#include "host/cli/terrain/flight_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace offing::cli {
namespace {

constexpr double pitch_rad = -10.0 * std::numbers::pi / 180.0;
// The height is the highest bound within so many steps before and behind, and then their mean.
constexpr int smoothed_steps = 60;

glm::dvec2 figure(const Flight& flight, double phase) {
  return {flight.width_m * (0.5 + 0.4 * std::sin(phase)),
          flight.depth_m * (0.5 + 0.4 * std::sin(2.0 * phase))};
}

}  // namespace

std::vector<Camera> flight_path(const Flight& flight) {
  const int points = flight.frames + 4 * smoothed_steps;
  std::vector<glm::dvec2> places;
  std::vector<double> bounds_m;
  double phase = 0.0;
  for (int i = 0; i < points; ++i) {
    const glm::dvec2 place = figure(flight, phase);
    places.push_back(place);
    bounds_m.push_back(flight.bound_m(place.x, place.y));
    constexpr double probe = 1e-6;
    phase += flight.step_m * probe / glm::length(figure(flight, phase + probe) - place);
  }
  std::vector<Camera> cameras;
  std::vector<double> highest_m;
  for (int i = 0; i < points; ++i) {
    const auto from = bounds_m.begin() + std::max(0, i - smoothed_steps);
    const auto to = bounds_m.begin() + std::min(points, i + smoothed_steps + 1);
    highest_m.push_back(*std::max_element(from, to));
  }
  for (int frame = 0; frame < flight.frames; ++frame) {
    const int at = frame + smoothed_steps;
    double sum_m = 0.0;
    for (int i = at - smoothed_steps; i <= at + smoothed_steps; ++i)
      sum_m += highest_m[static_cast<std::size_t>(i)];
    const glm::dvec2 here = places[static_cast<std::size_t>(at)],
                     way = places[static_cast<std::size_t>(at + 1)] - here;
    Camera camera;
    camera.eye_m = {here.x, sum_m / (2 * smoothed_steps + 1) + flight.height_m, here.y};
    camera.yaw_rad = std::atan2(way.x, -way.y);
    camera.pitch_rad = pitch_rad;
    cameras.push_back(camera);
  }
  return cameras;
}

}  // namespace offing::cli
