#include "present/water_pass.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

#include <glm/common.hpp>

#include "host/ocean/projected_grid.h"
#include "host/ocean/trochoid_instant.h"
#include "present/foam_texture.h"

namespace offing::present {
namespace {

constexpr int displacement_unit = 0, gradient_unit = 1, foam_unit = 2, environment_unit = 3, pattern_unit = 4;
constexpr double near_m = 0.05;
// Waves shorter than 2 m break without drawing air under: they make no foam.
constexpr double ripples_radpm = std::numbers::pi;
// Of the light that enters deep, clear water this share comes back out, at red, green and blue; half of the
// irradiance reflectance of water with 0.1 mg/m3 of chlorophyll (Morel & Maritorena 2001), of which half is
// turned back at the surface.
constexpr std::array<double, 3> water_reflectance{0.002, 0.011, 0.024};

ShaderProgram water_program() {
  return ShaderProgram({.vertex = {shader_file("water.glsl"), shader_file("water.vert")},
                        .fragment = {shader_file("environment.glsl"), shader_file("water.glsl"),
                                     shader_file("water_light.glsl"), shader_file("water_debug.glsl"),
                                     shader_file("water.frag")}});
}

// Two triangles a cell, near rows first, so that what they hide is not shaded.
std::vector<std::uint32_t> triangles(GridCells cells) {
  std::vector<std::uint32_t> indices;
  const auto stride = static_cast<std::uint32_t>(cells.columns) + 1;
  for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(cells.rows); ++row) {
    for (std::uint32_t column = 0; column + 1 < stride; ++column) {
      const std::uint32_t corner = row * stride + column;
      indices.insert(indices.end(),
                     {corner, corner + 1, corner + stride, corner + stride, corner + 1, corner + stride + 1});
    }
  }
  return indices;
}

glm::vec3 to_vec3(const ocean::SlopeCovariance& slopes) {
  return {slopes.xx, slopes.xz, slopes.zz};
}

glm::vec3 to_vec3(const std::array<double, 3>& values) {
  return {values[0], values[1], values[2]};
}

// Extinction of the air at sea level, at red, green and blue.
glm::vec3 haze_perm(const sky::Atmosphere& air) {
  const double aerosol_perm = air.aerosol_optical_depth / air.aerosol_scale_height_m;
  const auto at = [&](double rayleigh_depth) {
    return static_cast<float>(rayleigh_depth / air.rayleigh_scale_height_m + aerosol_perm);
  };
  const sky::Spectrum& depth = air.rayleigh_optical_depth;
  return {at(depth[0]), at(0.5 * (depth[1] + depth[2])), at(depth[3])};
}

}  // namespace

std::string_view to_string(DebugView view) {
  constexpr std::array<std::string_view, all_debug_views.size()> names{
      "none",      "height",    "slope",     "jacobian",  "foam",
      "footprint", "cascade 0", "cascade 1", "cascade 2", "cascade 3"};
  return names[static_cast<std::size_t>(view)];
}

WaterPass::WaterPass(const GlCapabilities& capabilities, WaterDetail detail)
    : capabilities_(capabilities),
      detail_(detail),
      program_(water_program()),
      vertices_(GlVertexArray::make()),
      indices_(GlBuffer::make()),
      foam_pattern_(foam_texture()) {
  const std::vector<std::uint32_t> indices = triangles(detail.cells);
  glBindVertexArray(vertices_.name());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)),
               indices.data(), GL_STATIC_DRAW);
  glBindVertexArray(0);
}

void WaterPass::prepare(world::World& world, TransferLadder& transfer) {
  ocean::Ocean& ocean = world.ocean();
  const int size = ocean.parameters().size;
  const int layers = static_cast<int>(ocean.parameters().cascades.size());
  if (displacement_.size() != size || displacement_.layers() != layers) {
    displacement_ = MapTexture(size, layers, 4);
    gradient_ = MapTexture(size, layers, 4);
    foam_ = MapTexture(size, layers, 1);
  }
  const std::array<Upload, 3> uploads{{{&ocean.displacement_map(), &displacement_},
                                       {&ocean.gradient_map(), &gradient_},
                                       {&ocean.foam_map(), &foam_}}};
  glActiveTexture(GL_TEXTURE0);
  transfer.upload(uploads);
  for (const Upload& upload : uploads) upload.target->make_levels();
}

