#include "present/passes/water/water_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <utility>
#include <vector>

#include "present/passes/camera_projection.h"
#include "present/passes/uniform_bindings.h"

namespace offing::present {
namespace {

// The outputs of water_shape.frag, as water.vert calls them.
constexpr std::array outputs{"place_of", "facet_of", "strain_of"};

ShaderProgram shape_program(const WaveFeatures& features) {
  std::vector<ShaderPart> fragment = water_uniforms("Shape", "WaveUniforms waves; ShapeUniforms shape;");
  std::ranges::move(wave_shaders(features), std::back_inserter(fragment));
  fragment.push_back(shader_file("water/water_shape.frag"));
  return ShaderProgram({.vertex = {shader_file("screen.vert")}, .fragment = std::move(fragment)});
}

/// Gerstner waves of one band after the other, and where the first three bands end.
struct BandedWaves {
  std::vector<ocean::GerstnerInstant::Wave> waves;
  glm::vec3 ends;
};

BandedWaves in_bands(const ocean::GerstnerInstant& gerstner_waves, const ocean::Shoals* shoals) {
  BandedWaves banded{.waves = gerstner_waves.waves(),
                     .ends = glm::vec3(static_cast<float>(gerstner_waves.waves().size()))};
  if (shoals == nullptr) return banded;
  const auto band_of = [&](const ocean::GerstnerInstant::Wave& wave) {
    return shoals->instant().table.bands().gerstner_band(std::hypot(wave.kx_radpm, wave.kz_radpm));
  };
  std::stable_sort(banded.waves.begin(), banded.waves.end(),
                   [&](const auto& a, const auto& b) { return band_of(a) < band_of(b); });
  for (int band = 0; band < 3; ++band) {
    banded.ends[band] = static_cast<float>(
        std::count_if(banded.waves.begin(), banded.waves.end(),
                      [&](const ocean::GerstnerInstant::Wave& wave) { return band_of(wave) <= band; }));
  }
  return banded;
}

void set_gerstner_waves(const ocean::GerstnerInstant& gerstner_waves, const ocean::Shoals* shoals,
                        const Camera& camera, glsl::ShapeUniforms& shape) {
  int count = 0;
  const BandedWaves banded = in_bands(gerstner_waves, shoals);
  for (const ocean::GerstnerInstant::Wave& wave : banded.waves) {
    shape.waves[count] = {wave.kx_radpm, wave.kz_radpm, wave.amplitude_m,
                          gerstner_waves.horizontal_scale() * wave.amplitude_m};
    const double phase = wave.kx_radpm * camera.eye_m.x + wave.kz_radpm * camera.eye_m.z + wave.phase_rad;
    shape.phases[count / 4][count % 4] = static_cast<float>(std::remainder(phase, 2.0 * std::numbers::pi));
    ++count;
  }
  shape.wave_count = count;
  shape.band_ends = banded.ends;
}

constexpr int output_count = 3;
constexpr int first_shape_unit = 0, hull_unit = 4;

ShaderProgram surface_program() {
  const std::vector<ShaderPart> uniforms = water_uniforms("Surface", "SurfaceUniforms grid;");
  ShaderStages stages{.vertex = uniforms, .fragment = uniforms};
  stages.vertex.push_back(shader_file("water/water.vert"));
  for (const char* name : {"water/hull_mask.glsl", "water/water_surface.frag"}) {
    stages.fragment.push_back(shader_file(name));
  }
  return ShaderProgram(stages);
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

WaterShape::WaterShape(GridCells cells)
    : programs_(shape_program), no_vertices_(GlVertexArray::make()), block_("Shape", pass_binding) {
  fit(cells);
}

void WaterShape::fit(GridCells cells) {
  cells_ = cells;
  target_ = RenderTarget(cells.columns + 1, cells.rows + 1, GL_RGBA32F, static_cast<int>(outputs.size()),
                         RenderTarget::Depth::none);
}

void WaterShape::draw(const world::World& world, const WaterMaps& maps, const Camera& camera,
                      const ocean::ProjectedGrid& grid) {
  const glm::dvec2 eye_m(camera.eye_m.x, camera.eye_m.z);
  const ocean::GerstnerInstant gerstner_waves(world.parameters().ocean.gerstner_waves, world.time_s());
  rings_.prepare(gerstner_waves, eye_m);
  const ShaderProgram& program = programs_.with(wave_features(world, rings_));
  target_.bind();
  program.use();
  glsl::ShapeUniforms shape{};
  shape.cells = glm::ivec2(cells_.columns, cells_.rows);
  shape.eye_height_m = static_cast<float>(camera.eye_m.y);
  shape.gerstner_mean_square = static_cast<float>(world.hidden_slopes().gerstner_waves.mean_square());
  std::ranges::transform(grid.corners(), shape.corners, [](const ocean::ProjectedGrid::Corner& corner) {
    return glm::vec4(corner.label_m.x, corner.label_m.y, corner.w, 0.0f);
  });
  set_gerstner_waves(gerstner_waves, world.shoals().get(), camera, shape);
  block_.fill(maps.waves(world, eye_m), shape);
  block_.bind(program);
  maps.bind(program);
  rings_.bind(program);
  glBindVertexArray(no_vertices_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void WaterShape::bind(const ShaderProgram& program, int first_unit) const {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    bind_sampler(program, outputs[i], first_unit + static_cast<int>(i), target_.texture(i));
  }
}

WaterSurface::WaterSurface(const GlCapabilities& capabilities, GridCells cells)
    : capabilities_(capabilities),
      shape_(cells),
      program_(surface_program()),
      block_("Surface", pass_binding),
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
  const Camera over_sea = above_level(camera, world.sea_level_m());
  const std::optional<ocean::ProjectedGrid> grid = ocean::ProjectedGrid::for_camera(over_sea, world.reach());
  if (!grid) return false;
  shape_.draw(world, maps, over_sea, *grid);
  if (target_.width() != camera.width_px || target_.height() != camera.height_px) {
    target_ = RenderTarget(camera.width_px, camera.height_px, GL_RGBA32F, output_count,
                           RenderTarget::Depth::single_precision);
  }
  target_.bind();
  glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  glClearDepth(0.0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);

  program_.use();
  glsl::SurfaceUniforms uniforms{};
  uniforms.clip_from_eye = clip_from_eye(camera, capabilities_.has_clip_control);
  hulls_.prepare(world, camera, uniforms);
  block_.fill(uniforms);
  block_.bind(program_);
  shape_.bind(program_, first_shape_unit);
  hulls_.bind(program_, hull_unit);

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
