#include "host/world/cloud_grower.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/clouds/particles/cloud_model.h"

namespace offing::world {
namespace {

/// What particles at rest are made of.
clouds::CloudParameters form_of(const clouds::CloudParameters& cloud) {
  clouds::CloudParameters form = cloud;
  form.position_m = glm::dvec3(0.0);
  form.motion = {};
  form.edits.clear();
  return form;
}

}  // namespace

CloudSkyParameters CloudGrower::grown(CloudSkyParameters sky, const CancelToken& cancel,
                                      const std::function<void(CloudProgress)>& progress,
                                      LongWork long_work) {
  const std::size_t count = sky.clouds.size();
  sky.particles.resize(count);
  std::vector<Form> forms;
  for (std::size_t i = 0; i < count; ++i) {
    cancel.throw_if_cancelled();
    const auto tell = [&](double share) {
      if (progress) progress({i, count, share});
    };
    tell(0.0);
    auto& particles = sky.particles[i];
    if (particles) continue;
    clouds::CloudParameters form = form_of(sky.clouds[i]);
    const auto same = [&](const Form& known) { return known.parameters == form; };
    if (const auto known = std::find_if(known_.begin(), known_.end(), same); known != known_.end()) {
      particles = known->particles;
    } else {
      try {
        if (long_work == LongWork::refused) clouds::require_short_sampling(device_, form);
        particles = std::make_shared<const std::vector<CloudParticle>>(
            clouds::particles_at_rest(device_, form, Work(cancel, tell)));
      } catch (const Error& error) {
        throw Error(error.kind(), fmt::format("cloud {}: {}", i + 1, error.what()), error.hint());
      }
    }
    forms.push_back({std::move(form), particles});
  }
  known_ = std::move(forms);
  if (progress) progress({count, count});
  return sky;
}

void grow_clouds(const ocl::Device& device, WorldParameters& parameters, const CancelToken& cancel,
                 const std::function<void(CloudProgress)>& progress) {
  if (parameters.clouds) {
    parameters.clouds = CloudGrower(device).grown(std::move(*parameters.clouds), cancel, progress);
  }
}

}  // namespace offing::world