void WaterPass::set_sea(const world::World& world, const Camera& camera) const {
  const ocean::OceanParameters& sea = world.parameters().ocean;
  const glm::dvec2 eye(camera.eye_m.x, camera.eye_m.z);
  std::vector<glm::vec4> cascades;
  std::vector<glm::vec4> hidden;
  std::vector<float> breaking;
  for (std::size_t i = 0; i < sea.cascades.size(); ++i) {
    const double length_m = sea.cascades[i].patch_length_m;
    // Reduced in double, so that an eye far from the origin loses nothing.
    const glm::dvec2 place = eye / length_m;
    cascades.emplace_back(1.0 / length_m, place.x - std::floor(place.x), place.y - std::floor(place.y),
                          sea.size / length_m);
    breaking.push_back(sea.cascades[i].k_min_radpm < ripples_radpm ? 1.0f : 0.0f);
    for (const ocean::SlopeCovariance& level : world.hidden_slopes().cascades[i]) {
      hidden.emplace_back(to_vec3(level), 0.0f);
    }
  }
  program_.set("cascade_count", static_cast<int>(cascades.size()));
  program_.set("cascades", cascades);
  program_.set("hidden_slopes", hidden);
  program_.set("breaking", breaking);
  const glm::dvec2 foam_place = eye / static_cast<double>(foam_tile_m);
  program_.set("foam_place", glm::vec2(foam_place - glm::floor(foam_place / 100.0) * 100.0));
  program_.set("foam_tile_m", foam_tile_m);
  program_.set("level_count", static_cast<int>(hidden.size() / cascades.size()));
  program_.set("ripples", to_vec3(world.hidden_slopes().ripples));
  program_.set("foam_onset", glm::vec2(sea.foam.onset_jacobian, sea.foam.width));

  const ocean::TrochoidInstant trochoids(world.parameters().trochoids, world.time_s());
  std::vector<glm::vec4> waves;
  std::vector<float> phases;
  for (const ocean::TrochoidInstant::Wave& wave : trochoids.waves()) {
    waves.emplace_back(wave.kx_radpm, wave.kz_radpm, wave.amplitude_m,
                       trochoids.horizontal_scale() * wave.amplitude_m);
    const double phase = wave.kx_radpm * eye.x + wave.kz_radpm * eye.y + wave.phase_rad;
    phases.push_back(static_cast<float>(std::remainder(phase, 2.0 * std::numbers::pi)));
  }
  program_.set("wave_count", static_cast<int>(waves.size()));
  program_.set("waves", waves);
  program_.set("wave_phases", phases);
}

void WaterPass::set_light(const world::World& world) const {
  const sky::Illuminance& light = world.illuminance();
  const auto& sun = world.sky().params();
  glm::vec3 water(0.0f);
  for (int channel = 0; channel < 3; ++channel) {
    const auto c = static_cast<std::size_t>(channel);
    const double level_klx = light.sky_klx[c] + light.sun_klx[c] * std::max(0.0f, sun.sun_direction_y);
    water[channel] = static_cast<float>(water_reflectance[c] * level_klx / std::numbers::pi);
  }
  program_.set("sun_direction", glm::vec3(sun.sun_direction_x, sun.sun_direction_y, sun.sun_direction_z));
  program_.set("sun_radius_rad", sun.sun_angular_radius_rad);
  program_.set("sun_klx", to_vec3(light.sun_klx));
  program_.set("sky_klx", to_vec3(light.sky_klx));
  program_.set("water_kcdpm2", water);
  program_.set("haze_perm", haze_perm(world.parameters().atmosphere));
  program_.set("tap_count", detail_.taps);
}

void WaterPass::draw(const world::World& world, const FrameRequest& request, GLuint environment) const {
  const Camera& camera = request.camera;
  const std::optional<ocean::ProjectedGrid> grid = ocean::ProjectedGrid::for_camera(camera, world.reach());
  if (!grid) return;
  program_.use();
  std::vector<glm::vec3> corners;
  for (const ocean::ProjectedGrid::Corner& corner : grid->corners()) {
    corners.emplace_back(corner.label_m.x, corner.label_m.y, corner.w);
  }
  program_.set("corners", corners);
  program_.set("cells", glm::ivec2(detail_.cells.columns, detail_.cells.rows));
  program_.set("eye_height_m", static_cast<float>(camera.eye_m.y));
  glm::dmat4 clip_from_eye = projection(camera, near_m) * view_rotation(camera);
  if (!capabilities_.has_clip_control) {
    // OpenGL then maps depth from -1 ... 1: z' = 2 z - w.
    for (int column = 0; column < 4; ++column) {
      clip_from_eye[column][2] = 2.0 * clip_from_eye[column][2] - clip_from_eye[column][3];
    }
  }
  program_.set("clip_from_eye", glm::mat4(clip_from_eye));
  set_sea(world, camera);
  set_light(world);
  displacement_.bind(displacement_unit);
  gradient_.bind(gradient_unit);
  foam_.bind(foam_unit);
  glActiveTexture(GL_TEXTURE0 + environment_unit);
  glBindTexture(GL_TEXTURE_2D, environment);
  glActiveTexture(GL_TEXTURE0 + pattern_unit);
  glBindTexture(GL_TEXTURE_2D, foam_pattern_.name());
  program_.set("foam_pattern", pattern_unit);
  program_.set("displacement_map", displacement_unit);
  program_.set("gradient_map", gradient_unit);
  program_.set("foam_map", foam_unit);
  program_.set("environment", environment_unit);

  program_.set("debug_view", static_cast<int>(request.debug));
  program_.set("debug_white", static_cast<float>(1.0 / request.exposure));
  program_.set("debug_height_m", static_cast<float>(0.5 * world.reach().vertical_m));

  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  glPolygonMode(GL_FRONT_AND_BACK, request.fill == Fill::wireframe ? GL_LINE : GL_FILL);
  glBindVertexArray(vertices_.name());
  glDrawElements(GL_TRIANGLES, 6 * detail_.cells.columns * detail_.cells.rows, GL_UNSIGNED_INT, nullptr);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glDisable(GL_DEPTH_TEST);
}

}  // namespace offing::present
