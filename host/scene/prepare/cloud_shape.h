#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "host/clouds/shape/cloud_parameters.h"
#include "host/scene/model/scene.h"
#include "kernels/shared/clouds.h"

namespace offing::scene {

/// Particles at rest, in the axes of their cloud.
using RestingParticles = std::shared_ptr<const std::vector<CloudParticle>>;

/// Gives a cloud the shape that its scene names, of its file, mesh or text, if it names one: fills in
/// `shape`, of volumes the extinction that their file tells, or the particles that a file of particles has,
/// which are returned; nullptr for none. Places in files are relative to the cloud's. Throws Error(bad_input)
/// that names the place in the scene.
RestingParticles take_shape(const Scene& scene, std::size_t index, clouds::CloudParameters& parameters);

}  // namespace offing::scene
