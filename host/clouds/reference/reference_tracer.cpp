#include "host/clouds/reference/reference_tracer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "host/base/error.h"
#include "host/base/parallel_for.h"
#include "host/clouds/reference/traced_paths.h"

namespace offing::clouds {
ReferenceTracer::ReferenceTracer(const ScatteringMedium& medium, const CloudLook& look,
                                 const CloudIllumination& light)
    : medium_(medium), phase_(look), albedo_(look.albedo), light_(light) {
  for (int i = 0; i < 3; ++i) {
    if (albedo_[i] >= 0.0 && albedo_[i] <= 1.0) continue;
    throw Error(ErrorKind::bad_input,
                fmt::format("look.albedo: expected numbers within [0, 1], got {}", albedo_[i]));
  }
}

void ReferenceTracer::trace(Ray ray, PathRandom& random, std::vector<glm::dvec3>& by_order) const {
  glm::dvec3 weight(1.0);
  for (std::size_t order = 0;; ++order) {
    const double distance = medium_.next_collision(ray, random);
    if (!std::isfinite(distance)) {
      by_order[std::min(order, by_order.size() - 1)] +=
          weight * (ray.direction.y >= 0.0 ? light_.sky_kcdpm2 : light_.ground_kcdpm2);
      return;
    }
    ray.origin_m += distance * ray.direction;
    weight *= medium_.albedo(ray.origin_m, albedo_);
    for (const CloudLight& sun : light_.suns) {
      // Light goes along -direction of both: the angle between the ways is that between the two.
      const double phase = phase_(glm::dot(ray.direction, sun.direction));
      by_order[std::min(order + 1, by_order.size() - 1)] +=
          weight * phase * medium_.transmittance({ray.origin_m, sun.direction}, random) * sun.illuminance_klx;
    }
    if (!survives(weight, random)) return;
    const double cosine = phase_.sample([&] { return random.next(); });
    ray.direction = turned(ray.direction, cosine, 2.0 * std::numbers::pi * random.next());
  }
}

Traced ReferenceTracer::radiance(const Ray& ray, const TraceOptions& options) const {
  return mean_over_paths(options, 1.0, [&](PathRandom& random, std::vector<glm::dvec3>& by_order) {
    trace(ray, random, by_order);
  });
}

TracedView ReferenceTracer::view_of(const glm::dvec3& middle_m, double radius_m, const glm::dvec3& toward_eye,
                                    const TraceOptions& options) const {
  const double area_m2 = std::numbers::pi * radius_m * radius_m;
  // Order 0 takes opacity, whose integral is asked for beside that of light.
  TracedView view;
  view.intensity_kcd =
      mean_over_paths(options, area_m2, [&](PathRandom& random, std::vector<glm::dvec3>& by_order) {
        const double distance_m = radius_m * std::sqrt(random.next()),
                     angle = 2.0 * std::numbers::pi * random.next();
        const glm::dvec3 beside = distance_m * turned(toward_eye, 0.0, angle);
        const Ray ray{middle_m + beside + 2.0 * radius_m * toward_eye, -toward_eye};
        const double opacity = 1.0 - medium_.transmittance(ray, random);
        trace(ray, random, by_order);
        by_order[0] = glm::dvec3(opacity);
      });
  view.covered_m2 = view.intensity_kcd.by_order[0].x;
  view.intensity_kcd.by_order[0] = glm::dvec3(0.0);
  return view;
}

TracedImage ReferenceTracer::image(const Camera& camera, const TraceOptions& options) const {
  require_valid(camera);
  require_valid(options);
  const int width = camera.width_px, height = camera.height_px;
  TracedImage picture;
  picture.image.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  picture.orders.assign(static_cast<std::size_t>(options.orders), picture.image);
  parallel_rows(
      height,
      [&](int row) {
        std::vector<glm::dvec3> by_order(static_cast<std::size_t>(options.orders) + 1);
        for (int column = 0; column < width; ++column) {
          const auto pixel = static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                             static_cast<std::size_t>(column);
          std::fill(by_order.begin(), by_order.end(), glm::dvec3(0.0));
          double opacity = 0.0;
          for (int i = 0; i < options.samples; ++i) {
            PathRandom random(options.seed, pixel * static_cast<std::uint64_t>(options.samples) +
                                                static_cast<std::uint64_t>(i));
            const double x = (column + random.next()) / width, y = (row + random.next()) / height;
            const Ray ray{camera.eye_m,
                          glm::normalize(ray_direction(camera, {2.0 * x - 1.0, 1.0 - 2.0 * y}))};
            opacity += (1.0 - medium_.transmittance(ray, random)) / options.samples;
            trace(ray, random, by_order);
          }
          glm::dvec3 sum(0.0);
          for (std::size_t order = 1; order < by_order.size(); ++order) {
            const glm::dvec3 light = by_order[order] / static_cast<double>(options.samples);
            sum += light;
            picture.orders[order - 1][pixel] = glm::vec4(light, opacity);
          }
          picture.image[pixel] = glm::vec4(sum, opacity);
        }
      },
      options.threads);
  return picture;
}

SlabLight trace_slab(double optical_depth, double incidence_cosine, double albedo, const CloudLook& look,
                     const TraceOptions& options) {
  if (!(incidence_cosine > 0.0 && incidence_cosine <= 1.0 && optical_depth > 0.0)) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("slab: expected a depth above 0 and a cosine within (0, 1], got {} and {}",
                            optical_depth, incidence_cosine));
  }
  const PhaseFunction phase(look);
  const SlabMedium slab(0.0, 1.0, optical_depth);
  // A photon is one path; x counts those that are reflected, y those let through.
  const Traced counted =
      mean_over_paths(options, 1.0, [&](PathRandom& random, std::vector<glm::dvec3>& by_order) {
        Ray ray{{0.0, 1.0, 0.0},
                {std::sqrt(1.0 - incidence_cosine * incidence_cosine), -incidence_cosine, 0.0}};
        for (std::size_t order = 0;; ++order) {
          const double distance = slab.next_collision(ray, random);
          if (!std::isfinite(distance)) {
            by_order[std::min(order, by_order.size() - 1)] +=
                ray.direction.y > 0.0 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
            return;
          }
          if (random.next() >= albedo) return;
          ray.origin_m += distance * ray.direction;
          const double cosine = phase.sample([&] { return random.next(); });
          ray.direction = turned(ray.direction, cosine, 2.0 * std::numbers::pi * random.next());
        }
      });
  SlabLight light;
  for (const glm::dvec3& order : counted.by_order) {
    light.reflected_by_order.push_back(order.x);
    light.transmitted_by_order.push_back(order.y);
    light.reflected += order.x;
    light.transmitted += order.y;
  }
  const auto error = [&](double share) { return std::sqrt(share * (1.0 - share) / options.samples); };
  light.reflected_error = error(light.reflected);
  light.transmitted_error = error(light.transmitted);
  return light;
}

}  // namespace offing::clouds
