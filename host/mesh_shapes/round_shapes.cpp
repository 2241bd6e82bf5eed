// Shapes around a middle: a ray toward each corner of an icosphere meets them once.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "host/mesh_shapes/shape_parts.h"

namespace offing::mesh_shapes {
namespace {

/// A Gaussian with a width of its own along each axis, in head radii.
struct Lump {
  glm::dvec3 middle, widths;
  double height;
};

// Looking toward +z, +y up. A single lump of height e would be a sphere of its widths at level 1.
constexpr std::array head_lumps{
    Lump{{0.0, 0.10, -0.10}, {0.92, 1.02, 1.05}, 2.2},   // skull
    Lump{{0.0, -0.45, 0.25}, {0.66, 0.80, 0.70}, 1.0},   // face
    Lump{{0.0, -0.22, 0.92}, {0.16, 0.26, 0.26}, 0.45},  // nose
    Lump{{0.0, 0.18, 0.80}, {0.50, 0.14, 0.25}, 0.22},   // brow
    Lump{{0.42, -0.30, 0.62}, {0.28, 0.28, 0.28}, 0.25},
    Lump{{-0.42, -0.30, 0.62}, {0.28, 0.28, 0.28}, 0.25},  // cheeks
    Lump{{0.0, -0.98, 0.62}, {0.30, 0.24, 0.28}, 0.50},    // chin
    Lump{{0.95, -0.05, -0.05}, {0.16, 0.30, 0.22}, 0.55},
    Lump{{-0.95, -0.05, -0.05}, {0.16, 0.30, 0.22}, 0.55},  // ears
    Lump{{0.0, -1.10, -0.15}, {0.45, 0.80, 0.45}, 0.9},     // neck
};

struct LevelSet {
  double value = 0.0;
  glm::dvec3 gradient{};
  SymmetricTensor hessian{};
};

/// 1 - the sum of the lumps, which grows outward; second derivatives are for radii of 1.
LevelSet head_at(const glm::dvec3& position) {
  LevelSet sum{.value = 1.0, .gradient = glm::dvec3(0.0), .hessian = {}};
  for (const Lump& lump : head_lumps) {
    const glm::dvec3 narrowness = 1.0 / (lump.widths * lump.widths);
    const glm::dvec3 off = position - lump.middle, weighted = narrowness * off;
    const double height = lump.height * std::exp(-glm::dot(off, weighted));
    sum.value -= height;
    sum.gradient += 2.0 * height * weighted;
    sum.hessian += outer_square(-4.0 * height, weighted);
    sum.hessian += {.xx = 2.0 * height * narrowness.x,
                    .yy = 2.0 * height * narrowness.y,
                    .zz = 2.0 * height * narrowness.z};
  }
  return sum;
}

SymmetricTensor symmetric_product(double factor, const glm::dvec3& a, const glm::dvec3& b) {
  SymmetricTensor sum = outer_square(factor, a + b);
  sum += outer_square(-factor, a);
  sum += outer_square(-factor, b);
  return sum;
}

/// sin(8 x) sin(8 y) sin(8 z) of a direction, with the derivatives over its three numbers.
LevelSet bump_at(const glm::dvec3& direction) {
  constexpr double rate = 8.0;  // some 60 bumps and as many hollows
  const glm::dvec3 s = glm::sin(rate * direction), c = rate * glm::cos(rate * direction);
  const double value = s.x * s.y * s.z, bend = -rate * rate * value;
  return {.value = value,
          .gradient = {c.x * s.y * s.z, s.x * c.y * s.z, s.x * s.y * c.z},
          .hessian = {.xx = bend,
                      .xy = c.x * c.y * s.z,
                      .xz = c.x * s.y * c.z,
                      .yy = bend,
                      .yz = s.x * c.y * c.z,
                      .zz = bend}};
}

/// |p| - 1 - height bump(p / |p|) where it is 0. Of a function F of the direction u alone with gradient g and
/// second derivatives G there, those over p are P g / |p| and
/// (P G P - (u.g) P - u (P g)^T - (P g) u^T) / |p|^2, P being the projection across u.
LevelSet bumpy_at(const glm::dvec3& direction, double height) {
  const LevelSet bump = bump_at(direction);
  const double radius = 1.0 + height * bump.value;
  const double along = glm::dot(direction, bump.gradient);
  const glm::dvec3 across = bump.gradient - along * direction;
  const glm::dvec3 pulled = bump.hessian * direction;  // G u
  SymmetricTensor projection{.xx = 1.0, .yy = 1.0, .zz = 1.0};
  projection += outer_square(-1.0, direction);
  SymmetricTensor second = bump.hessian;  // P G P = G - u (G u)^T - (G u) u^T + (u.G u) u u^T
  second += symmetric_product(-1.0, direction, pulled);
  second += outer_square(glm::dot(direction, pulled), direction);
  second += -along * projection;
  second += symmetric_product(-1.0, direction, across);
  const double share = -height / (radius * radius);
  LevelSet surface{
      .value = 0.0, .gradient = direction - height / radius * across, .hessian = 1.0 / radius * projection};
  surface.hessian += share * second;
  return surface;
}

/// How far from the middle a ray leaves the head.
double head_radius(const glm::dvec3& direction) {
  // Beyond 3 radii all lumps together are below 1, in the middle they are above.
  double inside = 0.0, outside = 3.0;
  for (int i = 0; i < 60; ++i) {  // to the last bit
    const double between = 0.5 * (inside + outside);
    (head_at(between * direction).value < 0.0 ? inside : outside) = between;
  }
  return inside;
}

}  // namespace

Shape make_sphere(double radius_m, int level, const Roughness& roughness) {
  return make_ellipsoid(glm::dvec3(radius_m), level, roughness);
}

Shape make_ellipsoid(const glm::dvec3& semi_axes_m, int level, const Roughness& roughness) {
  for (int axis = 0; axis < 3; ++axis) require_shape_size("semi-axis", semi_axes_m[axis]);
  Icosphere sphere = icosphere(level, roughness);
  const glm::dvec3 narrowness = 1.0 / (semi_axes_m * semi_axes_m);
  std::vector<SurfacePoint> points;
  for (const glm::dvec3& direction : sphere.directions) {
    const glm::dvec3 position_m = semi_axes_m * direction;
    points.push_back(level_set_point(position_m, narrowness * position_m,
                                     {.xx = narrowness.x, .yy = narrowness.y, .zz = narrowness.z}));
  }
  const double mean_axis_m = (semi_axes_m.x + semi_axes_m.y + semi_axes_m.z) / 3.0;
  return shape_of(points, std::move(sphere.faces), roughness.normal_noise * sphere.edge * mean_axis_m,
                  roughness.seed);
}

Shape make_bumpy_sphere(double radius_m, double height_m, int level, const Roughness& roughness) {
  require_shape_size("radius", radius_m);
  // Higher bumps would have sides that rays from the middle meet at a grazing angle.
  require_shape_value("height of bumps", height_m, 0.0, 0.3 * radius_m);
  Icosphere sphere = icosphere(level, roughness);
  std::vector<SurfacePoint> points;
  for (const glm::dvec3& direction : sphere.directions) {
    const double height = height_m / radius_m;
    const LevelSet there = bumpy_at(direction, height);
    SurfacePoint point = level_set_point(radius_m * (1.0 + height * bump_at(direction).value) * direction,
                                         there.gradient, there.hessian);
    point.k_max_per_m /= radius_m;
    point.k_min_per_m /= radius_m;
    points.push_back(point);
  }
  return shape_of(points, std::move(sphere.faces), roughness.normal_noise * sphere.edge * radius_m,
                  roughness.seed);
}

Shape make_head(double radius_m, int level, const Roughness& roughness) {
  require_shape_size("radius", radius_m);
  Icosphere sphere = icosphere(level, roughness);
  std::vector<SurfacePoint> points;
  for (const glm::dvec3& direction : sphere.directions) {
    const glm::dvec3 position = head_radius(direction) * direction;
    const LevelSet there = head_at(position);
    SurfacePoint point = level_set_point(position * radius_m, there.gradient, there.hessian);
    point.k_max_per_m /= radius_m;
    point.k_min_per_m /= radius_m;
    points.push_back(point);
  }
  return shape_of(points, std::move(sphere.faces), roughness.normal_noise * sphere.edge * radius_m,
                  roughness.seed);
}

}  // namespace offing::mesh_shapes
