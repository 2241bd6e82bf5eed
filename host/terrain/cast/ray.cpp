#include "host/terrain/cast/ray.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "host/base/error.h"

namespace offing::terrain {
namespace {

constexpr double direction_tolerance = 1e-4;
[[noreturn]] void refuse(const std::string& what, const std::string& hint) {
  throw Error(ErrorKind::bad_input, what, hint);
}

struct SplitPlace {
  int cell;
  float fraction;
};

SplitPlace split(double place_in_cells) {
  const double cell = std::floor(place_in_cells);
  // A fraction that rounds to 1 would be the next cell's 0, across its border.
  const float largest = std::nextafter(1.0f, 0.0f);
  return {static_cast<int>(cell), std::min(static_cast<float>(place_in_cells - cell), largest)};
}

float rest_of(double value) {
  return static_cast<float>(value - static_cast<float>(value));
}

/// The way to cells 0 ... last on one axis, m: 0 for a ray that begins between them, infinite for one that
/// stays beside them or leaves them behind.
double way_to_cells_m(double place, double last, double cells_per_m) {
  if (place >= 0.0 && place <= last) return 0.0;
  const double way_m = (place < 0.0 ? -place : last - place) / cells_per_m;
  return way_m >= 0.0 ? way_m : std::numeric_limits<double>::infinity();
}

// Rays that are on the device at a time: 23 MB with their hits.
constexpr std::size_t most_rays = std::size_t{1} << 18;

}  // namespace

void require_valid(const Ray& ray, const PostGrid& grid) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::isfinite(ray.origin_m[axis]) && std::isfinite(ray.direction[axis])) continue;
    refuse(fmt::format("ray: expected finite numbers, found origin {:g} and direction {:g} on axis {}",
                       ray.origin_m[axis], ray.direction[axis], "xyz"[axis]),
           "leave the ray out");
  }
  const double length = glm::length(ray.direction);
  if (!(std::abs(length - 1.0) <= direction_tolerance)) {
    refuse(fmt::format("ray: expected a direction of length 1, found {:g}", length),
           "divide the direction by its length");
  }
  if (!(ray.limit_m >= 0.0)) {
    refuse(fmt::format("ray: limit_m: expected 0 or more, found {:g}", ray.limit_m),
           "leave limit_m out for no limit");
  }
  const double beyond = cells_beyond(grid, ray.origin_m.x, ray.origin_m.z);
  if (beyond > farthest_origin_cells) {
    refuse(fmt::format("ray: expected an origin within {:g} cells of the map, found {:g}",
                       farthest_origin_cells, beyond),
           "move the origin toward the map");
  }
}

TerrainRay device_ray(const Ray& ray, const PostGrid& grid) {
  const glm::dvec2 place = cells_of(grid, ray.origin_m.x, ray.origin_m.z);
  const SplitPlace x = split(place.x), z = split(place.y);
  const double along_x = ray.direction.x / grid.spacing_x_m, along_z = ray.direction.z / grid.spacing_z_m;
  return {.cell_x = x.cell,
          .cell_z = z.cell,
          .fraction_x = x.fraction,
          .fraction_z = z.fraction,
          .height_m = static_cast<float>(ray.origin_m.y),
          .height_rest_m = rest_of(ray.origin_m.y),
          .along_x = static_cast<float>(along_x),
          .along_z = static_cast<float>(along_z),
          .along_x_rest = rest_of(along_x),
          .along_z_rest = rest_of(along_z),
          .rise = static_cast<float>(ray.direction.y),
          .limit_m = static_cast<float>(ray.limit_m)};
}

