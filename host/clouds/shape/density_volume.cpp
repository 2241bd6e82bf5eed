#include "host/clouds/shape/density_volume.h"

#include "host/clouds/particles/cloud_model.h"
#include "host/clouds/shape/cloud_density.h"

namespace offing::clouds {

CloudVolume density_volume(const ocl::Device& device, const CloudParameters& parameters, double cell_m,
                           double time_s) {
  if (parameters.modelling == Modelling::sampled || parameters.shape) {
    return field_volume(device, parameters, cell_m, time_s);
  }
  CloudModel model(device, parameters);
  const glm::dvec3 origin_m = cloud_origin_m(parameters, time_s);
  model.at(time_s, origin_m);
  std::vector<CloudParticle> particles = model.particles().read();
  particles.resize(model.count());
  CloudVolume volume = rasterised(device, particles, cell_m, parameters.look.extinction_per_m);
  volume.origin_m += origin_m;
  return volume;
}

}  // namespace offing::clouds
