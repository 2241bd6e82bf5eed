#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "host/ocean/query/water_query.h"

namespace offing::cli {

/// One answer of a query.
struct QueryAnswer {
  double time_s = 0.0;
  ocean::WaterPoint point;
  ocean::WaterSample sample{};
};

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
