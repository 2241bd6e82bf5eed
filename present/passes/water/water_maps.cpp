#include "present/passes/water/water_maps.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec4.hpp>

namespace offing::present {
namespace {

constexpr GLuint shares_binding = 4;
constexpr std::size_t share_values = SHOAL_STEPS * SHOAL_BANDS / 4;

void upload(const ocean::DepthMap& map) {
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, map.columns, map.rows, 0, GL_RED, GL_FLOAT, map.depths_m.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

constexpr int displacement_unit = 0, gradient_unit = 1, foam_unit = 2, wake_unit = 3, shoal_unit = 4;

}  // namespace

ShoalTexture::ShoalTexture() : depths_(GlTexture::make()), shares_("Shoals", shares_binding, share_values) {}

void ShoalTexture::prepare(const std::shared_ptr<const ocean::Shoals>& shoals) {
  if (shoals == shoals_) return;
  shoals_ = shoals;
  if (!shoals) return;
  const ocean::ShoalsInstant& instant = shoals->instant();
  glBindTexture(GL_TEXTURE_2D, depths_.name());
  upload(*instant.depths);
  std::vector<glm::vec4> values;
  const std::vector<float>& shares = instant.table.shares();
  for (std::size_t i = 0; i < shares.size(); i += 4) {
    values.emplace_back(shares[i], shares[i + 1], shares[i + 2], shares[i + 3]);
  }
  shares_.fill(std::move(values));
}

void ShoalTexture::bind(const ShaderProgram& program, glm::dvec2 eye_m, int unit) const {
  if (!shoals_) return;
  bind_sampler(program, "shoal_depths", unit, depths_.name());
  shares_.bind(program);
  const ocean::DepthMap& map = *shoals_->instant().depths;
  program.set("shoal_place", glm::vec4((eye_m.x - map.origin_x_m) / map.spacing_x_m,
                                       (eye_m.y - map.origin_z_m) / map.spacing_z_m, 1.0 / map.spacing_x_m,
                                       1.0 / map.spacing_z_m));
  program.set("shoal_deepest_m", static_cast<float>(shoals_->instant().table.deepest_m()));
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
    uploads.push_back({wakes->maps()->maps(), &wakes_});
  }
  glActiveTexture(GL_TEXTURE0);
  transfer.upload(uploads);
  for (const MapTexture* map : {&displacement_, &gradient_, &foam_}) map->make_levels();
  if (world.wakes()) wakes_.make_levels();
  shoals_.prepare(world.shoals());
}

void WaterMaps::bind(const ShaderProgram& program, const world::World& world, glm::dvec2 eye_m) const {
  const ocean::OceanParameters& sea = world.parameters().ocean;
  std::vector<glm::vec4> cascades;
  std::vector<float> longest_wave_m;
  for (const ocean::Cascade& cascade : sea.cascades) {
    const double length_m = cascade.patch_length_m;
    // Reduced in double, so that an eye far from the origin loses nothing.
    const glm::dvec2 place = eye_m / length_m;
    cascades.emplace_back(1.0 / length_m, place.x - std::floor(place.x), place.y - std::floor(place.y),
                          world.sea_samples() / length_m);
    longest_wave_m.push_back(cascade.k_min_radpm > 0.0
                                 ? static_cast<float>(2.0 * std::numbers::pi / cascade.k_min_radpm)
                                 : std::numeric_limits<float>::max());
  }
  program.set("cascades", cascades);
  program.set("longest_wave_m", longest_wave_m);
  displacement_.bind(displacement_unit);
  gradient_.bind(gradient_unit);
  foam_.bind(foam_unit);
  program.set("displacement_map", displacement_unit);
  program.set("gradient_map", gradient_unit);
  program.set("foam_map", foam_unit);
  bind_wakes(program, world, eye_m);
  shoals_.bind(program, eye_m, shoal_unit);
}

void WaterMaps::bind_wakes(const ShaderProgram& program, const world::World& world, glm::dvec2 eye_m) const {
  program.set("wake_map", wake_unit);
  const world::WorldWakes* view = world.wakes();
  if (!view) return;
  std::vector<glm::vec4> wakes;
  std::vector<glm::vec4> first;
  const ocean::SampleGrid eye{.origin_x_m = eye_m.x, .origin_z_m = eye_m.y};
  const std::vector<WakeSamples> places = view->maps()->samples_of(eye);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const WakeLayer& layer = view->maps()->layer_values()[i];
    wakes.emplace_back(layer.cells_per_m, places[i].column, places[i].row, layer.size);
    first.emplace_back(layer.first_column, layer.first_row, 0.0f, 0.0f);
  }
  program.set("wakes", wakes);
  program.set("wake_first", first);
  wakes_.bind(wake_unit);
}

}  // namespace offing::present
