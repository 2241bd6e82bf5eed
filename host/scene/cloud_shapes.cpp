#include "host/scene/cloud_shapes.h"

#include <utility>

#include "host/scene/parameter_table.h"

namespace offing::scene {
namespace {

bool has_shape(const CloudShapeScene& shape) {
  return !shape.file.empty() || !shape.mesh.empty() || !shape.text.empty();
}

/// All that a scene says of a cloud but its place, and what all clouds have in common.
std::string form_of(const OceanScene& scene, std::size_t index) {
  std::string text;
  for (const Parameter& row : parameter_table()) {
    const bool is_place = row.motion == ParameterMotion::keyed || row.key == "cloud.name";
    if (row.group == ParameterGroup::cloud && !is_place) {
      text += value_text(scene, row, {index, 0}, Digits::exact) + '\n';
    } else if (row.group == ParameterGroup::clouds) {
      text += value_text(scene, row, Digits::exact) + '\n';
    }
  }
  return text;
}

}  // namespace

void CloudShapes::begin() {
  last_ = std::exchange(now_, {});
}

RestingParticles CloudShapes::take(const OceanScene& scene, std::size_t index,
                                   clouds::CloudParameters& parameters) {
  if (!has_shape(scene.clouds[index].shape)) return nullptr;
  const std::string form = form_of(scene, index);
  if (const auto known = last_.find(form); known != last_.end()) now_.insert(*known);
  if (const auto known = now_.find(form); known != now_.end()) {
    const clouds::CloudParameters& made = known->second.parameters;
    parameters.shape = made.shape;
    parameters.modelling = made.modelling;
    parameters.turbulence = made.turbulence;
    parameters.look = made.look;
    return known->second.particles;
  }
  RestingParticles particles = take_shape(scene, index, parameters);
  now_.emplace(form, Shape{parameters, particles});
  return particles;
}

}  // namespace offing::scene
