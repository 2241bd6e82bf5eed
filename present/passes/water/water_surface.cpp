#include "present/passes/water/water_surface.h"

#include <cstdint>
#include <vector>

#include "host/ocean/surface/projected_grid.h"
#include "present/passes/clip_from_eye.h"

namespace offing::present {
namespace {

constexpr int output_count = 3;
constexpr int first_shape_unit = 0, hull_unit = 4;

ShaderProgram surface_program() {
  return ShaderProgram(
      {.vertex = {shader_file("water/water.vert")},
       .fragment = {shader_file("water/hull_mask.glsl"), shader_file("water/water_surface.frag")}});
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

}  // namespace

WaterSurface::WaterSurface(const GlCapabilities& capabilities, GridCells cells)
    : capabilities_(capabilities),
      shape_(cells),
      program_(surface_program()),
      vertices_(GlVertexArray::make()),
      indices_(GlBuffer::make()) {
  index_cells();
}

void WaterSurface::fit(GridCells cells) {
  if (shape_.cells() == cells) return;
  shape_.fit(cells);
  index_cells();
}

void WaterSurface::index_cells() const {
  const std::vector<std::uint32_t> indices = triangles(shape_.cells());
  glBindVertexArray(vertices_.name());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)),
               indices.data(), GL_STATIC_DRAW);
  glBindVertexArray(0);
}

bool WaterSurface::draw(const world::World& world, const WaterMaps& maps, const Camera& camera, Fill fill) {
  const std::optional<ocean::ProjectedGrid> grid = ocean::ProjectedGrid::for_camera(camera, world.reach());
  if (!grid) return false;
  shape_.draw(world, maps, camera, *grid);
  if (target_.width() != camera.width_px || target_.height() != camera.height_px) {
    target_ = RenderTarget(camera.width_px, camera.height_px, GL_RGBA32F, output_count,
                           RenderTarget::Depth::single_precision);
  }
  target_.bind();
  glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  glClearDepth(0.0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);

  program_.use();
  program_.set("clip_from_eye", glm::mat4(clip_from_eye(camera, capabilities_.has_clip_control)));
  shape_.bind(program_, first_shape_unit);
  hulls_.bind(program_, hull_unit, world, camera);

  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  glPolygonMode(GL_FRONT_AND_BACK, fill == Fill::wireframe ? GL_LINE : GL_FILL);
  glBindVertexArray(vertices_.name());
  glDrawElements(GL_TRIANGLES, 6 * shape_.cells().columns * shape_.cells().rows, GL_UNSIGNED_INT, nullptr);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glDisable(GL_DEPTH_TEST);
  return true;
}

}  // namespace offing::present
