// GeoPackage and GeoJSON by GDAL: no other format is opened, and nothing is fetched.
#include "host/io/height_maps/map_features.h"

#include <array>
#include <atomic>
#include <cmath>
#include <string_view>
#include <utility>

#include <cpl_conv.h>
#include <cpl_http.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <ogr_api.h>

#include "host/base/error.h"
#include "host/io/height_maps/gdal_session.h"
#include "host/io/height_maps/readable_file.h"

namespace offing {
namespace {

using height_maps::Dataset;
using height_maps::GdalSession;
using height_maps::spatial_reference;
using height_maps::SpatialReference;

struct DestroyFeature {
  void operator()(void* feature) const { OGR_F_Destroy(feature); }
};
using Feature = std::unique_ptr<void, DestroyFeature>;

constexpr std::size_t most_features = 10'000'000;

/// While it lives, this thread fetches nothing: a GeoJSON may name its coordinate system by an address.
class NoFetching {
 public:
  NoFetching() { CPLHTTPPushFetchCallback(refuse, nullptr); }
  NoFetching(const NoFetching&) = delete;
  NoFetching& operator=(const NoFetching&) = delete;
  ~NoFetching() { CPLHTTPPopFetchCallback(); }

 private:
  static CPLHTTPResult* refuse(const char* address, CSLConstList /*options*/, GDALProgressFunc /*progress*/,
                               void* /*data*/, CPLHTTPFetchWriteFunc /*write*/, void* /*write_data*/,
                               void* /*user*/) {
    CPLError(CE_Failure, CPLE_AppDefined, "%s is not fetched", address);
    auto* const result = static_cast<CPLHTTPResult*>(CPLCalloc(1, sizeof(CPLHTTPResult)));
    result->nStatus = 1;
    result->pszErrBuf = CPLStrdup("nothing is fetched");
    return result;
  }
};

[[noreturn]] void refuse_file(const std::filesystem::path& path, const std::string& found,
                              const std::string& hint) {
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: expected a GeoPackage or a GeoJSON, found {}", one_line(path.string()), found),
              hint);
}

OGRLayerH find_layer(const std::filesystem::path& path, GDALDatasetH dataset, const std::string& wanted) {
  std::vector<std::string> names;
  for (int i = 0; i < GDALDatasetGetLayerCount(dataset); ++i) {
    const OGRLayerH layer = GDALDatasetGetLayer(dataset, i);
    names.push_back(printable(OGR_L_GetName(layer)));
    if (!wanted.empty() && wanted == OGR_L_GetName(layer)) return layer;
  }
  if (names.empty()) refuse_file(path, "no layers", "save points as a layer of the file");
  if (names.size() == 1 && wanted.empty()) return GDALDatasetGetLayer(dataset, 0);
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: --layer: expected one of {}, found {}", one_line(path.string()),
                          fmt::join(names, ", "), wanted.empty() ? "none" : printable(wanted)),
              fmt::format("write --layer {}", names.front()));
}

AttributeKind kind_of(OGRFieldType type) {
  if (type == OFTInteger || type == OFTInteger64) return AttributeKind::whole;
  return type == OFTReal ? AttributeKind::number : AttributeKind::text;
}

AttributeValue value_of(OGRFeatureH feature, int field, AttributeKind kind) {
  if (OGR_F_IsFieldSetAndNotNull(feature, field) == 0) return {};
  if (kind == AttributeKind::whole) return std::int64_t{OGR_F_GetFieldAsInteger64(feature, field)};
  if (kind == AttributeKind::number) return OGR_F_GetFieldAsDouble(feature, field);
  return std::string(OGR_F_GetFieldAsString(feature, field));
}

