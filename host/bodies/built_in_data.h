// Hydrodynamic data of bodies that have none of their own.
#pragma once

#include <memory>

#include "host/bodies/floating_body.h"

namespace offing::bodies {

/// Data of the panel method for the body as it floats at rest, upright. The last hulls are kept, so that
/// equal hulls, and one whose other properties change, share them. From any thread. Throws Error(bad_input)
/// for hulls of which it finds no numbers, and what panel_method() and level_that_displaces() throw.
std::shared_ptr<const HydrodynamicData> built_in_data(const FloatingBody& body, double density_kgpm3,
                                                      double gravity_mps2);

}  // namespace offing::bodies
