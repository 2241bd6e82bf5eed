// The energy of a sea in its cascades, as a table.
#include "host/cli/ocean/cascade_text.h"

#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>

#include <fmt/format.h>

namespace offing::cli {

std::string cascade_text(const scene::Sea& sea, const scene::EnergyShares& energy) {
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  const auto percent = [&](double m2) { return energy.m0_m2 > 0.0 ? 100.0 * m2 / energy.m0_m2 : 0.0; };
  fmt::format_to(out, "cascade  patch m  spacing m    wavelengths m        energy m^2   share\n");
  if (sea.gerstner_choice) {
    fmt::format_to(out, "{:<7}  {:>18}  {:>8.4g} ... {:<8}  {:>10.4g}  {:>5.2f} %\n", "gerstner",
                   fmt::format("{} waves", sea.gerstner_choice->count),
                   2.0 * std::numbers::pi / sea.gerstner_choice->split_radpm, "", energy.gerstner_m0_m2,
                   percent(energy.gerstner_m0_m2));
  }
  for (std::size_t i = 0; i < sea.parameters.cascades.size(); ++i) {
    const ocean::Cascade& cascade = sea.parameters.cascades[i];
    const double shortest_m = 2.0 * std::numbers::pi / cascade.k_max_radpm;
    const double longest_m =
        cascade.k_min_radpm > 0.0 ? 2.0 * std::numbers::pi / cascade.k_min_radpm : cascade.patch_length_m;
    fmt::format_to(out, "c{:<6}  {:>7.5g}  {:>9.4g}  {:>8.4g} ... {:<8.4g}  {:>10.4g}  {:>5.2f} %\n", i,
                   cascade.patch_length_m, cascade.patch_length_m / sea.parameters.size, shortest_m,
                   longest_m, energy.cascade_m0_m2[i], percent(energy.cascade_m0_m2[i]));
  }
  fmt::format_to(out, "{:<52}  {:>10.4g}  {:>5.2f} %\n", "out of band", energy.out_of_band_m2,
                 percent(energy.out_of_band_m2));
  fmt::format_to(out, "{:<52}  {:>10.4g}  Hs {:.3f} m\n", "m0 of the spectrum", energy.m0_m2,
                 4.0 * std::sqrt(energy.m0_m2));
  return fmt::to_string(text);
}

}  // namespace offing::cli
