#include "host/clouds/light/light_of_others.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include "host/base/tangent_plane.h"
#include "host/clouds/light/phase_function.h"
#include "host/clouds/shape/metaball.h"

namespace offing::clouds {
namespace {

constexpr int golden_count = 64;
// Clouds farther away than ten times their longest half axis cover less than 0.3 % of the view. Of the rest
// the 32 that look largest count: 200 clouds take some 10 ms.
constexpr double farthest_sizes = 10.0;
constexpr std::size_t most_near = 32;

/// Even over the sphere, by golden angles; half of them point up.
std::array<glm::dvec3, golden_count> golden_directions() {
  std::array<glm::dvec3, golden_count> all;
  for (int i = 0; i < golden_count; ++i) {
    const double y = 1.0 - (2.0 * i + 1.0) / golden_count, across = std::sqrt(1.0 - y * y);
    const double angle = 2.0 * std::numbers::pi * i / std::numbers::phi;
    all[static_cast<std::size_t>(i)] = {across * std::cos(angle), y, across * std::sin(angle)};
  }
  return all;
}

/// Area of the ellipsoid's shadow along a direction, m2.
double shadow_m2(const glm::dvec3& half_axes_m, const glm::dvec3& direction) {
  const glm::dvec3& a = half_axes_m;
  return std::numbers::pi * glm::length(glm::dvec3(a.y * a.z, a.x * a.z, a.x * a.y) * direction);
}

/// Area of the ellipsoid's surface, m2, within 1.1 % (Thomsen 2004).
double surface_m2(const glm::dvec3& half_axes_m) {
  constexpr double power = 1.6075;
  const glm::dvec3 a = glm::pow(half_axes_m, glm::dvec3(power));
  return 4.0 * std::numbers::pi * std::pow((a.x * a.y + a.x * a.z + a.y * a.z) / 3.0, 1.0 / power);
}

/// Albedo of a deep cloud for light from all sides (van de Hulst 1980, "Multiple Light Scattering", 12.4).
glm::dvec3 deep_albedo(const glm::dvec3& albedo, double mean_cosine) {
  const glm::dvec3 s = glm::sqrt((1.0 - albedo) / (1.0 - mean_cosine * albedo));
  return (1.0 - s) * (1.0 - 0.139 * s) / (1.0 + 1.17 * s);
}

/// What others see of a cloud.
class SeenCloud {
 public:
  SeenCloud(const CloudIllumination& light, const CloudExtent& extent, const CloudLook& look)
      : light_(&light), middle_m_(extent.middle_m), half_axes_m_(extent.half_axes_m) {
    const double mean_cosine = PhaseFunction(look).mean_cosine();
    transport_m2_ = (1.0 - mean_cosine) * extent.optical_mass_m2;
    albedo_ = deep_albedo(look.albedo, mean_cosine);
    surface_m2_ = surface_m2(half_axes_m_);
    // Over all directions the mean shadow is a quarter of the surface (Cauchy 1841).
    const double depth = 4.0 * transport_m2_ / surface_m2_;
    mean_cover_ = 1.0 - std::exp(-depth);
    reflected_share_ = 0.75 * depth / (1.0 + 0.75 * depth);
  }

  const glm::dvec3& middle_m() const { return middle_m_; }
  double size_m() const { return std::max({half_axes_m_.x, half_axes_m_.y, half_axes_m_.z}); }
  /// Of points on its surface that are even over its shadow along a direction, one on the side that faces it.
  glm::dvec3 point_m(const glm::dvec3& direction, int number) const {
    // In axes in which it is a unit sphere; numbers of R2 (Roberts 2018).
    const glm::dvec3 toward = glm::normalize(direction / half_axes_m_);
    const TangentFrame frame(toward);
    const double square = glm::fract(0.5 + 0.7548776662 * number),
                 angle = 2.0 * std::numbers::pi * glm::fract(0.5 + 0.5698402910 * number);
    const glm::dvec3 across = std::cos(angle) * frame.u + std::sin(angle) * frame.w;
    return middle_m_ + half_axes_m_ * (std::sqrt(square) * across + std::sqrt(1.0 - square) * toward);
  }

