#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "host/base/cloud_volume.h"
#include "host/clouds/reference/path_random.h"

namespace offing::clouds {

/// A half-line in the frame of the medium, m.
struct Ray {
  glm::dvec3 origin_m{0.0};
  glm::dvec3 direction{0.0, 0.0, -1.0};  ///< unit
};

/// What extinguishes light along rays, as a tracer asks for it. Rays may start anywhere.
class ScatteringMedium {
 public:
  virtual ~ScatteringMedium() = default;

  /// Distance in m to the next collision along the ray, +inf if the ray leaves without any: drawn with the
  /// density that the extinction gives.
  virtual double next_collision(const Ray& ray, PathRandom& random) const = 0;
  /// An estimate, without bias, of the share of light that comes from infinity along the ray.
  virtual double transmittance(const Ray& ray, PathRandom& random) const = 0;
  /// Single-scattering albedo at a place with extinction: `of_look` unless the medium tells its own.
  virtual glm::dvec3 albedo(const glm::dvec3& /*place_m*/, const glm::dvec3& of_look) const {
    return of_look;
  }
};

/// A layer without end between two heights, of the same extinction everywhere.
class SlabMedium : public ScatteringMedium {
 public:
  SlabMedium(double bottom_m, double top_m, double extinction_per_m)
      : bottom_m_(bottom_m), top_m_(top_m), extinction_per_m_(extinction_per_m) {}

  double next_collision(const Ray& ray, PathRandom& random) const override;
  double transmittance(const Ray& ray, PathRandom& random) const override;

 private:
  double bottom_m_, top_m_, extinction_per_m_;
};

/// The trilinear density of a volume. Delta tracking (Woodcock et al. 1965) against the greatest density of
/// each brick; transmittance by ratio tracking (Novak, Selle & Jarosz 2014, "Residual ratio tracking"). Of a
/// volume that tells albedos these are the medium's.
class VolumeMedium : public ScatteringMedium {
 public:
  /// Throws Error(bad_input) if the volume is empty, or a density is negative or not finite.
  explicit VolumeMedium(const CloudVolume& volume);

  double next_collision(const Ray& ray, PathRandom& random) const override;
  double transmittance(const Ray& ray, PathRandom& random) const override;
  glm::dvec3 albedo(const glm::dvec3& place_m, const glm::dvec3& of_look) const override;

  /// 1/m.
  double extinction(const glm::dvec3& place_m) const;
  double cell_m() const { return cell_m_; }
  /// Of a sphere around all bricks with any density.
  const glm::dvec3& middle_m() const { return middle_m_; }
  double radius_m() const { return radius_m_; }
  /// Of all its extinction, summed over its volume.
  double optical_mass_m2() const { return optical_mass_m2_; }
  /// A place with a density in proportion to the extinction.
  glm::dvec3 random_place(PathRandom& random) const;

 private:
  // The cells of a brick and one more on each side.
  static constexpr int apron_cells = CloudVolume::brick_cells + 2;
  struct Brick {
    double most_per_m = 0.0;
    glm::dvec3 corner_m{0.0};
    std::array<float, std::size_t{apron_cells} * apron_cells * apron_cells> extinction_per_m{};
  };

  double extinction(const Brick& brick, const glm::dvec3& cells_in_brick) const;
  /// Calls visit(brick, index of the brick, first and last distance) for bricks that the ray passes, until it
  /// returns false.
  template <typename Visit>
  void walk(const Ray& ray, const Visit& visit) const;
  /// Calls collide(distance, share of the brick's greatest extinction there) at places drawn with the
  /// greatest extinction, until it returns false.
  template <typename Collide>
  void track(const Ray& ray, PathRandom& random, const Collide& collide) const;

  glm::dvec3 origin_m_;
  double cell_m_;
  std::array<int, 3> size_;
  std::vector<std::int32_t> brick_of_;
  std::vector<Brick> bricks_;
  glm::dvec3 middle_m_{0.0};
  double radius_m_ = 0.0, optical_mass_m2_ = 0.0;
  std::vector<double> most_sums_;      // of most_per_m, up to and with each brick
  std::optional<CloudVolume> albedo_;  // of a volume that tells it
};

}  // namespace offing::clouds
