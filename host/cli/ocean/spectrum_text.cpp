#include "host/cli/ocean/spectrum_text.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include <fmt/format.h>

namespace offing::cli {

namespace {

/// Mean direction of travel at one frequency, from the first circular moment of its spreading.
std::optional<double> row_direction_rad(const WaveSpectrum& record, std::size_t row) {
  if (!record.is_directional() || record.energy[row] <= 0.0) {
    return std::nullopt;
  }
  const std::size_t count = record.directions_rad.size();
  double cosine = 0.0;
  double sine = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    cosine += record.spreading[row * count + i] * std::cos(record.directions_rad[i]);
    sine += record.spreading[row * count + i] * std::sin(record.directions_rad[i]);
  }
  return std::atan2(sine, cosine);
}

}  // namespace

std::string spectrum_text(const WaveSpectrum& record, const ocean::SeaState& state, DirectionStyle style) {
  constexpr double bar_width = 40.0;
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "{}{}{}\n", record.station.empty() ? "" : record.station + "  ", record.time_utc,
                 record.depth_m ? fmt::format("  depth {:.4g} m", *record.depth_m) : "");
  fmt::format_to(out, "Hs {:.3f} m  Tp {:.2f} s  Tm01 {:.2f} s  Tm02 {:.2f} s", state.hs_m, state.tp_s,
                 state.tm01_s, state.tm02_s);
  if (record.is_directional() && state.m0_m2 > 0.0) {
    fmt::format_to(out, "  mean {:.1f} {}", direction_deg(state.mean_direction_rad, style),
                   direction_unit(style));
  }
  fmt::format_to(out, "\n\n{:>8}  {:>10}  {:>11}\n", "Hz", "m^2/Hz", direction_unit(style));
  const double largest = *std::max_element(record.energy.begin(), record.energy.end());
  for (std::size_t i = 0; i < record.frequencies_hz.size(); ++i) {
    const auto direction_rad = row_direction_rad(record, i);
    const double share = largest > 0.0 ? record.energy[i] / largest : 0.0;
    fmt::format_to(out, "{:>8.4f}  {:>10.4g}  {:>11}  {}\n", record.frequencies_hz[i], record.energy[i],
                   direction_rad ? fmt::format("{:.0f}", direction_deg(*direction_rad, style)) : "-",
                   std::string(static_cast<std::size_t>(std::lround(bar_width * share)), '#'));
  }
  return fmt::to_string(text);
}

}  // namespace offing::cli
