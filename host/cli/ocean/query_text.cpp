#include "host/cli/ocean/query_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

namespace offing::cli {

namespace {

/// Component of the unit normal.
template <std::size_t axis>
double normal(const QueryAnswer& answer) {
  return ocean::normal_of(answer.sample)[axis];
}

/// A number of the sample.
template <float ocean::WaterSample::*field>
double sampled(const QueryAnswer& answer) {
  return answer.sample.*field;
}

using Sample = ocean::WaterSample;
constexpr std::array<AnswerColumn, 16> columns{{
    {"time_s", "s", "time", "time of the sea", 10, [](const QueryAnswer& answer) { return answer.time_s; }},
    {"x_m", "m", "", "distance of the point east of the origin", 12,
     [](const QueryAnswer& answer) { return answer.point.x_m; }},
    {"z_m", "m", "", "distance of the point south of the origin", 12,
     [](const QueryAnswer& answer) { return answer.point.z_m; }},
    {"height_m", "m", "sea_surface_height_above_mean_sea_level", "height of the surface", 7,
     sampled<&Sample::height_m>},
    {"normal_x", "1", "", "unit normal of the surface, east", 7, normal<0>},
    {"normal_y", "1", "", "unit normal of the surface, up", 7, normal<1>},
    {"normal_z", "1", "", "unit normal of the surface, south", 7, normal<2>},
    {"velocity_x_mps", "m s-1", "eastward_sea_water_velocity", "velocity of the water, east", 7,
     sampled<&Sample::velocity_x_mps>},
    {"velocity_y_mps", "m s-1", "upward_sea_water_velocity", "velocity of the water, up", 7,
     sampled<&Sample::velocity_y_mps>},
    {"velocity_z_mps", "m s-1", "", "velocity of the water, south", 7, sampled<&Sample::velocity_z_mps>},
    {"pressure_pa", "Pa", "sea_water_pressure_due_to_sea_water", "pressure relative to the air", 7,
     sampled<&Sample::pressure_pa>},
    {"residual_m", "m", "", "horizontal distance of the sample from the point", 7,
     sampled<&Sample::residual_m>},
    {"acceleration_x_mps2", "m s-2", "", "rate of the velocity where the water is at rest, east", 7,
     sampled<&Sample::acceleration_x_mps2>},
    {"acceleration_y_mps2", "m s-2", "", "rate of the velocity where the water is at rest, up", 7,
     sampled<&Sample::acceleration_y_mps2>},
    {"acceleration_z_mps2", "m s-2", "", "rate of the velocity where the water is at rest, south", 7,
     sampled<&Sample::acceleration_z_mps2>},
    {"error_rms_m", "m", "", "expected error of the height, root mean square", 7,
     sampled<&Sample::error_rms_m>},
}};

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

std::span<const AnswerColumn> answer_columns() {
  return columns;
}

std::string csv_header() {
  std::string text;
  for (const AnswerColumn& column : columns)
    text += fmt::format("{}{}", text.empty() ? "" : ",", column.name);
  return text + '\n';
}

void append_csv(const QueryAnswer& answer, std::string& text) {
  const auto out = std::back_inserter(text);
  for (const AnswerColumn& column : columns) {
    const double value = column.value(answer) + 0.0;  // -0 becomes 0
    fmt::format_to(out, "{}{:.{}g}", &column == columns.data() ? "" : ",", value, column.digits);
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
      "  velocity  {} m/s, {}\n"
      "  pressure  {} Pa, there\n"
      "  acceleration  {} m/s^2, there\n"
      "  residual  {}\n"
      "  expected error  {:.2g} m\n",
      answer.point.x_m, answer.point.z_m, answer.time_s, fixed_text(sample.height_m, 4), vector(x, y, z),
      vector(sample.velocity_x_mps, sample.velocity_y_mps, sample.velocity_z_mps),
      depth_m == 0.0 ? "at the surface" : fmt::format("{:g} m below the surface", depth_m),
      fixed_text(sample.pressure_pa, 1),
      vector(sample.acceleration_x_mps2, sample.acceleration_y_mps2, sample.acceleration_z_mps2),
      std::isfinite(sample.residual_m) ? fmt::format("{:.2g} m", sample.residual_m)
                                       : "unknown: the search found no water under folded crests",
      sample.error_rms_m);
}

}  // namespace offing::cli
