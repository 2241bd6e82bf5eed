#include "host/cli/ocean/query_text.h"

#include <array>
#include <charconv>
#include <iterator>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace offing::cli {

namespace {

constexpr std::array<std::string_view, 16> columns = {"time_s",
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
                                                      "residual_m",
                                                      "acceleration_x_mps2",
                                                      "acceleration_y_mps2",
                                                      "acceleration_z_mps2",
                                                      "error_rms_m"};

std::array<double, columns.size()> values_of(const QueryAnswer& answer) {
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
          sample.residual_m,
          sample.acceleration_x_mps2,
          sample.acceleration_y_mps2,
          sample.acceleration_z_mps2,
          sample.error_rms_m};
}

/// As many decimals; what they do not tell from 0 has no sign.
std::string fixed_text(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  const bool is_zero = text.find_first_not_of("-0.") == std::string::npos;
  if (is_zero && text.starts_with('-')) text.erase(0, 1);
  return text;
}

}  // namespace

double shortest_decimals(float value) {
  std::array<char, 32> text{};
  const char* const end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  double number = 0.0;
  std::from_chars(text.data(), end, number);
  return number + 0.0;
}

std::string csv_header() {
  return fmt::format("{}\n", fmt::join(columns, ","));
}

void append_csv(const QueryAnswer& answer, std::string& text) {
  const auto values = values_of(answer);
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "{:.10g},{:.12g},{:.12g}", values[0], values[1], values[2]);
  for (std::size_t i = 3; i < values.size(); ++i) {
    fmt::format_to(out, ",{:.7g}", values[i] + 0.0);  // -0 becomes 0
  }
  text += '\n';
}

nlohmann::ordered_json to_json(const QueryAnswer& answer) {
  const ocean::WaterSample& sample = answer.sample;
  const auto [x, y, z] = ocean::normal_of(sample);
  return {{"time_s", answer.time_s},
          {"x_m", answer.point.x_m},
          {"z_m", answer.point.z_m},
          {"height_m", shortest_decimals(sample.height_m)},
          {"normal", {shortest_decimals(x), shortest_decimals(y), shortest_decimals(z)}},
          {"velocity_mps",
           {shortest_decimals(sample.velocity_x_mps), shortest_decimals(sample.velocity_y_mps),
            shortest_decimals(sample.velocity_z_mps)}},
          {"pressure_pa", shortest_decimals(sample.pressure_pa)},
          {"residual_m", shortest_decimals(sample.residual_m)},
          {"acceleration_mps2",
           {shortest_decimals(sample.acceleration_x_mps2), shortest_decimals(sample.acceleration_y_mps2),
            shortest_decimals(sample.acceleration_z_mps2)}},
          {"error_rms_m", shortest_decimals(sample.error_rms_m)}};
}

std::string query_text(const QueryAnswer& answer, double depth_m) {
  const ocean::WaterSample& sample = answer.sample;
  const auto [x, y, z] = ocean::normal_of(sample);
  const auto vector = [](float a, float b, float c) {
    return fmt::format("{} {} {}", fixed_text(a, 4), fixed_text(b, 4), fixed_text(c, 4));
  };
  return fmt::format(
      "at x {:g} m, z {:g} m, {:g} s\n"
      "  height    {} m\n"
      "  normal    {} (x, y up, z)\n"
      "  velocity  {} m/s, {:g} m below the surface\n"
      "  pressure  {} Pa, there\n"
      "  acceleration  {} m/s^2, there\n"
      "  residual  {:.2g} m\n"
      "  expected error  {:.2g} m\n",
      answer.point.x_m, answer.point.z_m, answer.time_s, fixed_text(sample.height_m, 4), vector(x, y, z),
      vector(sample.velocity_x_mps, sample.velocity_y_mps, sample.velocity_z_mps), depth_m,
      fixed_text(sample.pressure_pa, 1),
      vector(sample.acceleration_x_mps2, sample.acceleration_y_mps2, sample.acceleration_z_mps2),
      sample.residual_m, sample.error_rms_m);
}

}  // namespace offing::cli
