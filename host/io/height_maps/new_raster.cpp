#include "host/io/height_maps/new_raster.h"

#include <array>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <variant>

#include <cpl_string.h>
#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/height_map.h"
#include "host/io/atomic_file.h"
#include "host/io/height_maps/gdal_session.h"

namespace offing {
namespace {

using height_maps::Dataset;
using height_maps::GdalSession;

struct DestroyList {
  void operator()(char** list) const { CSLDestroy(list); }
};
using StringList = std::unique_ptr<char*, DestroyList>;

/// Of a GeoTIFF that is to be made.
struct NewRaster {
  std::filesystem::path name;       ///< for messages
  std::filesystem::path temporary;  ///< where it is written
  int columns, rows;
  GDALDataType type;
  Georeference georeference;  ///< posts stand at the centres of samples
  std::initializer_list<const char*> options;
};

/// Throws Error(file) with what GDAL has said.
[[noreturn]] void fail_to_write(const std::filesystem::path& path, const GdalSession& session) {
  throw Error(ErrorKind::file, fmt::format("{}: cannot be written: {}", path.string(), session.failure()),
              "check the free space on the disk, or name another file");
}

/// Makes a raster of one band. Throws Error(file).
Dataset create_raster(const NewRaster& raster, const GdalSession& session) {
  const GDALDriverH driver = GDALGetDriverByName("GTiff");
  if (driver == nullptr) fail_to_write(raster.name, session);
  StringList options;
  for (const char* option : raster.options) options.reset(CSLAddString(options.release(), option));
  Dataset dataset(GDALCreate(driver, raster.temporary.c_str(), raster.columns, raster.rows, 1, raster.type,
                             options.get()));
  if (!dataset) fail_to_write(raster.name, session);
  const Georeference& place = raster.georeference;
  if (place.step_x != 0.0) {
    // Of the corner of the first sample.
    std::array<double, 6> corner{place.origin_x - 0.5 * place.step_x, place.step_x, 0.0,
                                 place.origin_y - 0.5 * place.step_y, 0.0,          place.step_y};
    if (GDALSetGeoTransform(dataset.get(), corner.data()) != CE_None) fail_to_write(raster.name, session);
  }
  if (!place.coordinate_system.empty() &&
      GDALSetProjection(dataset.get(), place.coordinate_system.c_str()) != CE_None) {
    fail_to_write(raster.name, session);
  }
  return dataset;
}

// Generated terrain has a scale, but no place.
constexpr const char* local_metres = R"(LOCAL_CS["generated terrain",UNIT["metre",1]])";

class GeoTiffWriter : public HeightRasterWriter {
 public:
  GeoTiffWriter(const std::filesystem::path& path, int columns, int rows, double spacing_m, Existing existing)
      : path_(path),
        file_(path, existing),
        columns_(columns),
        dataset_(
            create_raster({.name = path,
                           .temporary = file_.temporary(),
                           .columns = columns,
                           .rows = rows,
                           .type = GDT_Float32,
                           .georeference = {local_metres, 0.0, spacing_m * (rows - 1), spacing_m, -spacing_m},
                           .options = {"BIGTIFF=IF_SAFER"}},
                          session_)) {}

  void add_rows(std::span<const float> heights_m) override {
    const int rows = static_cast<int>(heights_m.size() / static_cast<std::size_t>(columns_));
    // GDAL takes what it only reads without const.
    auto* const values = const_cast<float*>(heights_m.data());
    if (GDALRasterIO(GDALGetRasterBand(dataset_.get(), 1), GF_Write, 0, next_row_, columns_, rows, values,
                     columns_, rows, GDT_Float32, 0, 0) != CE_None) {
      fail_to_write(path_, session_);
    }
    next_row_ += rows;
  }

  void commit() override {
    GDALFlushCache(dataset_.get());
    dataset_.reset();
    if (session_.has_failed()) fail_to_write(path_, session_);
    file_.commit();
  }

 private:
  std::filesystem::path path_;
  AtomicFile file_;
  GdalSession session_;
  int columns_, next_row_ = 0;
  Dataset dataset_;
};

}  // namespace

void write_byte_raster(const std::filesystem::path& path, const ByteRaster& raster, Existing existing) {
  write_post_raster(path,
                    {.columns = raster.columns,
                     .rows = raster.rows,
                     .values = raster.values,
                     .georeference = raster.georeference,
                     .nodata = raster.nodata ? std::optional<double>(*raster.nodata) : std::nullopt,
                     .unit = {},
                     .description = {}},
                    existing);
}

void write_post_raster(const std::filesystem::path& path, const PostRaster& raster, Existing existing) {
  const auto posts = static_cast<std::size_t>(raster.columns) * static_cast<std::size_t>(raster.rows);
  const std::size_t found = std::visit([](const auto& values) { return values.size(); }, raster.values);
  if (found != posts) {
    throw Error(
        ErrorKind::bad_usage,
        fmt::format("{}: expected {}x{} values, found {}", path.string(), raster.columns, raster.rows, found),
        "give a value for each post");
  }
  constexpr std::array types{GDT_Byte, GDT_UInt16, GDT_Float32};
  const GDALDataType type = types.at(raster.values.index());
  AtomicFile file(path, existing);
  const GdalSession session;
  Dataset dataset =
      create_raster({.name = path,
                     .temporary = file.temporary(),
                     .columns = raster.columns,
                     .rows = raster.rows,
                     .type = type,
                     .georeference = raster.georeference,
                     .options = {"COMPRESS=DEFLATE", "ZLEVEL=1", "TILED=YES", "BIGTIFF=IF_SAFER"}},
                    session);
  const GDALRasterBandH band = GDALGetRasterBand(dataset.get(), 1);
  const bool is_marked = !raster.nodata || GDALSetRasterNoDataValue(band, *raster.nodata) == CE_None;
  if (!raster.unit.empty()) GDALSetRasterUnitType(band, raster.unit.c_str());
  if (!raster.description.empty()) GDALSetDescription(band, raster.description.c_str());
  // GDAL takes what it only reads without const.
  auto* const values = std::visit(
      [](const auto& of) { return const_cast<void*>(static_cast<const void*>(of.data())); }, raster.values);
  if (!is_marked || GDALRasterIO(band, GF_Write, 0, 0, raster.columns, raster.rows, values, raster.columns,
                                 raster.rows, type, 0, 0) != CE_None) {
    fail_to_write(path, session);
  }
  GDALFlushCache(dataset.get());
  dataset.reset();
  if (session.has_failed()) fail_to_write(path, session);
  file.commit();
}

std::unique_ptr<HeightRasterWriter> create_height_raster(const std::filesystem::path& path, int columns,
                                                         int rows, double spacing_m, Existing existing) {
  return std::make_unique<GeoTiffWriter>(path, columns, rows, spacing_m, existing);
}

}  // namespace offing
