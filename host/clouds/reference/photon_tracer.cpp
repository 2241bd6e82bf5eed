#include "host/clouds/reference/photon_tracer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "host/clouds/light/phase_function.h"

namespace offing::clouds {
namespace {

/// Where photons come from: a sun, or a hemisphere that shines alike from everywhere.
struct PhotonSource {
  glm::dvec3 direction;  // toward it, or toward the middle of the hemisphere
  bool is_hemisphere;
  glm::dvec3 illuminance_klx;  // over all its directions

  glm::dvec3 toward_light(PathRandom& random) const {
    if (!is_hemisphere) return direction;
    const double cosine = random.next();
    return turned(direction, cosine, 2.0 * std::numbers::pi * random.next());
  }
};

std::vector<PhotonSource> photon_sources(const CloudIllumination& light) {
  std::vector<PhotonSource> sources;
  for (const CloudLight& sun : light.suns) sources.push_back({sun.direction, false, sun.illuminance_klx});
  const double hemisphere_sr = 2.0 * std::numbers::pi;
  const glm::dvec3 up(0.0, 1.0, 0.0);
  if (light.sky_kcdpm2 != glm::dvec3(0.0)) sources.push_back({up, true, hemisphere_sr * light.sky_kcdpm2});
  if (light.ground_kcdpm2 != glm::dvec3(0.0))
    sources.push_back({-up, true, hemisphere_sr * light.ground_kcdpm2});
  return sources;
}

}  // namespace

std::vector<TracedIntensity> traced_intensities(const VolumeMedium& medium, const CloudLook& look,
                                                const CloudIllumination& light,
                                                std::span<const glm::dvec3> toward_eyes, double cone_rad,
                                                const TraceOptions& options) {
  const PhaseFunction phase(look);
  const double least_cosine = std::cos(cone_rad), cone_sr = 2.0 * std::numbers::pi * (1.0 - least_cosine);
  // Each direction takes the place of an order of scattering; what no cone takes is left out.
  TraceOptions sums = options;
  sums.orders = static_cast<int>(toward_eyes.size());
  std::vector<TracedIntensity> intensities(toward_eyes.size());
  std::vector<glm::dvec3> variances(toward_eyes.size(), glm::dvec3(0.0));
  for (const PhotonSource& source : photon_sources(light)) {
    const auto follow = [&](PathRandom& random, std::vector<glm::dvec3>& by_eye) {
      const glm::dvec3 toward_light = source.toward_light(random);
      // As many would collide first at a place as there is extinction, but for those that others took away.
      Ray ray{medium.random_place(random), -toward_light};
      glm::dvec3 weight(medium.transmittance({ray.origin_m, toward_light}, random));
      do {
        weight *= medium.albedo(ray.origin_m, look.albedo);
        if (!survives(weight, random)) return;
        const double cosine = phase.sample([&] { return random.next(); });
        ray.direction = turned(ray.direction, cosine, 2.0 * std::numbers::pi * random.next());
        const double distance = medium.next_collision(ray, random);
        if (!std::isfinite(distance)) break;
        ray.origin_m += distance * ray.direction;
      } while (true);
      for (std::size_t eye = 0; eye < toward_eyes.size(); ++eye)
        if (glm::dot(ray.direction, toward_eyes[eye]) >= least_cosine) by_eye[eye + 1] += weight;
    };
    const glm::dvec3 scale = source.illuminance_klx * medium.optical_mass_m2() / cone_sr;
    std::vector<glm::dvec3> squares;
    const Traced counted = mean_over_paths(sums, 1.0, follow, &squares);
    for (std::size_t eye = 0; eye < toward_eyes.size(); ++eye) {
      const glm::dvec3& mean = counted.by_order[eye + 1];
      intensities[eye].kcd += scale * mean;
      variances[eye] += scale * scale * (squares[eye + 1] - mean * mean) / double(options.samples);
    }
    ++sums.seed;
  }
  for (std::size_t eye = 0; eye < toward_eyes.size(); ++eye) {
    for (int colour = 0; colour < 3; ++colour) {
      const double kcd = intensities[eye].kcd[colour];
      intensities[eye].relative_error[colour] = kcd > 0.0 ? std::sqrt(variances[eye][colour]) / kcd : 1.0;
    }
  }
  return intensities;
}

}  // namespace offing::clouds
