#include "present/passes/water/water_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "kernels/shared/gerstner_params.h"
#include "present/gl/sampler.h"

namespace offing::present {
namespace {

// The outputs of water_shape.frag, as water.vert calls them.
constexpr std::array outputs{"place_of", "facet_of", "strain_of"};
constexpr GLuint gerstner_waves_binding = 1;
constexpr std::size_t gerstner_values = GERSTNER_WAVES + GERSTNER_WAVES / 4;

ShaderProgram shape_program(const WaveFeatures& features) {
  std::vector<ShaderPart> fragment = wave_shaders(features);
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

}  // namespace

WaterShape::WaterShape(GridCells cells)
    : programs_(shape_program),
      no_vertices_(GlVertexArray::make()),
      gerstner_block_("GerstnerWaves", gerstner_waves_binding, gerstner_values) {
  fit(cells);
}

void WaterShape::fit(GridCells cells) {
  cells_ = cells;
  target_ = RenderTarget(cells.columns + 1, cells.rows + 1, GL_RGBA32F, static_cast<int>(outputs.size()),
                         RenderTarget::Depth::none);
}

void WaterShape::set_gerstner_waves(const ocean::GerstnerInstant& gerstner_waves, const ocean::Shoals* shoals,
                                    const Camera& camera, const ShaderProgram& program) const {
  // As the shader's block has them: the waves, then their phases, four a value.
  std::vector<glm::vec4> waves(gerstner_values);
  std::size_t count = 0;
  const BandedWaves banded = in_bands(gerstner_waves, shoals);
  for (const ocean::GerstnerInstant::Wave& wave : banded.waves) {
    waves[count] = {wave.kx_radpm, wave.kz_radpm, wave.amplitude_m,
                    gerstner_waves.horizontal_scale() * wave.amplitude_m};
    const double phase = wave.kx_radpm * camera.eye_m.x + wave.kz_radpm * camera.eye_m.z + wave.phase_rad;
    waves[GERSTNER_WAVES + count / 4][static_cast<int>(count % 4)] =
        static_cast<float>(std::remainder(phase, 2.0 * std::numbers::pi));
    ++count;
  }
  program.set("wave_count", static_cast<int>(count));
  program.set("band_ends", banded.ends);
  gerstner_block_.fill(std::move(waves));
  gerstner_block_.bind(program);
}

void WaterShape::draw(const world::World& world, const WaterMaps& maps, const Camera& camera,
                      const ocean::ProjectedGrid& grid) {
  const glm::dvec2 eye_m(camera.eye_m.x, camera.eye_m.z);
  const ocean::GerstnerInstant gerstner_waves(world.parameters().gerstner_waves, world.time_s());
  rings_.prepare(gerstner_waves, eye_m);
  const ShaderProgram& program = programs_.with(wave_features(world, rings_));
  target_.bind();
  program.use();
  std::vector<glm::vec3> corners;
  for (const ocean::ProjectedGrid::Corner& corner : grid.corners()) {
    corners.emplace_back(corner.label_m.x, corner.label_m.y, corner.w);
  }
  program.set("corners", corners);
  program.set("cells", glm::ivec2(cells_.columns, cells_.rows));
  program.set("eye_height_m", static_cast<float>(camera.eye_m.y));
  maps.bind(program, world, eye_m);
  set_gerstner_waves(gerstner_waves, world.shoals().get(), camera, program);
  rings_.bind(program);
  program.set("gerstner_mean_square", static_cast<float>(world.hidden_slopes().gerstner_waves.mean_square()));
  glBindVertexArray(no_vertices_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void WaterShape::bind(const ShaderProgram& program, int first_unit) const {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    bind_sampler(program, outputs[i], first_unit + static_cast<int>(i), target_.texture(i));
  }
}

}  // namespace offing::present
