#include "host/terrain/analysis/earth_curve.h"

#include <fmt/format.h>

#include "host/base/error.h"

namespace offing::terrain {

void require_valid(const EarthCurve& curve) {
  if (!(curve.radius_m >= 1000.0)) {
    throw Error(ErrorKind::bad_input,
                fmt::format("earth curve: radius_m: expected at least 1000, found {:g}", curve.radius_m),
                "give the planet's radius in metres, infinity for flat ground");
  }
  if (!(curve.refraction >= 0.0 && curve.refraction <= 1.0)) {
    throw Error(ErrorKind::bad_input,
                fmt::format("earth curve: refraction: expected 0 ... 1, found {:g}", curve.refraction),
                "0.13 is usual near the ground");
  }
}

}  // namespace offing::terrain
