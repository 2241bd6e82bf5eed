#include "tests/sky/visible_spectrum.h"

#include <algorithm>

namespace offing::sky {
namespace {

// A bell of height 1 with a rate (1/nm) for each side.
double bell(double wavelength_nm, double peak_nm, double left_pnm, double right_pnm) {
  const double t = (wavelength_nm - peak_nm) * (wavelength_nm < peak_nm ? left_pnm : right_pnm);
  return std::exp(-0.5 * t * t);
}

}  // namespace

double at_wavelength(const std::array<double, bin_count>& bins, double wavelength_nm) {
  const double bin = std::clamp((wavelength_nm - first_bin_middle_nm) / 10.0, 0.0, bin_count - 1.0);
  const auto left = std::min(static_cast<std::size_t>(bin), bin_count - 2);
  return std::lerp(bins[left], bins[left + 1], bin - static_cast<double>(left));
}

Rgb rgb_of_wavelength(double nm) {
  const double x = 0.362 * bell(nm, 442.0, 0.0624, 0.0374) + 1.056 * bell(nm, 599.8, 0.0264, 0.0323) -
                   0.065 * bell(nm, 501.1, 0.0490, 0.0382);
  const double y = 0.821 * bell(nm, 568.8, 0.0213, 0.0247) + 0.286 * bell(nm, 530.9, 0.0613, 0.0322);
  const double z = 1.217 * bell(nm, 437.0, 0.0845, 0.0278) + 0.681 * bell(nm, 459.0, 0.0385, 0.0725);
  constexpr double klm_pw = 0.683;
  return {klm_pw * (3.2404542 * x - 1.5371385 * y - 0.4985314 * z),
          klm_pw * (-0.9692660 * x + 1.8760108 * y + 0.0415560 * z),
          klm_pw * (0.0556434 * x - 0.2040259 * y + 1.0572252 * z)};
}

}  // namespace offing::sky
