// The sea-state certificate, as a table and as JSON.
#include "host/cli/ocean/certificate_text.h"

#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/cli/ocean/cascade_text.h"

namespace offing::cli {
namespace {

nlohmann::json state_json(const ocean::SeaState& state, DirectionStyle style) {
  return {{"hs_m", state.hs_m},
          {"peak_period_s", state.peak_period_s},
          {"tp_s", state.tp_s},
          {"tm01_s", state.tm01_s},
          {"tm02_s", state.tm02_s},
          {"tz_s", state.tm02_s},
          {"mean_direction_deg", direction_deg(state.mean_direction_rad, style)},
          {"peak_direction_deg", direction_deg(state.peak_direction_rad, style)},
          {"spread_deg", state.spread_rad * degrees_per_radian},
          {"mss", state.mss}};
}

/// Means or spreads of the measured figures under the documented names.
nlohmann::json measured_json(const scene::Certificate& c, double scene::Measured::*part) {
  return {{"hs_m", c.hs_m.*part},
          {"peak_period_s", c.peak_period_s.*part},
          {"tp_s", c.tp_s.*part},
          {"tm01_s", c.tm01_s.*part},
          {"tm02_s", c.tm02_s.*part},
          {"tz_s", c.tm02_s.*part},
          {"spread_deg", c.spread_rad.*part * degrees_per_radian},
          {"mss", c.mss.*part},
          {"skewness", c.skewness.*part},
          {"kurtosis", c.kurtosis.*part},
          {"folded_share", c.folded_share.*part}};
}

struct Row {
  const char* name;
  const char* unit;
  double asked;
  double resolved;
  double measured;
  double difference;  ///< measured - resolved
  double standard_error;
};

void append_row(fmt::memory_buffer& text, const Row& row) {
  const std::string sigma = row.standard_error > 0.0
                                ? fmt::format("{:+.1f}", row.difference / row.standard_error)
                                : std::string("-");
  const std::string error =
      row.standard_error > 0.0 ? fmt::format("{:.3g}", row.standard_error) : std::string("-");
  fmt::format_to(std::back_inserter(text), "  {:<15} {:>11} {:>10.4f} {:>10.4f} {:>10.4f} {:>9} {:>6}\n",
                 row.name, row.unit, row.asked, row.resolved, row.measured, error, sigma);
}

}  // namespace

std::string certificate_text(const scene::Certificate& c, const scene::Sea& sea, DirectionStyle style) {
  const double root = std::sqrt(static_cast<double>(c.seeds));
  // Figures without a theory of their own are judged by the scatter from seed to seed, once it is known well
  // enough.
  constexpr int fewest_seeds = 8;
  const auto observed = [&](const scene::Measured& figure) {
    return c.seeds < fewest_seeds ? 0.0 : figure.spread / root;
  };
  const double direction_error_deg = c.standard_error.mean_direction_rad * degrees_per_radian;

  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "Sea-state certificate: {} seed{} from {}, {} x {} samples per cascade\n\n", c.seeds,
                 c.seeds == 1 ? "" : "s", sea.parameters.seed, sea.parameters.size, sea.parameters.size);
  fmt::format_to(out, "  {:<15} {:>11} {:>10} {:>10} {:>10} {:>9} {:>6}\n", "", "", "asked", "resolved",
                 "measured", "std.error", "sigma");
  append_row(text, {"Hs", "m", c.asked.hs_m, c.resolved.hs_m, c.hs_m.mean, c.hs_m.mean - c.resolved.hs_m,
                    c.standard_error.hs_m});
  append_row(text, {"peak period", "s", c.asked.peak_period_s, c.resolved.peak_period_s, c.peak_period_s.mean,
                    c.peak_period_s.mean - c.resolved.peak_period_s, c.standard_error.peak_period_s});
  append_row(text, {"Tp of E^4", "s", c.asked.tp_s, c.resolved.tp_s, c.tp_s.mean,
                    c.tp_s.mean - c.resolved.tp_s, observed(c.tp_s)});
  append_row(text, {"Tm01", "s", c.asked.tm01_s, c.resolved.tm01_s, c.tm01_s.mean,
                    c.tm01_s.mean - c.resolved.tm01_s, observed(c.tm01_s)});
  append_row(text, {"Tz = Tm02", "s", c.asked.tm02_s, c.resolved.tm02_s, c.tm02_s.mean,
                    c.tm02_s.mean - c.resolved.tm02_s, c.standard_error.tm02_s});
  append_row(text, {"mean direction", direction_unit(style), direction_deg(c.asked.mean_direction_rad, style),
                    direction_deg(c.resolved.mean_direction_rad, style),
                    direction_deg(c.mean_direction_rad.mean, style),
                    degrees_per_radian *
                        direction_difference_rad(c.mean_direction_rad.mean, c.resolved.mean_direction_rad),
                    direction_error_deg});
  append_row(text, {"peak direction", direction_unit(style), direction_deg(c.asked.peak_direction_rad, style),
                    direction_deg(c.resolved.peak_direction_rad, style),
                    direction_deg(c.peak_direction_rad.mean, style),
                    degrees_per_radian *
                        direction_difference_rad(c.peak_direction_rad.mean, c.resolved.peak_direction_rad),
                    degrees_per_radian * observed(c.peak_direction_rad)});
  append_row(text, {"spread", "deg", c.asked.spread_rad * degrees_per_radian,
                    c.resolved.spread_rad * degrees_per_radian, c.spread_rad.mean * degrees_per_radian,
                    (c.spread_rad.mean - c.resolved.spread_rad) * degrees_per_radian,
                    degrees_per_radian * observed(c.spread_rad)});
  append_row(text, {"mss", "", c.asked.mss, c.resolved.mss, c.mss.mean, c.mss.mean - c.resolved.mss,
                    observed(c.mss)});
  append_row(text, {"foam cover", "%", 100.0 * c.foam_fraction_asked, 100.0 * c.foam_onset.fraction,
                    100.0 * c.foam_fraction.mean, 100.0 * (c.foam_fraction.mean - c.foam_onset.fraction),
                    100.0 * observed(c.foam_fraction)});
  fmt::format_to(out, "\n  skewness {:.3f}, kurtosis {:.3f}, folded share {:.2e}, max ka {:.3f}\n\n",
                 c.skewness.mean, c.kurtosis.mean, c.folded_share.mean, c.max_ka);
  fmt::format_to(out, "{}\n", cascade_text(sea, c.energy));
  if (!sea.swells.empty()) {
    fmt::format_to(
        out,
        "Single swells in addition to the spectrum: {}, {:.4g} m^2; resolved and measured include them.\n\n",
        sea.swells.size(), c.swell_m0_m2);
  }
  fmt::format_to(
      out,
      "asked: the whole spectrum. resolved: the part of it that the grids can hold. measured: the surface,\n"
      "mean over the seeds. sigma: (measured - resolved) / standard error.\n"
      "peak period: where the energy density E(f) is largest. Tp of E^4: integral of E^4 over that of f "
      "E^4.\n"
      "peak direction: of the waves at the peak period. spread: standard deviation of directions.\n"
      "mss: mean square slope. foam cover: share of the sea.\n"
      "Waves are linear: before the horizontal displacement the elevation is Gaussian, with no skewness.\n"
      "The horizontal displacement alone sharpens crests.\n");
  return fmt::to_string(text);
}

