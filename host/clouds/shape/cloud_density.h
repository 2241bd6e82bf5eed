#pragma once

#include <span>

#include "host/base/cloud_volume.h"
#include "host/base/work.h"
#include "host/clouds/shape/cloud_parameters.h"
#include "host/ocl/device.h"

namespace offing::clouds {

/// The density of a cloud of metaballs or of a shape, frayed by its noise (C1 ... C3), in cells of cell_m.
/// Only bricks with any density are kept. Places are those of the world at that time: the cloud's axes, at
/// its position, carried along by its wind. A shape that tells albedos gives them.
///
/// Accuracy: 1e-5 of the largest density, against a double-precision reference (tests/clouds/
/// cloud_density_test.cpp), wherever the cloud is.
/// Throws what require_valid() throws; Error(bad_input) for a cell that gives more bricks than can be counted
/// or held; Error(out_of_memory), Error(cancelled).
CloudVolume field_volume(const ocl::Device& device, const CloudParameters& parameters, double cell_m,
                         double time_s, const Work& work = {});

/// The extinction of particles in cells of cell_m, in the particles' axes: of each its optical mass, to the
/// rounding of a float, spread as h is (C1). A particle smaller than a cell spreads over a cell.
/// Throws Error(bad_input) that names a particle with a value out of range, and as field_volume().
CloudVolume rasterised(const ocl::Device& device, std::span<const CloudParticle> particles, double cell_m,
                       double extinction_per_m = 1.0);

/// Sum of the density over cells times a cell's volume and extinction: the optical mass, m^2.
double optical_mass(const CloudVolume& volume);

/// The density of a cloud at a time, in cells of cell_m: of a sampled one its field, of a hierarchical one
/// its particles. Throws what field_volume() and rasterised() throw.
CloudVolume density_volume(const ocl::Device& device, const CloudParameters& parameters, double cell_m,
                           double time_s);

}  // namespace offing::clouds
