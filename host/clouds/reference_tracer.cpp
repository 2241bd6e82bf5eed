#include "host/clouds/reference_tracer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "host/base/error.h"
#include "host/base/parallel_rows.h"

namespace offing::clouds {
namespace {

// Paths of a block are summed in their order, and blocks in theirs: the sum does not depend on threads.
constexpr int paths_of_block = 256;
// Paths that carry less than this go on with a chance in proportion.
constexpr double least_sure_weight = 0.01;

void require_valid(const TraceOptions& options) {
  if (options.samples >= 1 && options.orders >= 1) return;
  throw Error(ErrorKind::bad_usage,
              fmt::format("trace: expected samples and orders of 1 or more, got {} and {}", options.samples,
                          options.orders));
}

/// `direction` turned by an angle of this cosine, and around by `around_rad`. Frame: Duff et al. 2017,
/// "Building an orthonormal basis, revisited".
glm::dvec3 turned(const glm::dvec3& direction, double cosine, double around_rad) {
  const double sign = std::copysign(1.0, direction.z), a = -1.0 / (sign + direction.z),
               b = direction.x * direction.y * a;
  const glm::dvec3 right(1.0 + sign * direction.x * direction.x * a, sign * b, -sign * direction.x),
      up(b, sign + direction.y * direction.y * a, -direction.y);
  const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
  return glm::normalize(sine * std::cos(around_rad) * right + sine * std::sin(around_rad) * up +
                        cosine * direction);
}

/// Whether a path goes on; its weight grows by what the chance of that takes.
bool survives(glm::dvec3& weight, PathRandom& random) {
  const double most = std::max({weight.x, weight.y, weight.z});
  if (most >= least_sure_weight) return true;
  weight *= least_sure_weight / std::max(most, 1e-300);
  return random.next() * least_sure_weight < most;
}

/// Sums over paths: `make(path, by_order)` gives the light of one.
struct PathSums {
  std::vector<glm::dvec3> by_order;
  glm::dvec3 scattered{0.0}, squares{0.0};

  void add(const std::vector<glm::dvec3>& path) {
    glm::dvec3 sum(0.0);
    for (std::size_t order = 0; order < path.size(); ++order) {
      by_order[order] += path[order];
      if (order > 0) sum += path[order];
    }
    scattered += sum;
    squares += sum * sum;
  }
  void add(const PathSums& other) {
    for (std::size_t order = 0; order < by_order.size(); ++order) by_order[order] += other.by_order[order];
    scattered += other.scattered;
    squares += other.squares;
  }
};

/// The mean over all paths, times `scale`.
template <typename Make>
Traced mean_over_paths(const TraceOptions& options, double scale, const Make& make) {
  require_valid(options);
  const auto orders = static_cast<std::size_t>(options.orders) + 1;
  const int blocks = (options.samples + paths_of_block - 1) / paths_of_block;
  std::vector<PathSums> sums(static_cast<std::size_t>(blocks));
  parallel_rows(
      blocks,
      [&](int block) {
        PathSums& sum = sums[static_cast<std::size_t>(block)];
        sum.by_order.resize(orders);
        std::vector<glm::dvec3> path(orders);
        const int end = std::min(options.samples, (block + 1) * paths_of_block);
        for (int i = block * paths_of_block; i < end; ++i) {
          std::fill(path.begin(), path.end(), glm::dvec3(0.0));
          PathRandom random(options.seed, static_cast<std::uint64_t>(i));
          make(random, path);
          sum.add(path);
        }
      },
      options.threads);
  PathSums all;
  all.by_order.resize(orders);
  for (const PathSums& sum : sums) all.add(sum);
  const double count = options.samples;
  Traced traced;
  for (const glm::dvec3& order : all.by_order) traced.by_order.push_back(scale * order / count);
  traced.scattered = scale * all.scattered / count;
  const glm::dvec3 mean = all.scattered / count;
  const glm::dvec3 variance = glm::max(all.squares / count - mean * mean, glm::dvec3(0.0));
  traced.standard_error = scale * glm::sqrt(variance / std::max(1.0, count - 1.0));
  return traced;
}

}  // namespace

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
    weight *= albedo_;
    for (const CloudSun& sun : light_.suns) {
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

std::vector<TracedIntensity> ReferenceTracer::intensities(const glm::dvec3& middle_m, double radius_m,
                                                          std::span<const glm::dvec3> toward_eyes,
                                                          double cone_rad,
                                                          const TraceOptions& options) const {
  const double area_m2 = std::numbers::pi * radius_m * radius_m, least_cosine = std::cos(cone_rad);
  const double cone_sr = 2.0 * std::numbers::pi * (1.0 - least_cosine);
  std::vector<TracedIntensity> intensities(toward_eyes.size());
  TraceOptions sums = options;
  sums.orders = static_cast<int>(toward_eyes.size());
  for (std::size_t sun = 0; sun < light_.suns.size(); ++sun) {
    sums.seed = options.seed + sun;
    // Each direction takes the place of an order of scattering; what no cone takes is left out.
    const Traced counted =
        mean_over_paths(sums, 1.0, [&](PathRandom& random, std::vector<glm::dvec3>& by_eye) {
          const glm::dvec3& toward_sun = light_.suns[sun].direction;
          const double distance_m = radius_m * std::sqrt(random.next()),
                       angle = 2.0 * std::numbers::pi * random.next();
          Ray ray{middle_m + distance_m * turned(toward_sun, 0.0, angle) + 2.0 * radius_m * toward_sun,
                  -toward_sun};
          glm::dvec3 weight(1.0);
          for (bool is_scattered = false;; is_scattered = true) {
            const double distance = medium_.next_collision(ray, random);
            if (!std::isfinite(distance)) {
              for (std::size_t eye = 0; is_scattered && eye < toward_eyes.size(); ++eye)
                if (glm::dot(ray.direction, toward_eyes[eye]) >= least_cosine) by_eye[eye + 1] += weight;
              return;
            }
            ray.origin_m += distance * ray.direction;
            weight *= albedo_;
            if (!survives(weight, random)) return;
            const double cosine = phase_.sample([&] { return random.next(); });
            ray.direction = turned(ray.direction, cosine, 2.0 * std::numbers::pi * random.next());
          }
        });
    for (std::size_t eye = 0; eye < toward_eyes.size(); ++eye) {
      const glm::dvec3& share = counted.by_order[eye + 1];
      intensities[eye].kcd += light_.suns[sun].illuminance_klx * share * area_m2 / cone_sr;
      const double most = std::max({share.x, share.y, share.z, 0.5 / options.samples});
      intensities[eye].relative_error =
          std::max(intensities[eye].relative_error, std::sqrt((1.0 - most) / (most * options.samples)));
    }
  }
  return intensities;
}

TracedPicture ReferenceTracer::picture(const Camera& camera, const TraceOptions& options) const {
  require_valid(camera);
  require_valid(options);
  const int width = camera.width_px, height = camera.height_px;
  TracedPicture picture;
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
