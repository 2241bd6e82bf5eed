#include "host/cli/bodies/linear_body.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include "host/base/error.h"
#include "host/bodies/built_in_data.h"
#include "host/bodies/floating_bodies.h"
#include "host/scene/prepare/scene_bodies.h"
#include "host/scene/prepare/scene_meshes.h"

namespace offing::cli {
namespace {

using Complex = std::complex<double>;

LinearBody linear_body(bodies::FloatingBody body) {
  const bodies::BodyWaterParameters water;
  LinearBody linear;
  linear.level_m =
      bodies::level_that_displaces(body.hull, body.mass_kg / water.density_kgpm3, body.name.c_str());
  linear.below = bodies::submerged_below(body.hull, linear.level_m);
  linear.data = body.hydrodynamics;
  if (!linear.data) linear.data = bodies::built_in_data(body, water.density_kgpm3, water.gravity_mps2);
  std::array<double, 9> inertia{};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) inertia[static_cast<std::size_t>(3 * i + j)] = body.inertia_kgm2[i][j];
  }
  linear.mass = bodies::mass_matrix(body.mass_kg, inertia, body.mass_centre_m, linear.data->about_m);
  linear.restoring = bodies::restoring_matrix(linear.below, body.mass_centre_m, linear.data->about_m,
                                              water.density_kgpm3, water.gravity_mps2);
  linear.body = std::move(body);
  return linear;
}

/// omega^2 = g k tanh(k depth).
double wavenumber(const HydrodynamicData& data, double frequency_radps) {
  const double deep = frequency_radps * frequency_radps / data.gravity_mps2;
  if (!std::isfinite(data.depth_m)) return deep;
  double k = std::max(deep, frequency_radps / std::sqrt(data.gravity_mps2 * data.depth_m));
  for (int i = 0; i < 50; ++i) {
    const double t = std::tanh(k * data.depth_m);
    k -= (k * t - deep) / (t + k * data.depth_m * (1.0 - t * t));
  }
  return k;
}

}  // namespace

std::vector<LinearBody> linear_bodies(const scene::Scene& scene) {
  if (scene.bodies.empty()) {
    throw Error(ErrorKind::bad_input, "bodies: expected a scene with a [[body]], found none",
                "add a [[body]] to the scene, such as that of scenes/afloat.toml");
  }
  std::vector<LinearBody> bodies;
  for (world::BodySettings& settings : scene::prepare_bodies(scene, scene::prepare_meshes(scene)))
    bodies.push_back(linear_body(std::move(settings.body)));
  return bodies;
}

Response response_of(const LinearBody& body, double frequency_radps, double direction_rad) {
  HullWrench x =
      bodies::linear_response(*body.data, body.mass, body.restoring, frequency_radps, direction_rad);
  const glm::dvec3 arm = body.body.mass_centre_m - body.data->about_m;
  // turn x arm
  x[0] += x[4] * arm.z - x[5] * arm.y;
  x[1] += x[5] * arm.x - x[3] * arm.z;
  x[2] += x[3] * arm.y - x[4] * arm.x;
  const double ahead = arm.x * std::cos(direction_rad) + arm.z * std::sin(direction_rad);
  const Complex crest = std::polar(1.0, wavenumber(*body.data, frequency_radps) * ahead);
  Response response;
  for (std::size_t i = 0; i < hull_motions; ++i) {
    const Complex motion = x[motion_places[i]] / crest;
    response.amplitude[i] = std::abs(motion);
    response.lead_rad[i] = -std::arg(motion);  // of e^(-i omega t)
  }
  return response;
}

}  // namespace offing::cli