RayToBox moved_to_box(const Ray& ray, const PostGrid& grid, double highest_m, double bend_perm) {
  const glm::dvec3 way = ray.direction;
  const glm::dvec2 place = cells_of(grid, ray.origin_m.x, ray.origin_m.z);
  double entry_m = std::max(way_to_cells_m(place.x, grid.columns - 1, way.x / grid.spacing_x_m),
                            way_to_cells_m(place.y, grid.rows - 1, way.z / grid.spacing_z_m));
  // How far the ground has fallen away after s metres of the ray: bend_perm_of_ray s^2.
  const double bend_perm_of_ray = bend_perm * (way.x * way.x + way.z * way.z);
  const double above_m = ray.origin_m.y - highest_m;
  if (above_m > 0.0 && way.y < 0.0) {
    const double discriminant = way.y * way.y - 4.0 * bend_perm_of_ray * above_m;
    entry_m = std::max(entry_m, 2.0 * above_m / (std::sqrt(std::max(discriminant, 0.0)) - way.y));
  }
  // Whole steps of a power of two, so that round numbers stay round.
  const double cell_m = std::min(grid.spacing_x_m, grid.spacing_z_m),
               step_m = std::exp2(std::floor(std::log2(cell_m)));
  const double moved_m = std::min(std::floor((entry_m - cell_m) / step_m) * step_m, ray.limit_m);
  // Rays that never come into the box miss from anywhere.
  if (!(moved_m > 0.0) || std::isinf(moved_m)) return {ray};
  Ray moved = ray;
  moved.origin_m += moved_m * way + glm::dvec3(0.0, bend_perm_of_ray * moved_m * moved_m, 0.0);
  moved.direction.y += 2.0 * bend_perm_of_ray * moved_m;
  moved.limit_m -= moved_m;
  return {moved, moved_m};
}

double RayHit::rounded_m(double length_m) const {
  if (!(resolution_m > 0.0)) return length_m;
  const double steps_a_metre = std::pow(10.0, std::floor(-std::log10(resolution_m)));
  return std::round(length_m * steps_a_metre) / steps_a_metre + 0.0;  // no -0
}

glm::dvec3 RayHit::rounded_m(const glm::dvec3& point_m) const {
  return {rounded_m(point_m.x), rounded_m(point_m.y), rounded_m(point_m.z)};
}

RayHit ray_hit(const TerrainHit& hit, double moved_m) {
  const float next_m = std::nextafter(hit.distance_m, std::numeric_limits<float>::infinity());
  return {.distance_m = moved_m + static_cast<double>(hit.distance_m),
          .resolution_m = hit.kind == TERRAIN_MISS ? 0.0 : static_cast<double>(next_m - hit.distance_m),
          .kind = hit.kind,
          .cell_x = hit.cell_x,
          .cell_z = hit.cell_z,
          .u = hit.u,
          .v = hit.v,
          .normal_x = hit.normal_x,
          .normal_y = hit.normal_y,
          .normal_z = hit.normal_z,
          .steps = hit.steps};
}

std::vector<RayHit> HostRays::cast(const ocl::Device& device, const PostGrid& grid,
                                   std::span<const RayToBox> rays, const Cast& cast) {
  const std::size_t most = std::min(rays.size(), most_rays);
  if (rays_.size() < most) {
    rays_ = ocl::Buffer<TerrainRay>(device, most, "rays");
    hits_ = ocl::Buffer<TerrainHit>(device, most, "hits");
  }
  std::vector<RayHit> found;
  found.reserve(rays.size());
  std::vector<TerrainRay> packed(most);
  std::vector<TerrainHit> hits(most);
  for (std::size_t first = 0; first < rays.size(); first += most_rays) {
    const std::span<const RayToBox> some = rays.subspan(first, std::min(most_rays, rays.size() - first));
    std::transform(some.begin(), some.end(), packed.begin(),
                   [&](const RayToBox& to_box) { return device_ray(to_box.ray, grid); });
    rays_.write(std::span(packed).first(some.size()));
    cast(rays_, some.size(), hits_);
    hits_.read(std::span(hits).first(some.size()));
    for (std::size_t i = 0; i < some.size(); ++i) found.push_back(ray_hit(hits[i], some[i].moved_m));
  }
  return found;
}

}  // namespace offing::terrain
