#include "present/water_surface.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "host/ocean/projected_grid.h"
#include "kernels/shared/trochoids.h"

namespace offing::present {
namespace {

constexpr double near_m = 0.05;
constexpr int output_count = 3;
constexpr GLuint trochoids_binding = 1;
constexpr std::size_t trochoid_values = TROCHOID_WAVES + TROCHOID_WAVES / 4;

ShaderProgram surface_program() {
  return ShaderProgram(
      {.vertex = {shader_file("water.glsl"), shader_file("rings.glsl"), shader_file("water.vert")},
       .fragment = {shader_file("water_surface.frag")}});
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

// From eye-relative coordinates to those of the screen.
glm::dmat4 clip_from_eye(const Camera& camera, bool has_clip_control) {
  glm::dmat4 matrix = projection(camera, near_m) * view_rotation(camera);
  if (!has_clip_control) {
    // OpenGL then maps depth from -1 ... 1: z' = 2 z - w.
    for (int column = 0; column < 4; ++column) {
      matrix[column][2] = 2.0 * matrix[column][2] - matrix[column][3];
    }
  }
  return matrix;
}

}  // namespace

WaterSurface::WaterSurface(const GlCapabilities& capabilities, GridCells cells)
    : capabilities_(capabilities),
      cells_(cells),
      program_(surface_program()),
      vertices_(GlVertexArray::make()),
      indices_(GlBuffer::make()),
      trochoid_block_("Trochoids", trochoids_binding, trochoid_values) {
  const std::vector<std::uint32_t> indices = triangles(cells);
  glBindVertexArray(vertices_.name());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)),
               indices.data(), GL_STATIC_DRAW);
  glBindVertexArray(0);
}

void WaterSurface::set_trochoids(const ocean::TrochoidInstant& trochoids, const Camera& camera) const {
  // As the shader's block has them: the waves, then their phases, four a value.
  std::vector<glm::vec4> waves(trochoid_values);
  std::size_t count = 0;
  for (const ocean::TrochoidInstant::Wave& wave : trochoids.waves()) {
    waves[count] = {wave.kx_radpm, wave.kz_radpm, wave.amplitude_m,
                    trochoids.horizontal_scale() * wave.amplitude_m};
    const double phase = wave.kx_radpm * camera.eye_m.x + wave.kz_radpm * camera.eye_m.z + wave.phase_rad;
    waves[TROCHOID_WAVES + count / 4][static_cast<int>(count % 4)] =
        static_cast<float>(std::remainder(phase, 2.0 * std::numbers::pi));
    ++count;
  }
  program_.set("wave_count", static_cast<int>(count));
  trochoid_block_.fill(std::move(waves));
  trochoid_block_.bind(program_);
}

bool WaterSurface::draw(const world::World& world, const WaterMaps& maps, const Camera& camera, Fill fill) {
  const std::optional<ocean::ProjectedGrid> grid = ocean::ProjectedGrid::for_camera(camera, world.reach());
  if (!grid) return false;
  if (target_.width() != camera.width_px || target_.height() != camera.height_px) {
    target_ = RenderTarget(camera.width_px, camera.height_px, GL_RGBA32F, output_count,
                           RenderTarget::Depth::single_precision);
  }
  target_.bind();
  glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  glClearDepth(0.0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);

  program_.use();
  std::vector<glm::vec3> corners;
  for (const ocean::ProjectedGrid::Corner& corner : grid->corners()) {
    corners.emplace_back(corner.label_m.x, corner.label_m.y, corner.w);
  }
  program_.set("corners", corners);
  program_.set("cells", glm::ivec2(cells_.columns, cells_.rows));
  program_.set("eye_height_m", static_cast<float>(camera.eye_m.y));
  program_.set("clip_from_eye", glm::mat4(clip_from_eye(camera, capabilities_.has_clip_control)));
  maps.bind(program_, world, {camera.eye_m.x, camera.eye_m.z});
  const ocean::TrochoidInstant trochoids(world.parameters().trochoids, world.time_s());
  set_trochoids(trochoids, camera);
  rings_.prepare(trochoids, {camera.eye_m.x, camera.eye_m.z});
  rings_.bind(program_);
  program_.set("trochoid_mean_square", static_cast<float>(world.hidden_slopes().trochoids.mean_square()));

  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  glPolygonMode(GL_FRONT_AND_BACK, fill == Fill::wireframe ? GL_LINE : GL_FILL);
  glBindVertexArray(vertices_.name());
  glDrawElements(GL_TRIANGLES, 6 * cells_.columns * cells_.rows, GL_UNSIGNED_INT, nullptr);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glDisable(GL_DEPTH_TEST);
  return true;
}

}  // namespace offing::present
