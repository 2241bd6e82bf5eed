#include "host/cli/earth_curve_flags.h"

#include <CLI/Option.hpp>

#include "host/base/argument.h"

namespace offing::cli {

void EarthCurveFlags::add_to(CLI::App& command) {
  command.add_flag("--curvature", is_curved_,
                   "heights fall away as the Earth curves, less what the air bends light (default: flat)");
  command
      .add_option(
          "--refraction", refraction_,
          "the Earth's radius over that of a ray of light, 0 ... 1; implies --curvature (default 0.13)")
      ->type_name("K");
}

terrain::EarthCurve EarthCurveFlags::read() const {
  if (!is_curved_ && refraction_.empty()) return {};
  terrain::EarthCurve curve{terrain::earth_radius_m, terrain::light_refraction};
  if (!refraction_.empty()) {
    curve.refraction = read_number("--refraction", refraction_, "", 0.0, 1.0, "0.13");
  }
  return curve;
}

std::vector<TerrainHit> cast(terrain::HeightField& field, std::span<const terrain::Ray> rays,
                             const terrain::EarthCurve& curve, terrain::HitNormals normals) {
  // Rays over flat ground need a kernel that is there already.
  return curve.bend_perm() == 0.0 ? field.cast(rays, terrain::CastMethod::parity, normals)
                                  : field.cast(rays, curve, normals);
}

}  // namespace offing::cli