  /// The share that it covers of what is behind, in the mean over its shadow.
  double cover(const glm::dvec3& direction) const {
    return 1.0 - std::exp(-transport_m2_ / shadow_m2(half_axes_m_, direction));
  }

  /// How far along a line it begins, 0 within it; nothing where the line misses it.
  std::optional<double> distance_m(const glm::dvec3& from_m, const glm::dvec3& direction) const {
    const glm::dvec3 start = (from_m - middle_m_) / half_axes_m_, way = direction / half_axes_m_;
    const double a = glm::dot(way, way), b = glm::dot(start, way), c = glm::dot(start, start) - 1.0;
    if (c < 0.0) return 0.0;
    if (b > 0.0 || b * b < a * c) return std::nullopt;
    return (-b - std::sqrt(b * b - a * c)) / a;
  }

  /// kcd/m2 at a point of it, where other clouds let this share of each sun through. Of a deep cloud, what
  /// faces light throws most of it back there; what goes through comes out evenly all around.
  glm::dvec3 light_kcdpm2(const glm::dvec3& at_m, std::span<const double> suns_through) const {
    const glm::dvec3 from_middle = (at_m - middle_m_) / (half_axes_m_ * half_axes_m_);
    const glm::dvec3 outward = from_middle / std::max(glm::length(from_middle), 1e-300);
    glm::dvec3 sum(0.0);
    for (std::size_t sun = 0; sun < light_->suns.size(); ++sun) {
      const CloudLight& from = light_->suns[sun];
      const double diffuse =
          cover(from.direction) * shadow_m2(half_axes_m_, from.direction) / (surface_m2_ * mean_cover_);
      const double facing = std::max(0.0, glm::dot(outward, from.direction));
      sum += suns_through[sun] * from.illuminance_klx / std::numbers::pi *
             glm::mix(diffuse, facing, reflected_share_);
    }
    const double up = 0.5 + 0.5 * reflected_share_ * outward.y;
    return albedo_ * (sum + glm::mix(light_->ground_kcdpm2, light_->sky_kcdpm2, up));
  }

