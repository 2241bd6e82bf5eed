#include "present/water_maps.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <glm/common.hpp>

namespace offing::present {
namespace {

constexpr int displacement_unit = 0, gradient_unit = 1, foam_unit = 2;

}  // namespace

void WaterMaps::prepare(world::World& world, TransferLadder& transfer) {
  ocean::Ocean& ocean = world.ocean();
  const int size = ocean.parameters().size;
  const int layers = static_cast<int>(ocean.parameters().cascades.size());
  if (displacement_.size() != size || displacement_.layers() != layers) {
    displacement_ = MapTexture(size, layers, 4);
    gradient_ = MapTexture(size, layers, 4);
    foam_ = MapTexture(size, layers, 1);
  }
  const std::array<Upload, 3> uploads{{{ocean.displacement_map(), &displacement_},
                                       {ocean.gradient_map(), &gradient_},
                                       {ocean.foam_map(), &foam_}}};
  glActiveTexture(GL_TEXTURE0);
  transfer.upload(uploads);
  for (const MapTexture* map : {&displacement_, &gradient_, &foam_}) map->make_levels();
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
                          sea.size / length_m);
    longest_wave_m.push_back(cascade.k_min_radpm > 0.0
                                 ? static_cast<float>(2.0 * std::numbers::pi / cascade.k_min_radpm)
                                 : std::numeric_limits<float>::max());
  }
  program.set("cascade_count", static_cast<int>(cascades.size()));
  program.set("cascades", cascades);
  program.set("longest_wave_m", longest_wave_m);
  displacement_.bind(displacement_unit);
  gradient_.bind(gradient_unit);
  foam_.bind(foam_unit);
  program.set("displacement_map", displacement_unit);
  program.set("gradient_map", gradient_unit);
  program.set("foam_map", foam_unit);
}

}  // namespace offing::present
