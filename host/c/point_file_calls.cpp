// Points of GIS files.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <variant>

#include <fmt/format.h>

#include "host/c/arrays.h"
#include "host/c/call.h"
#include "host/c/offing.h"
#include "host/io/height_maps/map_coordinates.h"
#include "host/io/height_maps/map_features.h"

using offing::Error;
using offing::ErrorKind;
using offing::c::require;
using offing::c::run;
using offing::c::write_values;

struct OffingPointFile {
  offing::FeatureTable features;
  std::string system;  // as offing_places_to_terrain() takes it
};

namespace {

double number_of(const offing::AttributeValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return *number;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

OffingStatus offing_open_point_file(const char* file, const char* layer, OffingPointFile** points) {
  return run([&] {
    require(file, "file");
    require(points, "points");
    offing::FeatureTable features =
        offing::read_features(file, offing::FeatureShape::points, layer == nullptr ? "" : layer);
    std::string system = features.is_lonlat ? offing::lonlat_places : features.coordinate_system;
    *points = new OffingPointFile{std::move(features), std::move(system)};
  });
}

void offing_free_point_file(OffingPointFile* points) {
  delete points;
}

OffingStatus offing_get_point_file_info(const OffingPointFile* points, OffingPointFileInfo* info) {
  return run([&] {
    require(points, "points");
    OffingPointFileInfo found{};
    found.count = points->features.count();
    found.attribute_count = points->features.columns.size();
    found.coordinate_system = points->system.c_str();
    found.layer = points->features.layer.c_str();
    offing::c::write_struct(info, "info", found);
  });
}

const char* offing_point_attribute_name(const OffingPointFile* points, size_t attribute) {
  if (points == nullptr || attribute >= points->features.columns.size()) return "";
  return points->features.columns[attribute].name.c_str();
}

OffingStatus offing_read_point_file(const OffingPointFile* points, double* places, double* z, size_t count) {
  return run([&] {
    require(points, "points");
    const offing::FeatureTable& features = points->features;
    offing::c::require_count("count", count, features.count());
    for (std::size_t i = 0; i < count; ++i) {
      const glm::dvec3& end = features.ends[i];
      write_values(places, i, {end.x, end.y});
      write_values(z, i, {features.is_raised[i] ? end.z : std::numeric_limits<double>::quiet_NaN()});
    }
  });
}

OffingStatus offing_read_point_attribute(const OffingPointFile* points, const char* name, double* values,
                                         size_t count) {
  return run([&] {
    require(points, "points");
    require(name, "name");
    const offing::FeatureTable& features = points->features;
    offing::c::require_count("count", count, features.count());
    const auto column = std::ranges::find(features.columns, name, &offing::AttributeColumn::name);
    if (column == features.columns.end()) {
      throw Error(ErrorKind::bad_usage,
                  fmt::format("{}: expected an attribute of the layer, got \"{}\"", features.name(), name),
                  "offing_point_attribute_name() lists them");
    }
    if (count == 0) return;
    require(values, "values");
    const auto index = static_cast<std::size_t>(column - features.columns.begin());
    for (std::size_t i = 0; i < count; ++i)
      values[i] = number_of(features.values[i * features.columns.size() + index]);
  });
}
