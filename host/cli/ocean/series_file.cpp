#include "host/cli/ocean/series_file.h"

#include <array>
#include <span>

#include <fmt/format.h>

#include "host/io/module.h"
#include "host/io/spectra/netcdf_module.h"
#include "host/scene/file/version.h"

namespace offing::cli {
namespace {

using spectra::NetcdfLayout;

constexpr std::size_t time_dimension = 0, point_dimension = 1;

std::vector<NetcdfLayout::Text> attributes_of(const AnswerColumn& column) {
  std::vector<NetcdfLayout::Text> attributes{{"units", std::string(column.unit)},
                                             {"long_name", std::string(column.meaning)}};
  if (!column.standard_name.empty())
    attributes.push_back({"standard_name", std::string(column.standard_name)});
  return attributes;
}

NetcdfLayout layout_of(const SeriesFile::Facts& facts) {
  const std::span<const AnswerColumn> columns = answer_columns();
  NetcdfLayout layout;
  layout.attributes = {
      {"Conventions", "CF-1.8"},
      {"featureType", "timeSeries"},
      {"title", "Water at points"},
      {"source", fmt::format("Offing {}", scene::version())},
      {"comment",
       fmt::format(
           "x points east, y up and z south; velocity, pressure and acceleration are those {:g} m below the "
           "moving surface; waves shorter than {:g} m are left out",
           facts.depth_m, facts.min_wavelength_m)},
      {"scene_hash", facts.scene_hash}};
  layout.dimensions = {{"time", 0}, {"point", facts.points}};
  for (std::size_t i = 0; i < columns.size(); ++i) {
    NetcdfLayout::Variable variable{
        std::string(columns[i].name), NetcdfLayout::Type::float32, {}, attributes_of(columns[i])};
    if (i == 0) {
      // The name of its dimension makes it that dimension's coordinate.
      variable.name = "time";
      variable.dimensions = {time_dimension};
      variable.attributes = {{"units", "seconds since " + facts.time_origin},
                             {"calendar", "proleptic_gregorian"},
                             {"standard_name", "time"},
                             {"axis", "T"},
                             {"long_name", "time of the sea"}};
    } else if (i < place_columns) {
      variable.dimensions = {point_dimension};
    } else {
      variable.dimensions = {time_dimension, point_dimension};
      variable.attributes.push_back({"coordinates", "x_m z_m"});
    }
    if (i < place_columns) variable.type = NetcdfLayout::Type::float64;
    layout.variables.push_back(std::move(variable));
  }
  layout.variables.push_back({"point",
                              NetcdfLayout::Type::int32,
                              {point_dimension},
                              {{"cf_role", "timeseries_id"}, {"long_name", "index of the point"}}});
  return layout;
}

}  // namespace

SeriesFile::SeriesFile(const std::string& path, Existing existing, const Facts& facts)
    : points_(facts.points), columns_(answer_columns().size()), file_(path, existing) {
  output_ = module_functions<spectra::NetcdfModule>("netcdf", "write NetCDF series")
                .create(file_.temporary(), layout_of(facts), path);
}

void SeriesFile::add(const QueryAnswer& answer) {
  const std::span<const AnswerColumn> columns = answer_columns();
  for (std::size_t i = 0; i < columns.size(); ++i) columns_[i].push_back(columns[i].value(answer));
}

void SeriesFile::flush() {
  const std::size_t count = columns_.front().size();
  if (count == 0) return;
  const std::size_t time = first_ / points_, point = first_ % points_;
  const std::size_t one = 1;
  const std::array<std::size_t, 2> start{time, point}, counts{1, count};
  if (point == 0) output_->put(0, {&time, 1}, {&one, 1}, std::span(columns_.front()).first(1));
  if (time == 0) {
    for (std::size_t i = 1; i < place_columns; ++i) output_->put(i, {&point, 1}, {&count, 1}, columns_[i]);
    std::vector<double> indices;
    for (std::size_t i = 0; i < count; ++i) indices.push_back(static_cast<double>(point + i));
    output_->put(columns_.size(), {&point, 1}, {&count, 1}, indices);
  }
  for (std::size_t i = place_columns; i < columns_.size(); ++i) output_->put(i, start, counts, columns_[i]);
  for (std::vector<double>& column : columns_) column.clear();
  first_ += count;
}

void SeriesFile::finish() {
  flush();
  output_->close();
  file_.commit();
}

}  // namespace offing::cli
