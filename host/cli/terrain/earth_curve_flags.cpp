#include "host/cli/terrain/earth_curve_flags.h"

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
  if (!are_given()) return {};
  terrain::EarthCurve curve{terrain::earth_radius_m, terrain::light_refraction};
  if (!refraction_.empty()) {
    curve.refraction = read_number("--refraction", refraction_, "", 0.0, 1.0, "0.13");
  }
  return curve;
}

}  // namespace offing::cli