nlohmann::json certificate_json(const scene::Certificate& c, const scene::Sea& sea, DirectionStyle style) {
  nlohmann::json json;
  json["asked"] = state_json(c.asked, style);
  json["resolved"] = state_json(c.resolved, style);
  json["measured"] = measured_json(c, &scene::Measured::mean);
  json["measured"]["mean_direction_deg"] = direction_deg(c.mean_direction_rad.mean, style);
  json["measured"]["peak_direction_deg"] = direction_deg(c.peak_direction_rad.mean, style);
  json["measured"]["max_ka"] = c.max_ka;
  json["spread"] = measured_json(c, &scene::Measured::spread);
  json["spread"]["mean_direction_deg"] = c.mean_direction_rad.spread * degrees_per_radian;
  json["spread"]["peak_direction_deg"] = c.peak_direction_rad.spread * degrees_per_radian;
  json["standard_error"] = {{"hs_m", c.standard_error.hs_m},
                            {"peak_period_s", c.standard_error.peak_period_s},
                            {"tm02_s", c.standard_error.tm02_s},
                            {"mean_direction_deg", c.standard_error.mean_direction_rad * degrees_per_radian}};
  json["seeds"] = c.seeds;
  json["m0_m2"] = c.energy.m0_m2;
  json["out_of_band_m2"] = c.energy.out_of_band_m2;
  if (sea.gerstner_choice) {
    json["gerstner"] = {{"count", sea.gerstner_choice->count},
                        {"k_split_radpm", sea.gerstner_choice->split_radpm},
                        {"spectrum_m0_m2", c.energy.gerstner_m0_m2}};
  }
  json["foam"] = {{"asked", c.foam_fraction_asked},
                  {"measured", c.foam_fraction.mean},
                  {"spread", c.foam_fraction.spread},
                  {"onset_jacobian", c.foam_onset.jacobian},
                  {"width", c.foam_onset.width}};
  if (!sea.swells.empty()) {
    json["swells"] = {{"count", sea.swells.size()}, {"m0_m2", c.swell_m0_m2}};
  }
  json["cascades"] = nlohmann::json::array();
  for (std::size_t i = 0; i < sea.parameters.cascades.size(); ++i) {
    const ocean::Cascade& cascade = sea.parameters.cascades[i];
    json["cascades"].push_back({{"patch_m", cascade.patch_length_m},
                                {"k_min_radpm", cascade.k_min_radpm},
                                {"k_max_radpm", cascade.k_max_radpm},
                                {"spectrum_m0_m2", c.energy.cascade_m0_m2[i]},
                                {"expected_m0_m2", c.expected_cascade_m0_m2[i]},
                                {"measured_m0_m2", c.measured_cascade_m0_m2[i]}});
  }
  return json;
}

}  // namespace offing::cli
