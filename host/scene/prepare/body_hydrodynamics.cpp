#include "host/scene/prepare/body_hydrodynamics.h"

#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/log.h"
#include "host/bodies/hydrostatics.h"
#include "host/bodies/panel_method.h"
#include "host/io/hydrodynamics/read_hydrodynamics.h"
#include "host/scene/model/named_file.h"

namespace offing::scene {

HydrodynamicData fitted_to(hydrodynamics::HydrodynamicFile file, const bodies::FloatingBody& body,
                           const bodies::BodyWaterParameters& water) {
  HydrodynamicData& data = file.data;
  if (std::abs(data.gravity_mps2 / water.gravity_mps2 - 1.0) > 0.01) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected a gravity of {:g} m/s2, got {:g}", one_line(data.source),
                            water.gravity_mps2, data.gravity_mps2),
                "compute the data with the gravity of the scene");
  }
  // All forces of linear theory are in proportion to the density.
  const double share = water.density_kgpm3 / data.density_kgpm3;
  const auto scale = [&](HullMatrix& matrix) {
    for (double& value : matrix) value *= share;
  };
  for (HullMatrix& matrix : data.added_mass) scale(matrix);
  for (HullMatrix& matrix : data.damping) scale(matrix);
  scale(data.added_mass_at_infinity);
  for (HullWrench& wrench : data.excitation) {
    for (auto& value : wrench) value *= share;
  }
  data.density_kgpm3 = water.density_kgpm3;
  if (!file.has_infinite_frequency) data.added_mass_at_infinity = bodies::added_mass_by_damping(data);

  const double level_m =
      bodies::level_that_displaces(body.hull, body.mass_kg / water.density_kgpm3, body.name.c_str());
  data.about_m.y += level_m;
  data.water_level_m = level_m;
  if (file.restoring) {
    constexpr std::size_t heave = 7;
    const double plane_m2 = bodies::submerged_below(body.hull, level_m).plane_m2;
    const double expected = water.density_kgpm3 * water.gravity_mps2 * plane_m2,
                 got = share * (*file.restoring)[heave];
    if (std::abs(got - expected) > 0.1 * expected) {
      spdlog::warn(
          "{}: it is for a water plane of {:.4g} m2, but that of {} has {:.4g} m2: check the hull, its "
          "draught and hydrodynamics_length_m",
          one_line(data.source), got / (water.density_kgpm3 * water.gravity_mps2), body.name, plane_m2);
    }
  }
  return std::move(data);
}

std::shared_ptr<const HydrodynamicData> read_body_hydrodynamics(const Scene& scene, std::size_t index,
                                                                const bodies::FloatingBody& body) {
  const BodyScene& row = scene.bodies[index];
  if (row.hydrodynamics.empty()) return {};
  const bodies::BodyWaterParameters water;
  return read_named(scene, {"body.hydrodynamics", {index, 0}}, "a file of hydrodynamic data",
                    row.hydrodynamics, [&] {
                      return std::make_shared<const HydrodynamicData>(
                          fitted_to(read_hydrodynamics(row.hydrodynamics,
                                                       {.density_kgpm3 = water.density_kgpm3,
                                                        .gravity_mps2 = water.gravity_mps2,
                                                        .length_m = row.hydrodynamics_length_m},
                                                       scene.trust),
                                    body, water));
                    });
}

}  // namespace offing::scene
