#pragma once

#include "host/base/cloud_volume.h"
#include "host/clouds/shape/cloud_parameters.h"
#include "host/ocl/device.h"

namespace offing::clouds {

/// The density of a cloud at a time, in cells of cell_m: of a sampled one its field, of a hierarchical one
/// its particles. Throws what field_volume() and rasterised() throw (host/clouds/shape/cloud_density.h).
CloudVolume density_volume(const ocl::Device& device, const CloudParameters& parameters, double cell_m,
                           double time_s);

}  // namespace offing::clouds