/// Appends the ends of a geometry. Throws Error(bad_input) for another shape.
void append_ends(OGRGeometryH geometry, FeatureShape shape, FeatureTable& table) {
  const OGRGeometryH whole = geometry;
  for (int depth = 0; geometry != nullptr && depth < 2; ++depth) {
    const OGRwkbGeometryType type = OGR_GT_Flatten(OGR_G_GetGeometryType(geometry));
    const bool is_many = type == wkbMultiPoint || type == wkbMultiLineString || type == wkbGeometryCollection;
    if (!is_many || OGR_G_GetGeometryCount(geometry) != 1) break;
    geometry = OGR_G_GetGeometryRef(geometry, 0);
  }
  const OGRwkbGeometryType type =
      geometry == nullptr ? wkbNone : OGR_GT_Flatten(OGR_G_GetGeometryType(geometry));
  const bool is_point = shape == FeatureShape::points;
  const int points = geometry == nullptr ? 0 : OGR_G_GetPointCount(geometry);
  const bool fits = type == (is_point ? wkbPoint : wkbLineString) && OGR_G_IsEmpty(geometry) == 0 &&
                    points == static_cast<int>(ends_of(shape));
  const std::size_t first = table.ends.size();
  for (int i = 0; fits && i < points; ++i) {
    table.ends.emplace_back(OGR_G_GetX(geometry, i), OGR_G_GetY(geometry, i), OGR_G_GetZ(geometry, i));
  }
  bool is_finite = true;
  for (std::size_t i = first; i < table.ends.size(); ++i)
    is_finite = is_finite && std::isfinite(table.ends[i].x + table.ends[i].y + table.ends[i].z);
  if (fits && is_finite) return;
  std::string found = "no geometry";
  if (whole != nullptr) {
    found = OGR_G_IsEmpty(whole) != 0 ? "an empty geometry"
            : fits                    ? "coordinates that are not finite"
                                      : fmt::format("{} of {} part{}", OGR_G_GetGeometryName(whole),
                                                    std::max(points, OGR_G_GetGeometryCount(whole)),
                                 std::max(points, OGR_G_GetGeometryCount(whole)) == 1 ? "" : "s");
  }
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: expected {}, found {}", table.place_of(table.ids.size() - 1),
                          is_point ? "a point" : "a line of two points", found),
              is_point ? "make points of it, as with ogr2ogr -explodecollections or Centroids in QGIS"
                       : "make lines of two points of it, as with Explode lines in QGIS");
}

