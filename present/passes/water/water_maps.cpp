#include "present/passes/water/water_maps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <numbers>
#include <vector>

#include <glm/common.hpp>

#include "present/passes/uniform_bindings.h"

namespace offing::present {
namespace {

void upload(const ocean::DepthMap& map) {
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, map.columns, map.rows, 0, GL_RED, GL_FLOAT, map.depths_m.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void set_swash(const world::World& world, glm::dvec2 eye_m, glsl::WaveUniforms& waves) {
  const SwashParams swash = world.swash()->at(eye_m.x, eye_m.y, world.time_s());
  waves.swash_setup_m = swash.setup_m;
  waves.swash_reach_m = swash.reach_m;
  waves.swash_period_s = swash.period_s;
  for (int i = 0; i < SWASH_WAVES; ++i) {
    waves.swash_waves[i] = {swash.kx_radpm[i], swash.kz_radpm[i], swash.amplitude_m[i], swash.phase_rad[i]};
    waves.swash_omegas[i / 4][i % 4] = swash.omega_radps[i];
  }
  const ocean::OpenSea& sea = world.swash()->sea();
  waves.surf = {std::cos(sea.direction_rad), std::sin(sea.direction_rad), sea.wavenumber_radpm, sea.height_m};
}

constexpr int displacement_unit = 0, gradient_unit = 1, foam_unit = 2, wake_unit = 3, shoal_unit = 4;

}  // namespace

ShoalTexture::ShoalTexture() : depths_(GlTexture::make()), shares_("Shoals", shoals_binding) {}

void ShoalTexture::prepare(const std::shared_ptr<const ocean::Shoals>& shoals) {
  if (shoals == shoals_) return;
  shoals_ = shoals;
  if (!shoals) return;
  const ocean::ShoalsInstant& instant = shoals->instant();
  glBindTexture(GL_TEXTURE_2D, depths_.name());
  upload(*instant.depths);
  const std::vector<float>& shares = instant.table.shares();
  glsl::ShoalUniforms uniforms{};
  static_assert(sizeof(uniforms) == SHOAL_STEPS * SHOAL_BANDS * sizeof(float));
  std::memcpy(uniforms.shares, shares.data(), std::min(sizeof(uniforms), shares.size() * sizeof(float)));
  shares_.fill(uniforms);
}

void ShoalTexture::bind(const ShaderProgram& program, int unit) const {
  if (!shoals_) return;
  bind_sampler(program, "shoal_depths", unit, depths_.name());
  shares_.bind(program);
}

void ShoalTexture::place(glm::dvec2 eye_m, glsl::WaveUniforms& waves) const {
  if (!shoals_) return;
  const ocean::DepthMap& map = *shoals_->instant().depths;
  waves.shoal_place = {(eye_m.x - map.origin_x_m) / map.spacing_x_m,
                       (eye_m.y - map.origin_z_m) / map.spacing_z_m, 1.0 / map.spacing_x_m,
                       1.0 / map.spacing_z_m};
  waves.shoal_deepest_m = static_cast<float>(shoals_->instant().table.deepest_m());
}

void WaterMaps::prepare(world::World& world, Transfer& transfer) {
  ocean::Ocean& ocean = world.ocean();
  const int size = ocean.parameters().size;
  const int layers = static_cast<int>(ocean.parameters().cascades.size());
  if (displacement_.size() != size || displacement_.layers() != layers) {
    displacement_ = MapTexture(size, layers, 4);
    gradient_ = MapTexture(size, layers, 4);
    foam_ = MapTexture(size, layers, 1);
  }
  std::vector<Upload> uploads{{ocean.displacement_map(), &displacement_},
                              {ocean.gradient_map(), &gradient_},
                              {ocean.foam_map(), &foam_}};
  if (const world::WorldWakes* wakes = world.wakes()) {
    const int cells = wakes->maps()->layer_values().front().size;
    const int windows = static_cast<int>(wakes->maps()->count());
    if (wakes_.size() != cells || wakes_.layers() != windows) wakes_ = MapTexture(cells, windows, 4);
    uploads.push_back({wakes->maps()->shown(), &wakes_});
  }
  glActiveTexture(GL_TEXTURE0);
  transfer.upload(uploads);
  shoals_.prepare(world.shoals());
}

void WaterMaps::bind(const ShaderProgram& program) const {
  displacement_.bind(displacement_unit);
  gradient_.bind(gradient_unit);
  foam_.bind(foam_unit);
  program.set("displacement_map", displacement_unit);
  program.set("gradient_map", gradient_unit);
  program.set("foam_map", foam_unit);
  program.set("wake_map", wake_unit);
  if (wakes_.layers() > 0) wakes_.bind(wake_unit);
  shoals_.bind(program, shoal_unit);
}

glsl::WaveUniforms WaterMaps::waves(const world::World& world, glm::dvec2 eye_m) const {
  glsl::WaveUniforms waves{};
  const std::vector<ocean::Cascade>& cascades = world.parameters().ocean.cascades;
  for (int i = 0; i < std::min(static_cast<int>(cascades.size()), glsl::most_cascades); ++i) {
    const ocean::Cascade& cascade = cascades[static_cast<std::size_t>(i)];
    const double length_m = cascade.patch_length_m;
    // Reduced in double, so that an eye far from the origin loses nothing.
    const glm::dvec2 place = eye_m / length_m;
    waves.cascades[i] = {1.0 / length_m, place.x - std::floor(place.x), place.y - std::floor(place.y),
                         world.sea_samples() / length_m};
    waves.longest_wave_m[i] = cascade.k_min_radpm > 0.0
                                  ? static_cast<float>(2.0 * std::numbers::pi / cascade.k_min_radpm)
                                  : std::numeric_limits<float>::max();
  }
  if (const world::WorldWakes* wakes = world.wakes()) {
    const ocean::SampleGrid eye{.origin_x_m = eye_m.x, .origin_z_m = eye_m.y};
    const std::vector<WakeSamples> places = wakes->maps()->samples_of(eye);
    for (std::size_t i = 0; i < std::min<std::size_t>(places.size(), glsl::most_wakes); ++i) {
      const WakeLayer& layer = wakes->maps()->layer_values()[i];
      waves.wakes[i] = {layer.cells_per_m, places[i].column, places[i].row, layer.size};
      waves.wake_first[i] = {layer.first_column, layer.first_row, 0.0f, 0.0f};
    }
  }
  shoals_.place(eye_m, waves);
  if (world.swash()) set_swash(world, eye_m, waves);
  return waves;
}

}  // namespace offing::present
