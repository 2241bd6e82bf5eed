#pragma once

#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "host/base/camera.h"
#include "host/clouds/light/phase_function.h"
#include "host/clouds/reference/scattering_medium.h"
#include "host/clouds/reference/traced_paths.h"
#include "host/clouds/shape/cloud_parameters.h"

namespace offing::clouds {

/// A cloud as seen from far away: integrals over the plane across the line of sight.
struct TracedView {
  Traced intensity_kcd;     ///< radiance times area; order 0 is left out
  double covered_m2 = 0.0;  ///< opacity times area, opacity = 1 - transmittance
};

/// Pixels [height][width], row 0 at the top: scattered light, kcd/m2, premultiplied, and opacity.
using LightImage = std::vector<glm::vec4>;

/// What a camera sees, as one image and by the number of times that light was scattered.
struct TracedImage {
  LightImage image;
  std::vector<LightImage>
      orders;  ///< [orders], scattered once, twice, ...; their light sums up to the image's
};

/// Light in a cloud by tracing paths from the eye, in double precision: what the light of particles is
/// measured against. Collisions by delta tracking, suns seen from each by ratio tracking; without bias, so
/// that errors are noise of a known size. The same seed gives the same result on any number of threads.
class ReferenceTracer {
 public:
  /// Keeps a reference to the medium. Throws Error(bad_input) as PhaseFunction does, or unless albedos are
  /// within 0 ... 1.
  ReferenceTracer(const ScatteringMedium& medium, const CloudLook& look, const CloudIllumination& light);

  /// Radiance in kcd/m2 that arrives against the ray. Throws Error(bad_usage) unless samples and orders are 1
  /// or more, as all that trace.
  Traced radiance(const Ray& ray, const TraceOptions& options) const;

  /// A sphere that the cloud lies in, as seen from the unit direction `toward_eye`, infinitely far away.
  TracedView view_of(const glm::dvec3& middle_m, double radius_m, const glm::dvec3& toward_eye,
                     const TraceOptions& options) const;

  /// What the camera sees of the cloud, without what lies behind it.
  TracedImage image(const Camera& camera, const TraceOptions& options) const;

 private:
  void trace(Ray ray, PathRandom& random, std::vector<glm::dvec3>& by_order) const;

  const ScatteringMedium& medium_;
  PhaseFunction phase_;
  glm::dvec3 albedo_;
  CloudIllumination light_;
};

/// Shares of the light of a beam that a slab reflects and lets through (the beam itself too), each [orders +
/// 1] by how often it was scattered, by counting photons.
struct SlabLight {
  std::vector<double> reflected_by_order, transmitted_by_order;
  double reflected = 0.0, transmitted = 0.0;
  double reflected_error = 0.0, transmitted_error = 0.0;  ///< standard errors
};

/// A beam that falls on a slab of this optical depth with this cosine from its normal. Throws
/// Error(bad_usage) unless 0 < incidence_cosine <= 1 and the depth is above 0.
SlabLight trace_slab(double optical_depth, double incidence_cosine, double albedo, const CloudLook& look,
                     const TraceOptions& options);

}  // namespace offing::clouds
