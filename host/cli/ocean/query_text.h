#pragma once

#include <span>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "host/ocean/query/water_query.h"

namespace offing::cli {

/// One answer of a query.
struct QueryAnswer {
  double time_s = 0.0;
  ocean::WaterPoint point;
  ocean::WaterSample sample{};
};

/// A column of the answers, in CSV and as a variable of NetCDF.
struct AnswerColumn {
  std::string_view name;           ///< with its unit
  std::string_view unit;           ///< as UDUNITS has it
  std::string_view standard_name;  ///< of the CF conventions, empty where they have none
  std::string_view meaning;
  int digits;  ///< that CSV gives
  double (*value)(const QueryAnswer& answer);
};

/// Time, x and z of the point, then what was answered.
std::span<const AnswerColumn> answer_columns();
inline constexpr std::size_t place_columns = 3;

/// The double of the shortest decimals that give this float again, so that JSON has these alone; never -0.
double shortest_decimals(float value);

/// The names of the columns, with units.
std::string csv_header();
/// Appends a line.
void append_csv(const QueryAnswer& answer, std::string& text);

/// The same as an object, floats by the shortest decimals that give them again: "normal" and "velocity_mps"
/// are arrays of x, y and z, all else is a number with the name of its column.
nlohmann::ordered_json to_json(const QueryAnswer& answer);

/// For people.
std::string query_text(const QueryAnswer& answer, double depth_m);

}  // namespace offing::cli
