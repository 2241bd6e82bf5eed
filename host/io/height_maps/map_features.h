#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <glm/vec3.hpp>

#include "host/base/error.h"
#include "host/io/atomic_file.h"
#include "host/io/file_extension.h"

/// Points and lines of GIS files, with their attributes.
namespace offing {

/// Of the values of an attribute.
enum class AttributeKind { text, whole, number };

/// An attribute that each feature of a layer has.
struct AttributeColumn {
  std::string name;
  AttributeKind kind = AttributeKind::number;
};
/// Nothing, a number, a whole number or a text.
using AttributeValue = std::variant<std::monostate, double, std::int64_t, std::string>;

/// What the features of a layer are: points, or straight lines of two ends.
enum class FeatureShape { points, lines };

constexpr std::size_t ends_of(FeatureShape shape) {
  return shape == FeatureShape::points ? 1 : 2;
}

/// Features of one layer, in the order of the file.
struct FeatureTable {
  std::filesystem::path file;
  std::string layer;
  std::string coordinate_system;  ///< WKT; empty where the layer names none
  bool is_lonlat = false;         ///< whether that is WGS 84
  bool has_heights = false;       ///< whether any of `ends` have a z
  std::vector<bool> is_raised;    ///< [features], whether the ends of each have one
  std::vector<std::int64_t> ids;
  std::vector<glm::dvec3> ends;  ///< [features][1 or 2], east before north, z 0 without heights
  std::vector<AttributeColumn> columns;
  std::vector<AttributeValue> values;  ///< [features][columns]

  std::size_t count() const { return ids.size(); }
  /// "wells.gpkg: wells".
  std::string name() const { return one_line(file.string()) + ": " + printable(layer); }
  /// "wells.gpkg: wells: feature id 7". The file gives the id: GeoJSON counts from 0, GeoPackage from 1.
  std::string place_of(std::size_t index) const {
    return name() + ": feature id " + std::to_string(ids[index]);
  }
};

/// Whether a name is that of a GIS file: .gpkg, .geojson or .json.
inline bool is_feature_file(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  return extension == ".gpkg" || extension == ".geojson" || extension == ".json";
}

/// Reads a layer of a GeoPackage or a GeoJSON; an empty `layer` is the only one. Other formats, and whatever
/// leads to servers, are refused. Throws Error(bad_input) that names file, layer and feature: no file, no
/// such layer, several layers, no features, or a geometry that is none of this shape. A part of several that
/// is the only one counts as the feature itself.
FeatureTable read_features(const std::filesystem::path& path, FeatureShape shape, const std::string& layer);

/// A layer that is written.
struct NewFeatures {
  FeatureShape shape = FeatureShape::points;
  std::string layer;
  std::string coordinate_system;  ///< WKT
  bool has_heights = false;
  std::vector<AttributeColumn> columns;
};

/// A GeoPackage of one layer, written whole or not at all.
class FeatureWriter {
 public:
  FeatureWriter() = default;
  FeatureWriter(const FeatureWriter&) = delete;
  FeatureWriter& operator=(const FeatureWriter&) = delete;
  virtual ~FeatureWriter() = default;

  /// One feature: its ends, and a value for each column. Throws Error(file).
  virtual void add(std::span<const glm::dvec3> ends, std::span<const AttributeValue> values) = 0;
  /// Publishes the file under its name. Throws Error(file).
  virtual void commit() = 0;
};

/// Keeps the file in memory until commit(). Throws Error(file).
std::unique_ptr<FeatureWriter> create_features(const std::filesystem::path& path, const NewFeatures& features,
                                               Existing existing = Existing::replace);

}  // namespace offing
