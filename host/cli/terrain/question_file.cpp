// Tables and GIS files of places: what they hold, as places on the map and numbers.
#include "host/cli/terrain/question_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/base/error.h"
#include "host/io/file_extension.h"

namespace offing::cli {
namespace {

// Of feet and of other units than metres too.
constexpr double farthest_coordinate = 1e9;

/// A table of text.
class TableQuestions : public QuestionFile {
 public:
  TableQuestions(const QuestionSource& source, PlaceSystem system, const QuestionColumns& columns)
      : QuestionFile(std::move(system), columns), table_(source.file, table_columns()) {}

 private:
  void read(std::size_t most, QuestionBlock& block) override {
    const std::vector<double> rows = table_.next(most);
    const std::size_t width = names().size(), all = width + optional().size();
    block.count = rows.size() / all;
    for (std::size_t i = 0; i < rows.size(); ++i)
      (i % all < width ? block.given : block.optional).push_back(rows[i]);
    block.place_of = [this](std::size_t row) { return table_.place_of(row); };
  }

  NumberTable table_;
};

/// A layer of a GIS file.
class FeatureQuestions : public QuestionFile {
 public:
  FeatureQuestions(FeatureTable features, PlaceSystem system, const QuestionColumns& columns)
      : QuestionFile(std::move(system), columns), features_(std::move(features)) {
    attributes_.resize(names().size(), none);
    for (std::size_t i = 0; i < features_.columns.size(); ++i) {
      const auto name = std::ranges::find(names(), features_.columns[i].name);
      const auto column = static_cast<std::size_t>(name - names().begin());
      if (name != names().end() && !is_coordinate(column)) {
        attributes_[column] = i;
      } else {
        carried_.push_back(features_.columns[i]);
        carried_attributes_.push_back(i);
      }
    }
    const bool has_height = features_.has_heights && shape() == FeatureShape::points;
    for (std::size_t column = 0; column < names().size(); ++column) {
      if (is_coordinate(column) || attributes_[column] != none) continue;
      if (has_height && (names()[column] == "height_m" || names()[column] == "y_m")) continue;
      throw Error(
          ErrorKind::bad_input,
          fmt::format("{}: expected an attribute \"{}\", found none", features_.name(), names()[column]),
          fmt::format("add a field {} of numbers to the layer", names()[column]));
    }
  }

 private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  double number_of(std::size_t feature, std::size_t column) const {
    if (attributes_[column] == none) {
      if (!features_.is_raised[feature]) {
        throw Error(ErrorKind::bad_input,
                    fmt::format("{}: expected a point with a z, as others have, found one without",
                                features_.place_of(feature)),
                    fmt::format("give all points a z, or none and a field {}", names()[column]));
      }
      return bounded(features_.ends[feature * ends_of(shape())].z, feature, "z");
    }
    return number_of(feature, attributes_[column], names()[column]);
  }

  /// As numbers of tables are.
  double bounded(double number, std::size_t feature, const std::string& name) const {
    if (std::abs(number) <= farthest_coordinate) return number;
    throw Error(
        ErrorKind::bad_input,
        fmt::format("{}: {}: expected a number within [{:g}, {:g}], found {:g}", features_.place_of(feature),
                    name, -farthest_coordinate, farthest_coordinate, number),
        "correct the feature, or leave it out");
  }

  double number_of(std::size_t feature, std::size_t attribute, const std::string& name) const {
    const AttributeValue& value = features_.values[feature * features_.columns.size() + attribute];
    if (const auto* number = std::get_if<double>(&value); number != nullptr && std::isfinite(*number))
      return bounded(*number, feature, name);
    if (const auto* whole = std::get_if<std::int64_t>(&value))
      return bounded(static_cast<double>(*whole), feature, name);
    const auto* text = std::get_if<std::string>(&value);
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected a number as its \"{}\", found {}", features_.place_of(feature),
                            name, text == nullptr ? "none" : printable(*text)),
                "fill in the field, or leave the feature out");
  }

  /// NaN where the layer has no such attribute, or the feature no value of it.
  double optional_of(std::size_t feature, const std::string& name) const {
    const auto column = std::ranges::find(features_.columns, name, &AttributeColumn::name);
    const auto attribute = static_cast<std::size_t>(column - features_.columns.begin());
    if (column == features_.columns.end() ||
        std::holds_alternative<std::monostate>(
            features_.values[feature * features_.columns.size() + attribute])) {
      return std::numeric_limits<double>::quiet_NaN();
    }
    return number_of(feature, attribute, name);
  }

  void read(std::size_t most, QuestionBlock& block) override {
    const std::size_t first = next_, ends = ends_of(shape());
    block.count = std::min(most, features_.count() - first);
    next_ += block.count;
    for (std::size_t feature = first; feature < next_; ++feature) {
      std::size_t coordinate = 0;
      for (std::size_t column = 0; column < names().size(); ++column) {
        if (!is_coordinate(column)) {
          block.given.push_back(number_of(feature, column));
          continue;
        }
        const glm::dvec3& end = features_.ends[feature * ends + coordinate / 2];
        block.given.push_back(bounded(coordinate % 2 == 0 ? end.x : end.y, feature, names()[column]));
        ++coordinate;
      }
      for (const std::string& name : optional()) block.optional.push_back(optional_of(feature, name));
      for (const std::size_t attribute : carried_attributes_)
        block.carried.push_back(features_.values[feature * features_.columns.size() + attribute]);
    }
    block.place_of = [this, first](std::size_t row) { return features_.place_of(first + row); };
  }

