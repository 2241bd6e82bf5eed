#include "host/cli/query_text.h"

#include <array>
#include <iterator>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace offing::cli {

namespace {

constexpr std::array<std::string_view, 12> columns = {"time_s",
                                                      "x_m",
                                                      "z_m",
                                                      "height_m",
                                                      "normal_x",
                                                      "normal_y",
                                                      "normal_z",
                                                      "velocity_x_mps",
                                                      "velocity_y_mps",
                                                      "velocity_z_mps",
                                                      "pressure_pa",
                                                      "residual_m"};

std::array<double, 12> values_of(const QueryAnswer& answer) {
  const ocean::WaterSample& sample = answer.sample;
  const auto [x, y, z] = ocean::normal_of(sample);
  return {answer.time_s,
          answer.point.x_m,
          answer.point.z_m,
          sample.height_m,
          x,
          y,
          z,
          sample.velocity_x_mps,
          sample.velocity_y_mps,
          sample.velocity_z_mps,
          sample.pressure_pa,
          sample.residual_m};
}

}  // namespace

std::string csv_header() {
  return fmt::format("{}\n", fmt::join(columns, ","));
}

void append_csv(const QueryAnswer& answer, std::string& text) {
  const std::array<double, 12> values = values_of(answer);
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "{:.10g},{:.12g},{:.12g}", values[0], values[1], values[2]);
  for (std::size_t i = 3; i < values.size(); ++i) {
    fmt::format_to(out, ",{:.7g}", values[i]);
  }
  text += '\n';
}

nlohmann::ordered_json to_json(const QueryAnswer& answer) {
  const ocean::WaterSample& sample = answer.sample;
  return {{"time_s", answer.time_s},
          {"x_m", answer.point.x_m},
          {"z_m", answer.point.z_m},
          {"height_m", sample.height_m},
          {"normal", ocean::normal_of(sample)},
          {"velocity_mps", {sample.velocity_x_mps, sample.velocity_y_mps, sample.velocity_z_mps}},
          {"pressure_pa", sample.pressure_pa},
          {"residual_m", sample.residual_m}};
}

std::string query_text(const QueryAnswer& answer, double depth_m) {
  const ocean::WaterSample& sample = answer.sample;
  const auto [x, y, z] = ocean::normal_of(sample);
  return fmt::format(
      "at x {:g} m, z {:g} m, {:g} s\n"
      "  height    {:.4f} m\n"
      "  normal    {:.4f} {:.4f} {:.4f} (x, y up, z)\n"
      "  velocity  {:.4f} {:.4f} {:.4f} m/s, {:g} m below the surface\n"
      "  pressure  {:.1f} Pa, there\n"
      "  residual  {:.2g} m\n",
      answer.point.x_m, answer.point.z_m, answer.time_s, sample.height_m, x, y, z, sample.velocity_x_mps,
      sample.velocity_y_mps, sample.velocity_z_mps, depth_m, sample.pressure_pa, sample.residual_m);
}

}  // namespace offing::cli