class GeoPackageWriter : public FeatureWriter {
 public:
  GeoPackageWriter(const std::filesystem::path& path, const NewFeatures& features, Existing existing)
      : path_(path), features_(features), file_(path, existing) {
    static std::atomic<int> count = 0;
    memory_ = fmt::format("/vsimem/offing_features_{}.gpkg", count++);
    const GDALDriverH driver = GDALGetDriverByName("GPKG");
    if (driver != nullptr) dataset_.reset(GDALCreate(driver, memory_.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    if (!dataset_) fail();
    const SpatialReference system = spatial_reference(features.coordinate_system);
    OGRwkbGeometryType type = features.shape == FeatureShape::points ? wkbPoint : wkbLineString;
    if (features.has_heights) type = OGR_GT_SetZ(type);
    layer_ = GDALDatasetCreateLayer(dataset_.get(), features.layer.c_str(), system.get(), type, nullptr);
    if (layer_ == nullptr) fail();
    for (const AttributeColumn& column : features.columns) {
      const OGRFieldType field = column.kind == AttributeKind::whole    ? OFTInteger64
                                 : column.kind == AttributeKind::number ? OFTReal
                                                                        : OFTString;
      const OGRFieldDefnH definition = OGR_Fld_Create(column.name.c_str(), field);
      const bool is_made = OGR_L_CreateField(layer_, definition, FALSE) == OGRERR_NONE;
      OGR_Fld_Destroy(definition);
      if (!is_made) fail();
    }
    if (GDALDatasetStartTransaction(dataset_.get(), FALSE) != OGRERR_NONE) fail();
  }
  ~GeoPackageWriter() override {
    dataset_.reset();
    VSIUnlink(memory_.c_str());
  }

  void add(std::span<const glm::dvec3> ends, std::span<const AttributeValue> values) override {
    const Feature feature(OGR_F_Create(OGR_L_GetLayerDefn(layer_)));
    for (int i = 0; i < static_cast<int>(values.size()); ++i) {
      const AttributeValue& value = values[static_cast<std::size_t>(i)];
      if (const auto* number = std::get_if<double>(&value)) OGR_F_SetFieldDouble(feature.get(), i, *number);
      if (const auto* whole = std::get_if<std::int64_t>(&value))
        OGR_F_SetFieldInteger64(feature.get(), i, *whole);
      if (const auto* text = std::get_if<std::string>(&value))
        OGR_F_SetFieldString(feature.get(), i, text->c_str());
    }
    const OGRGeometryH geometry =
        OGR_G_CreateGeometry(features_.shape == FeatureShape::points ? wkbPoint : wkbLineString);
    for (const glm::dvec3& end : ends) {
      if (features_.has_heights) {
        OGR_G_AddPoint(geometry, end.x, end.y, end.z);
      } else {
        OGR_G_AddPoint_2D(geometry, end.x, end.y);
      }
    }
    if (OGR_F_SetGeometryDirectly(feature.get(), geometry) != OGRERR_NONE ||
        OGR_L_CreateFeature(layer_, feature.get()) != OGRERR_NONE) {
      fail();
    }
  }

  void commit() override {
    if (GDALDatasetCommitTransaction(dataset_.get()) != OGRERR_NONE) fail();
    dataset_.reset();
    vsi_l_offset bytes = 0;
    const GByte* const data = VSIGetMemFileBuffer(memory_.c_str(), &bytes, FALSE);
    if (data == nullptr || session_.has_failed()) fail();
    file_.write(data, static_cast<std::size_t>(bytes));
    file_.commit();
  }

 private:
  [[noreturn]] void fail() const {
    throw Error(ErrorKind::file,
                fmt::format("{}: cannot be written: {}", one_line(path_.string()), session_.failure()),
                "name another file, or write CSV");
  }

  std::filesystem::path path_;
  NewFeatures features_;
  AtomicFile file_;
  GdalSession session_;
  height_maps::FeatureDrivers drivers_;
  // The time of the last change, so that equal features are equal files.
  CPLConfigOptionSetter date_{"OGR_CURRENT_DATE", "1970-01-01T00:00:00.000Z", true};
  std::string memory_;
  Dataset dataset_;
  OGRLayerH layer_ = nullptr;
};

}  // namespace

FeatureTable read_features(const std::filesystem::path& path, FeatureShape shape, const std::string& layer) {
  height_maps::require_readable_file(path, "a GeoPackage or a GeoJSON");
  const GdalSession session;
  const height_maps::FeatureDrivers drivers;
  const NoFetching no_fetching;
  constexpr std::array<const char*, 3> formats{"GPKG", "GeoJSON", nullptr};
  // No part of an absolute path is taken for an address or for content.
  const std::string file = std::filesystem::absolute(path).string();
  const Dataset dataset(GDALOpenEx(file.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR,
                                   formats.data(), nullptr, nullptr));
  if (!dataset) {
    refuse_file(path, fmt::format("a file that cannot be opened as one: {}", session.failure()),
                fmt::format("convert it, as with ogr2ogr {}_points.gpkg {}, or give a CSV file",
                            one_line(path.stem().string()), one_line(path.string())));
  }
  const OGRLayerH source = find_layer(path, dataset.get(), layer);
  FeatureTable table;
  table.file = path;
  table.layer = OGR_L_GetName(source);
  if (const OGRSpatialReferenceH system = OGR_L_GetSpatialRef(source)) {
    // A GeoPackage's word for none. Heights are carried through as they are: the plan's system counts.
    const SpatialReference plan(OSRClone(system));
    OSRStripVertical(plan.get());
    OSRDemoteTo2D(plan.get(), nullptr);
    const bool is_named = !std::string_view(OSRGetName(system)).starts_with("Undefined");
    if (is_named) table.coordinate_system = height_maps::wkt_of(plan.get());
    // In the order of pictures, as coordinates come.
    const SpatialReference own = spatial_reference(table.coordinate_system),
                           lonlat = spatial_reference("EPSG:4326");
    table.is_lonlat = own && OSRIsSame(own.get(), lonlat.get()) != 0;
  }
  const OGRFeatureDefnH definition = OGR_L_GetLayerDefn(source);
  for (int i = 0; i < OGR_FD_GetFieldCount(definition); ++i) {
    const OGRFieldDefnH field = OGR_FD_GetFieldDefn(definition, i);
    table.columns.push_back({OGR_Fld_GetNameRef(field), kind_of(OGR_Fld_GetType(field))});
  }
  OGR_L_ResetReading(source);
  for (Feature feature(OGR_L_GetNextFeature(source)); feature; feature.reset(OGR_L_GetNextFeature(source))) {
    if (table.ids.size() == most_features) {
      refuse_file(path, fmt::format("more than {} features", most_features), "cut it into several files");
    }
    table.ids.push_back(OGR_F_GetFID(feature.get()));
    const OGRGeometryH geometry = OGR_F_GetGeometryRef(feature.get());
    append_ends(geometry, shape, table);
    const bool is_raised = OGR_G_Is3D(geometry) != 0;
    table.is_raised.push_back(is_raised);
    table.has_heights = table.has_heights || is_raised;
    for (int i = 0; i < static_cast<int>(table.columns.size()); ++i)
      table.values.push_back(value_of(feature.get(), i, table.columns[static_cast<std::size_t>(i)].kind));
  }
  if (session.has_failed()) {
    refuse_file(path, fmt::format("one that is damaged: {}", session.failure()),
                "copy it again, or repair it");
  }
  if (table.ids.empty()) {
    throw Error(ErrorKind::bad_input, fmt::format("{}: expected points, found none", table.name()),
                "give a layer that has features");
  }
  return table;
}

std::unique_ptr<FeatureWriter> create_features(const std::filesystem::path& path, const NewFeatures& features,
                                               Existing existing) {
  return std::make_unique<GeoPackageWriter>(path, features, existing);
}

}  // namespace offing