  FeatureTable features_;
  std::vector<std::size_t> attributes_;  // of each column, or none
  std::vector<std::size_t> carried_attributes_;
  std::size_t next_ = 0;
};

/// The system that a layer's places are in.
PlaceSystem system_of(const FeatureTable& features, const MapFrame& map, const std::string& crs) {
  const std::string layer = features.name();
  const bool names_one = !features.coordinate_system.empty();
  if (names_one && crs != local_places) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("--crs: expected none, because {} names a coordinate system, found {}", layer,
                            printable(crs)),
                "leave --crs out, or give the layer another system with ogr2ogr -t_srs");
  }
  if (!names_one && crs == local_places) {
    throw Error(ErrorKind::bad_input, fmt::format("{}: expected a coordinate system, found none", layer),
                "write --crs map for the map's own, or give the layer one with ogr2ogr -a_srs EPSG:CODE");
  }
  if (!names_one) return {map, crs};
  return {map, features.is_lonlat ? lonlat_places : features.coordinate_system, layer};
}

}  // namespace

QuestionFile::QuestionFile(PlaceSystem system, QuestionColumns columns)
    : system_(std::move(system)), columns_(std::move(columns)) {
  const std::vector<std::string>& local = columns_.numbers.names;
  const auto add = [&](const std::string& name, std::size_t of_local, bool is_coordinate) {
    names_.push_back(name);
    of_local_.push_back(of_local);
    is_coordinate_.push_back(is_coordinate);
  };
  for (std::size_t i = 0; i < local.size(); ++i) {
    const auto place =
        std::ranges::find_if(columns_.places, [i](const PlaceColumns& p) { return p.x == i || p.z == i; });
    const bool is_coordinate = place != columns_.places.end();
    if (system_.is_local()) {
      add(local[i], i, is_coordinate);
    } else if (!is_coordinate) {
      // A height that is an axis of local places comes last of others.
      add(local[i] == "y_m" ? "height_m" : local[i], i, false);
    } else if (place->x == i) {
      add(place->prefix + system_.first(), i, true);
      add(place->prefix + system_.second(), place->z, true);
    }
  }
}

FeatureShape QuestionFile::shape() const {
  return columns_.places.size() == 1 ? FeatureShape::points : FeatureShape::lines;
}

NumberColumns QuestionFile::table_columns() const {
  NumberColumns columns = columns_.numbers;
  if (system_.is_local()) return columns;
  columns.names = names_;
  columns.meaning =
      columns.meaning.substr(0, columns.meaning.find(',')) + ", with places in the system of --crs";
  std::vector<std::string> example;
  const bool is_lonlat = system_.name() == lonlat_places;
  bool is_first = true;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    example.emplace_back(!is_coordinate_[i] ? "1"
                         : is_first         ? is_lonlat ? "-70.5" : "372500"
                         : is_lonlat        ? "-32.5"
                                            : "6400000");
    if (is_coordinate_[i]) is_first = !is_first;
  }
  columns.example = fmt::format("{}", fmt::join(example, ","));
  columns.farthest = farthest_coordinate;
  return columns;
}

QuestionBlock QuestionFile::next(std::size_t most) {
  QuestionBlock block;
  read(most, block);
  const std::size_t width = names_.size(), places = columns_.places.size();
  block.rows.resize(block.given.size());
  for (std::size_t row = 0; row < block.count; ++row) {
    for (std::size_t i = 0; i < width; ++i)
      block.rows[row * width + of_local_[i]] = block.given[row * width + i];
  }
  block.ends.resize(block.count * places);
  for (std::size_t p = 0; p < places; ++p) {
    const PlaceColumns& place = columns_.places[p];
    std::vector<glm::dvec2> coordinates;
    for (std::size_t row = 0; row < block.count; ++row) {
      coordinates.emplace_back(block.rows[row * width + place.x], block.rows[row * width + place.z]);
      block.ends[row * places + p] = glm::dvec3(coordinates.back(), 0.0);
    }
    coordinates = place.is_on_map ? system_.within_map(block.place_of, coordinates)
                                  : system_.on_map(block.place_of, coordinates);
    for (std::size_t row = 0; row < block.count; ++row) {
      block.rows[row * width + place.x] = coordinates[row].x;
      block.rows[row * width + place.z] = coordinates[row].y;
    }
  }
  return block;
}

std::unique_ptr<QuestionFile> open_questions(const QuestionSource& source, const MapFrame& map,
                                             const std::string& crs, const QuestionColumns& columns) {
  if (!is_feature_file(source.file)) {
    if (!source.layer.empty()) {
      throw Error(ErrorKind::bad_usage,
                  fmt::format("--layer: expected a GeoPackage or a GeoJSON as --points, found {}",
                              one_line(source.file)),
                  "leave --layer out");
    }
    if (is_vector_name(source.file)) {
      const std::string package = std::filesystem::path(source.file).filename().replace_extension(".gpkg");
      throw Error(ErrorKind::bad_input,
                  fmt::format("{}: expected a GeoPackage, a GeoJSON or CSV, found {}", one_line(source.file),
                              lower_extension(source.file)),
                  fmt::format("convert it: ogr2ogr {} {}", one_line(package), one_line(source.file)));
    }
    return std::make_unique<TableQuestions>(source, PlaceSystem(map, crs), columns);
  }
  const FeatureShape shape = columns.places.size() == 1 ? FeatureShape::points : FeatureShape::lines;
  FeatureTable features = read_features(source.file, shape, source.layer);
  PlaceSystem system = system_of(features, map, crs);
  return std::make_unique<FeatureQuestions>(std::move(features), std::move(system), columns);
}

}  // namespace offing::cli
