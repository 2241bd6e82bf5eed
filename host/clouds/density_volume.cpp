#include "host/clouds/density_volume.h"

#include "host/clouds/cloud_density.h"

namespace offing::clouds {

CloudVolume density_volume(const ocl::Device& device, const CloudParameters& parameters, double cell_m,
                           double time_s) {
  return field_volume(device, parameters, cell_m, time_s);
}

}  // namespace offing::clouds
