#include "host/cli/terrain/earth_curve_flags.h"

#include <CLI/App.hpp>

namespace offing::cli {

void EarthCurveFlags::add_to(CLI::App& command) {
  command.add_flag("--curvature", is_curved_,
                   "include the Earth's curvature and atmospheric refraction (default: flat Earth)");
  options_.add_to(command, {{&Settings::refraction,
                             {.key = "refraction",
                              .low = 0.0,
                              .high = 1.0,
                              .help = "refraction coefficient: the Earth's radius divided by the radius of "
                                      "curvature of a light ray; implies --curvature"}}});
}

terrain::EarthCurve EarthCurveFlags::read() const {
  if (!are_given()) return {};
  return {terrain::earth_radius_m, options_.read().refraction};
}

}  // namespace offing::cli
