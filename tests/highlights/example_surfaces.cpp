#include "tests/highlights/example_surfaces.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace offing::test {
namespace {

using std::numbers::pi;

/// An implicit surface: gradient and second derivatives of its function, which grows outward.
struct Derivatives {
  glm::dvec3 gradient;
  glm::dmat3 second;
};
using Implicit = std::function<Derivatives(const glm::dvec3&)>;

/// Normals and curvatures from k(d) = d . second d / |gradient| for directions d across the gradient.
void set_shape(ExampleSurface& surface, const Implicit& implicit) {
  VertexCurvatures& c = surface.curvatures;
  for (const glm::dvec3& p : surface.mesh.positions_m) {
    const Derivatives at = implicit(p);
    const double length = glm::length(at.gradient);
    const glm::dvec3 n = at.gradient / length;
    const glm::dvec3 right = glm::normalize(
        glm::cross(std::abs(n.x) < 0.6 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0), n));
    const glm::dvec3 up = glm::cross(n, right);
    const double a = glm::dot(right, at.second * right) / length;
    const double b = glm::dot(right, at.second * up) / length;
    const double d = glm::dot(up, at.second * up) / length;
    const double angle = 0.5 * std::atan2(2.0 * b, a - d), deviation = std::hypot(0.5 * (a - d), b);
    surface.mesh.normals.push_back(n);
    c.k_max_per_m.push_back(0.5 * (a + d) + deviation);
    c.k_min_per_m.push_back(0.5 * (a + d) - deviation);
    c.e_max.push_back(std::cos(angle) * right + std::sin(angle) * up);
    c.e_min.push_back(glm::cross(n, c.e_max.back()));
    c.area_m2.push_back(0.0);
    c.confidence.push_back(1.0);
  }
}

TriangleMesh octahedron_sphere(int levels) {
  TriangleMesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      glm::dvec3 p(0.0);
      p[axis] = sign;
      mesh.positions_m.push_back(p);
    }
  }
  for (std::uint32_t x = 0; x < 2; ++x) {
    for (std::uint32_t y = 2; y < 4; ++y) {
      for (std::uint32_t z = 4; z < 6; ++z) {
        TriangleIndices face{x, y, z};
        if ((x + y + z) % 2 == 1) std::swap(face[1], face[2]);
        mesh.faces.push_back(face);
      }
    }
  }
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [place, is_new] = middles.try_emplace(std::minmax(a, b), 0);
      if (is_new) {
        place->second = static_cast<std::uint32_t>(mesh.positions_m.size());
        mesh.positions_m.push_back(glm::normalize(mesh.positions_m[a] + mesh.positions_m[b]));
      }
      return place->second;
    };
    std::vector<TriangleIndices> finer;
    for (const auto& [a, b, c] : mesh.faces) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.faces = std::move(finer);
  }
  return mesh;
}

}  // namespace

ExampleSurface ellipsoid(int levels, glm::dvec3 half_axes_m) {
  ExampleSurface surface{.mesh = octahedron_sphere(levels), .curvatures = {}, .genus = 0};
  for (glm::dvec3& p : surface.mesh.positions_m) p *= half_axes_m;
  const glm::dvec3 weights = 1.0 / (half_axes_m * half_axes_m);
  set_shape(surface, [&](const glm::dvec3& p) {
    glm::dmat3 second(0.0);
    for (int axis = 0; axis < 3; ++axis) second[axis][axis] = weights[axis];
    return Derivatives{weights * p, second};
  });
  return surface;
}

ExampleSurface torus(int around, int across, double large_radius_m, double small_radius_m) {
  ExampleSurface surface{.mesh = {}, .curvatures = {}, .genus = 1};
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double a = 2.0 * pi * i / around, b = 2.0 * pi * j / across;
      const double radius_m = large_radius_m + small_radius_m * std::cos(b);
      surface.mesh.positions_m.emplace_back(radius_m * std::cos(a), radius_m * std::sin(a),
                                            small_radius_m * std::sin(b));
      const auto vertex = [&](int row, int column) {
        return static_cast<std::uint32_t>(row % around * across + column % across);
      };
      surface.mesh.faces.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      surface.mesh.faces.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  }
  // f = ((rho - R)^2 + z^2) / 2 with rho the distance from the axis.
  set_shape(surface, [&](const glm::dvec3& p) {
    const double rho = std::hypot(p.x, p.y);
    const glm::dvec3 out(p.x / rho, p.y / rho, 0.0), along(-out.y, out.x, 0.0);
    const glm::dvec3 axis(0.0, 0.0, 1.0);
    return Derivatives{(rho - large_radius_m) * out + p.z * axis,
                       glm::outerProduct(out, out) + glm::outerProduct(axis, axis) +
                           (rho - large_radius_m) / rho * glm::outerProduct(along, along)};
  });
  return surface;
}

ExampleSurface bumpy_sphere(int levels) {
  constexpr double height = 0.15, rate = 8.0;
  ExampleSurface surface{.mesh = octahedron_sphere(levels), .curvatures = {}, .genus = 0};
  const auto bump = [&](const glm::dvec3& u) {
    return height * std::sin(rate * u.x) * std::sin(rate * u.y) * std::sin(rate * u.z);
  };
  for (glm::dvec3& p : surface.mesh.positions_m) p *= 1.0 + bump(p);
  // f = |p| - 1 - bump(p / |p|), differentiated by central differences.
  const auto f = [&](const glm::dvec3& p) {
    const double length = glm::length(p);
    return length - 1.0 - bump(p / length);
  };
  set_shape(surface, [&](const glm::dvec3& p) {
    constexpr double step = 1e-3;
    Derivatives at{};
    for (int i = 0; i < 3; ++i) {
      glm::dvec3 a(0.0);
      a[i] = step;
      at.gradient[i] = (8.0 * (f(p + a) - f(p - a)) - f(p + 2.0 * a) + f(p - 2.0 * a)) / (12.0 * step);
      for (int j = 0; j < 3; ++j) {
        glm::dvec3 b(0.0);
        b[j] = step;
        at.second[i][j] = (f(p + a + b) - f(p + a - b) - f(p - a + b) + f(p - a - b)) / (4.0 * step * step);
      }
    }
    return at;
  });
  return surface;
}

ExampleSurface moved(const ExampleSurface& surface, const glm::dmat3& rotation, const glm::dvec3& way_m) {
  ExampleSurface result = surface;
  for (glm::dvec3& p : result.mesh.positions_m) p = rotation * p + way_m;
  for (auto* vectors : {&result.mesh.normals, &result.curvatures.e_max, &result.curvatures.e_min}) {
    for (glm::dvec3& v : *vectors) v = rotation * v;
  }
  return result;
}

double RandomVectors::uniform() {
  // SplitMix64 (Steele, Lea & Flood 2014).
  state_ += 0x9e3779b97f4a7c15u;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

glm::dvec3 RandomVectors::direction() {
  const double z = 2.0 * uniform() - 1.0, angle = 2.0 * pi * uniform(), radius = std::sqrt(1.0 - z * z);
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

glm::dmat3 RandomVectors::rotation() {
  const glm::dvec3 x = direction(), other = direction();
  const glm::dvec3 y = glm::normalize(other - glm::dot(other, x) * x);
  return {x, y, glm::cross(x, y)};
}

}  // namespace offing::test
