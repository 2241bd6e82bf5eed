#pragma once

#include <cstddef>
#include <memory>

#include "host/bodies/floating_bodies.h"
#include "host/io/hydrodynamics/hydrodynamic_table.h"
#include "host/scene/model/scene.h"

namespace offing::scene {

/// The data of a file for a hull that floats as this body does: in the axes of its mesh, for the density of
/// its water, with an added mass at infinite frequency. Logs a warning if the file's restoring force in heave
/// is not the hull's. Throws Error(bad_input) for another gravity.
HydrodynamicData fitted_to(hydrodynamics::HydrodynamicFile file, const bodies::FloatingBody& body,
                           const bodies::BodyWaterParameters& water);

/// Reads `hydrodynamics` of a body of the scene; nothing if it has none.
std::shared_ptr<const HydrodynamicData> read_body_hydrodynamics(const Scene& scene, std::size_t index,
                                                                const bodies::FloatingBody& body);

}  // namespace offing::scene
