#include "present/passes/meshes/mesh_lights.h"

#include <algorithm>
#include <cstddef>
#include <numbers>

#include "present/passes/uniform_bindings.h"

namespace offing::present {
namespace {

static_assert(world::most_lights + 1 == glsl::most_lights);
// Of what lies under meshes: dark, as water and woods are.
constexpr float albedo_below = 0.1f;
constexpr int shadow_unit = 7;  // beyond those of the programs that meshes are drawn with

// From this share of all light on a light has highlights of full opacity.
constexpr float full_share = 0.01f;
constexpr float least_klx = 1e-9f;  // the dark, but for division by it

float luminance(const glm::vec3& klx) {
  return static_cast<float>(sky::luminance({klx.r, klx.g, klx.b}));
}

glm::vec3 to_vec3(const sky::Rgb& values) {
  return {values[0], values[1], values[2]};
}

}  // namespace

MeshLights::MeshLights() : block_("Lights", lights_binding) {}

void MeshLights::prepare(const world::World& world, const glm::dvec3& eye_m, const CloudShadows& shadows) {
  shadows_ = &shadows;
  const sky::Illuminance& illuminance = world.illuminance();
  const glm::vec3 sun_klx = to_vec3(illuminance.sun_klx);
  klx_.clear();
  for (const world::Light& light : world.parameters().lights) {
    klx_.emplace_back(light.colour * light.illuminance_klx);
  }
  const highlights::Lighting lighting = world.lighting(eye_m);
  const bool has_sun = lighting.lights.size() > klx_.size();
  glsl::LightUniforms uniforms{};
  uniforms.sky_klx = to_vec3(illuminance.sky_klx);
  uniforms.sun = has_sun ? static_cast<int>(klx_.size()) : -1;
  if (has_sun) klx_.push_back(sun_klx);
  for (std::size_t i = 0; i < lighting.lights.size(); ++i) {
    const highlights::Source& light = lighting.lights[i];
    const bool is_place = light.kind == highlights::Source::Kind::place;
    glm::vec4* values = uniforms.lights + static_cast<std::ptrdiff_t>(2 * uniforms.count++);
    values[0] = {is_place ? light.vector - eye_m : light.vector, is_place ? 1.0 : 0.0};
    values[1] = {klx_[i], 0.0f};
  }
  white_klx_ = luminance(uniforms.sky_klx);
  for (const glm::vec3& klx : klx_) white_klx_ += luminance(klx);
  const float rise = std::max(0.0f, world.sky().params().sun_direction_y);
  uniforms.ground_klx = albedo_below * (uniforms.sky_klx + rise * sun_klx);
  block_.fill(uniforms);
}

void MeshLights::bind(const ShaderProgram& program) const {
  block_.bind(program);
  shadows_->bind(program, shadow_unit);
}

glm::vec3 MeshLights::highlight_kcdpm2(int light) const {
  const auto i = static_cast<std::size_t>(light);
  if (i >= klx_.size()) return glm::vec3(0.0f);
  return klx_[i] * (white_klx_ / std::numbers::pi_v<float> / std::max(luminance(klx_[i]), least_klx));
}

double MeshLights::highlight_share(int light) const {
  const auto i = static_cast<std::size_t>(light);
  if (i >= klx_.size()) return 0.0;
  return std::min(1.0,
                  static_cast<double>(luminance(klx_[i]) / std::max(full_share * white_klx_, least_klx)));
}

}  // namespace offing::present
