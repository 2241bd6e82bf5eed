#include "present/passes/water/water_maps.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <glm/common.hpp>

namespace offing::present {
namespace {

constexpr int displacement_unit = 0, gradient_unit = 1, foam_unit = 2, wake_unit = 3, shoal_unit = 4;

}  // namespace

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
