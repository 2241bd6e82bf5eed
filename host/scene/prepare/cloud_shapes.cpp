#include "host/scene/prepare/cloud_shapes.h"

#include <algorithm>
#include <string>
#include <system_error>
#include <utility>

namespace offing::scene {

CloudShapes::Source::Source(const CloudScene& cloud, const clouds::CloudParameters& parameters)
    : shape(cloud.shape), noise(cloud.noise), look(cloud.look), scale(cloud.scale), at_rest(parameters) {
  at_rest.position_m = {};
  at_rest.motion = {};
  at_rest.edits = {};
  const std::string& file = shape.file.empty() ? shape.mesh : shape.file;
  if (file.empty()) return;
  std::error_code none;
  written = std::filesystem::last_write_time(file, none);
  bytes = std::filesystem::file_size(file, none);
}

void CloudShapes::begin() {
  last_ = std::exchange(now_, {});
}

const CloudShapes::Shape* CloudShapes::known(const Source& source) {
  const auto is_it = [&](const Shape& shape) { return shape.source == source; };
  auto found = std::find_if(now_.begin(), now_.end(), is_it);
  if (found == now_.end()) {
    const auto before = std::find_if(last_.begin(), last_.end(), is_it);
    if (before == last_.end()) return nullptr;
    found = now_.insert(now_.end(), *before);
  }
  return &*found;
}

RestingParticles CloudShapes::take(const Scene& scene, std::size_t index,
                                   clouds::CloudParameters& parameters) {
  if (!scene.clouds[index].shape.is_given()) return nullptr;
  const Source source(scene.clouds[index], parameters);
  if (const Shape* shape = known(source)) {
    parameters.shape = shape->parameters.shape;
    parameters.takes_cells_of_shape = shape->parameters.takes_cells_of_shape;
    parameters.modelling = shape->parameters.modelling;
    parameters.turbulence = shape->parameters.turbulence;
    parameters.look = shape->parameters.look;
    return shape->particles;
  }
  RestingParticles particles = take_shape(scene, index, parameters);
  now_.push_back({source, parameters, particles});
  return particles;
}

void CloudShapes::keep(const Scene& scene, std::size_t index, const clouds::CloudParameters& parameters) {
  if (scene.clouds[index].shape.is_given()) known(Source(scene.clouds[index], parameters));
}

}  // namespace offing::scene
