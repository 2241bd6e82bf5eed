#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "host/clouds/reference/scattering_medium.h"
#include "host/clouds/reference/traced_paths.h"
#include "host/clouds/shape/cloud_parameters.h"

namespace offing::clouds {

/// Mean intensity over a cone of directions.
struct TracedIntensity {
  glm::dvec3 kcd{0.0};
  glm::dvec3 relative_error{0.0};  ///< standard error over value; 1 where there is no light
};

/// Intensities of the scattered light of suns, sky and ground, means over cones of half angle `cone_rad`
/// around unit directions toward eyes, of all of them at once: options.samples photons of each light are
/// followed from their first collision on, and counted where they leave the cloud. A sharp forward peak makes
/// this far less noisy than ReferenceTracer::view_of(), thin clouds do not make it slower. Without bias;
/// options.orders does not count. Throws Error(bad_input) as PhaseFunction does, Error(bad_usage) unless
/// samples are 1 or more.
std::vector<TracedIntensity> traced_intensities(const VolumeMedium& medium, const CloudLook& look,
                                                const CloudIllumination& light,
                                                std::span<const glm::dvec3> toward_eyes, double cone_rad,
                                                const TraceOptions& options);

}  // namespace offing::clouds