 private:
  const CloudIllumination* light_;
  glm::dvec3 middle_m_, half_axes_m_, albedo_{1.0};
  double transport_m2_ = 0.0;  // its mass in the medium in which light turns back
  double surface_m2_ = 0.0, mean_cover_ = 0.0;
  double reflected_share_ = 0.0;  // of light, by the side that it falls on: two streams
};

/// With how far away it is.
using NearCloud = std::pair<double, const SeenCloud*>;

/// What is seen along a line before what is behind it all.
struct Sight {
  glm::dvec3 light_kcdpm2{0.0};
  double through = 1.0;
};

/// The share of a sun's light that reaches a place of a cloud past the others.
double sun_through(std::span<const NearCloud> clouds, const SeenCloud& own, const SeenCloud* of,
                   const glm::dvec3& from_m, const glm::dvec3& way) {
  double through = of != &own && own.distance_m(from_m, way) ? 1.0 - own.cover(way) : 1.0;
  for (const auto& [sizes, cloud] : clouds)
    if (cloud != of && cloud->distance_m(from_m, way)) through *= 1.0 - cloud->cover(way);
  return through;
}

/// What a place of a cloud sees of others that way. Within another one it is as bright there as it is itself.
Sight sight_of(std::span<const NearCloud> clouds, const SeenCloud& own, const CloudIllumination& light,
               const glm::dvec3& from_m, const glm::dvec3& way) {
  std::vector<NearCloud> met;
  for (const auto& [sizes, cloud] : clouds)
    if (const auto distance_m = cloud->distance_m(from_m, way)) met.emplace_back(*distance_m, cloud);
  std::sort(met.begin(), met.end());
  Sight sight;
  std::vector<double> suns_through(light.suns.size());
  for (const auto& [distance_m, cloud] : met) {
    const glm::dvec3 at_m = from_m + distance_m * way;
    const SeenCloud& shown = distance_m == 0.0 ? own : *cloud;
    for (std::size_t sun = 0; sun < suns_through.size(); ++sun)
      suns_through[sun] = sun_through(clouds, own, &shown, at_m, light.suns[sun].direction);
    const double cover = cloud->cover(way);
    sight.light_kcdpm2 += sight.through * cover * shown.light_kcdpm2(at_m, suns_through);
    sight.through *= 1.0 - cover;
  }
  return sight;
}

}  // namespace

CloudExtent extent_of(std::span<const CloudParticle> particles) {
  CloudExtent extent;
  glm::dvec3 sum(0.0), squares(0.0);
  for (const CloudParticle& particle : particles) {
    const glm::dvec3 place(particle.x, particle.y, particle.z);
    const double mass = particle.optical_mass, radius = particle.radius;
    if (!std::isfinite(place.x + place.y + place.z + mass + radius)) continue;
    extent.optical_mass_m2 += mass;
    sum += mass * place;
    squares += mass * (place * place + ball_variance / 3.0 * radius * radius);
  }
  if (!(extent.optical_mass_m2 > 0.0)) return {};
  extent.middle_m = sum / extent.optical_mass_m2;
  // An ellipsoid's variance along an axis is a fifth of the square of its half.
  extent.half_axes_m = glm::sqrt(
      5.0 * glm::max(squares / extent.optical_mass_m2 - extent.middle_m * extent.middle_m, glm::dvec3(0.0)));
  return extent;
}

std::vector<CloudIllumination> with_light_of_others(std::span<const CloudIllumination> lights,
                                                    std::span<const CloudExtent> extents,
                                                    std::span<const CloudLook> looks) {
  std::vector<CloudIllumination> all(lights.begin(), lights.end());
  const auto has_any = [](const CloudExtent& extent) {
    return std::min({extent.half_axes_m.x, extent.half_axes_m.y, extent.half_axes_m.z}) > 0.0;
  };
  std::vector<SeenCloud> clouds;  // those that are
  std::vector<std::size_t> cloud_indices;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!has_any(extents[i])) continue;
    clouds.emplace_back(lights[i], extents[i], looks[i]);
    cloud_indices.push_back(i);
  }
  static const std::array<glm::dvec3, golden_count> ways = golden_directions();
  for (std::size_t i = 0; i < clouds.size(); ++i) {
    std::vector<NearCloud> near;  // by distance, in their sizes
    for (const SeenCloud& other : clouds) {
      const double sizes = glm::distance(other.middle_m(), clouds[i].middle_m()) / other.size_m();
      if (&other != &clouds[i] && sizes < farthest_sizes) near.emplace_back(sizes, &other);
    }
    std::sort(near.begin(), near.end());
    near.resize(std::min(near.size(), most_near));
    if (near.empty()) continue;
    CloudIllumination& light = all[cloud_indices[i]];
    for (int number = 0; number < golden_count; ++number) {
      const glm::dvec3& way = ways[static_cast<std::size_t>(number)];
      const Sight sight =
          sight_of(near, clouds[i], lights[cloud_indices[i]], clouds[i].point_m(way, number), way);
      const bool is_up = way.y > 0.0;
      (is_up ? light.clouds_above_kcdpm2 : light.clouds_below_kcdpm2) +=
          (sight.light_kcdpm2 - (1.0 - sight.through) * (is_up ? light.sky_kcdpm2 : light.ground_kcdpm2)) /
          (0.5 * golden_count);
    }
  }
  return all;
}

}  // namespace offing::clouds
