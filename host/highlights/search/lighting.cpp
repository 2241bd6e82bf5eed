#include "host/highlights/search/lighting.h"

#include <cmath>
#include <string_view>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "host/base/error.h"
#include "host/highlights/search/tangent_axes.h"
#include "host/highlights/search/unit_vector.h"

namespace offing::highlights {
namespace {

glm::dvec3 toward(const Source& source, const glm::dvec3& place_m) {
  return unit_or_zero(source.kind == Source::Kind::place ? source.vector - place_m : source.vector);
}

void require_usable(std::string_view name, const Source& source) {
  const glm::dvec3& v = source.vector;
  const bool is_finite = std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
  const bool has_direction = source.kind == Source::Kind::place || glm::length(v) > 0.0;
  if (is_finite && has_direction) return;
  throw Error(
      ErrorKind::bad_input,
      fmt::format("highlights: {}: expected a place or a direction that is not zero, found {:g} {:g} {:g}",
                  name, v.x, v.y, v.z),
      fmt::format("give the {} three finite numbers", name));
}

HighlightSource packed_source(const Source& source, const glm::dvec3& middle_m) {
  const bool is_place = source.kind == Source::Kind::place;
  const glm::vec3 v(is_place ? source.vector - middle_m : glm::normalize(source.vector));
  return {v.x, v.y, v.z, is_place ? 1.0f : 0.0f};
}

}  // namespace

Lighting in_mesh_axes(const Lighting& world, const RigidMotion& mesh) {
  const glm::dmat3 inverse = glm::transpose(mesh.rotation);
  const auto moved = [&](Source source) {
    if (source.kind == Source::Kind::place) source.vector -= mesh.translation_m;
    source.vector = inverse * source.vector;
    return source;
  };
  Lighting result{.eye = moved(world.eye), .lights = {}};
  for (const Source& light : world.lights) result.lights.push_back(moved(light));
  return result;
}

glm::dvec3 half_vector(const Source& eye, const Source& light, const glm::dvec3& place_m) {
  return unit_or_zero(toward(eye, place_m) + toward(light, place_m));
}

HighlightLight packed_light(const Source& eye, const Source& light, const glm::dvec3& middle_m) {
  require_usable("eye", eye);
  require_usable("light", light);
  // Where eye and light are opposite any direction serves: nothing shines there.
  glm::dvec3 axis = half_vector(eye, light, middle_m);
  if (axis == glm::dvec3(0.0)) axis = glm::dvec3(0.0, 1.0, 0.0);
  const TangentAxes axes = tangent_axes(axis);
  const glm::vec3 a(axis), right(axes.right), up(axes.up);
  HighlightLight packed{};
  packed.eye = packed_source(eye, middle_m);
  packed.source = packed_source(light, middle_m);
  packed.axis_x = a.x;
  packed.axis_y = a.y;
  packed.axis_z = a.z;
  packed.right_x = right.x;
  packed.right_y = right.y;
  packed.right_z = right.z;
  packed.up_x = up.x;
  packed.up_y = up.y;
  packed.up_z = up.z;
  packed.is_constant = eye.kind == Source::Kind::direction && light.kind == Source::Kind::direction ? 1 : 0;
  return packed;
}

}  // namespace offing::highlights
