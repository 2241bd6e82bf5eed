#include "host/bodies/built_in_data.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <mutex>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/bodies/hydrostatics.h"
#include "host/bodies/panel_method.h"

namespace offing::bodies {
namespace {

constexpr std::size_t most_kept = 32;

struct KnownHull {
  TriangleMesh hull;
  double level_m = 0.0;
  std::shared_ptr<const HydrodynamicData> data;
};

bool is_finite(const HydrodynamicData& data) {
  const auto all_finite = [](const HullMatrix& matrix) {
    return std::ranges::all_of(matrix, [](double value) { return std::isfinite(value); });
  };
  return all_finite(data.added_mass_at_infinity) && std::ranges::all_of(data.added_mass, all_finite) &&
         std::ranges::all_of(data.damping, all_finite) &&
         std::ranges::all_of(data.excitation, [](const HullWrench& wrench) {
           return std::ranges::all_of(wrench,
                                      [](const auto& value) { return std::isfinite(std::abs(value)); });
         });
}

bool is_same(const KnownHull& known, const TriangleMesh& hull, double level_m, double density_kgpm3,
             double gravity_mps2) {
  return known.level_m == level_m && known.data->density_kgpm3 == density_kgpm3 &&
         known.data->gravity_mps2 == gravity_mps2 && known.hull.faces == hull.faces &&
         known.hull.positions_m == hull.positions_m;
}

}  // namespace

std::shared_ptr<const HydrodynamicData> built_in_data(const FloatingBody& body, double density_kgpm3,
                                                      double gravity_mps2) {
  static std::mutex mutex;
  static std::deque<KnownHull> known;
  const double level_m = level_that_displaces(body.hull, body.mass_kg / density_kgpm3, body.name.c_str());
  const std::lock_guard lock(mutex);
  const auto found = std::ranges::find_if(known, [&](const KnownHull& each) {
    return is_same(each, body.hull, level_m, density_kgpm3, gravity_mps2);
  });
  if (found != known.end()) return found->data;
  // About a point that does not depend on how the hull is loaded.
  auto data = std::make_shared<const HydrodynamicData>(
      panel_method(body.hull, level_m, {0.0, level_m, 0.0}, density_kgpm3, gravity_mps2));
  if (!is_finite(*data)) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: the panel method finds no finite added mass for its hull", body.name),
                "check the mesh with offing-mesh check, or name a file in body.hydrodynamics");
  }
  if (known.size() == most_kept) known.pop_front();
  known.push_back({.hull = body.hull, .level_m = level_m, .data = data});
  return data;
}

}  // namespace offing::bodies
