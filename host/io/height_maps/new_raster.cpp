#include "host/io/height_maps/new_raster.h"

#include <array>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <string>
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
  int bands = 1;
};

/// Throws Error(file) with what GDAL has said.
[[noreturn]] void fail_to_write(const std::filesystem::path& path, const GdalSession& session) {
  throw Error(ErrorKind::file, fmt::format("{}: cannot be written: {}", path.string(), session.failure()),
              "check the free space on the disk, or name another file");
}

/// Makes a raster. Throws Error(file).
Dataset create_raster(const NewRaster& raster, const GdalSession& session) {
  const GDALDriverH driver = GDALGetDriverByName("GTiff");
  if (driver == nullptr) fail_to_write(raster.name, session);
  StringList options;
  for (const char* option : raster.options) options.reset(CSLAddString(options.release(), option));
  Dataset dataset(GDALCreate(driver, raster.temporary.c_str(), raster.columns, raster.rows, raster.bands,
                             raster.type, options.get()));
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

/// Marks what a band holds. Returns whether GDAL takes it.
bool describe(GDALRasterBandH band, const std::optional<double>& nodata, const std::string& unit,
              const std::string& description) {
  if (!unit.empty()) GDALSetRasterUnitType(band, unit.c_str());
  if (!description.empty()) GDALSetDescription(band, description.c_str());
  return !nodata || GDALSetRasterNoDataValue(band, *nodata) == CE_None;
}

/// Several may be open at once: each call has a session of its own, which hears what fails in it.
class BandedGeoTiff : public BandedRasterWriter {
 public:
  BandedGeoTiff(const std::filesystem::path& path, const BandedRaster& raster, Existing existing)
      : path_(path), file_(path, existing), columns_(raster.columns) {
    const GdalSession session;
    const std::string block_rows = fmt::format("BLOCKYSIZE={}", raster.rows_at_once);
    dataset_ = create_raster({.name = path_,
                              .temporary = file_.temporary(),
                              .columns = raster.columns,
                              .rows = raster.rows,
                              .type = raster.has_bytes ? GDT_Byte : GDT_Float32,
                              .georeference = raster.georeference,
                              .options = {"COMPRESS=DEFLATE", "ZLEVEL=1", "TILED=YES", "INTERLEAVE=BAND",
                                          "BIGTIFF=IF_SAFER", "BLOCKXSIZE=256", block_rows.c_str()},
                              .bands = static_cast<int>(raster.bands.size())},
                             session);
    int number = 1;
    for (const BandedRaster::Band& band : raster.bands) {
      if (!describe(GDALGetRasterBand(dataset_.get(), number++), raster.nodata, band.unit,
                    band.description)) {
        fail_to_write(path_, session);
      }
    }
  }

  BandedGeoTiff(const BandedGeoTiff&) = delete;
  BandedGeoTiff& operator=(const BandedGeoTiff&) = delete;
  ~BandedGeoTiff() override {
    const GdalSession session;  // what fails now was told before
    dataset_.reset();
  }

  void write(std::size_t band, int first_row, std::span<const float> values) override {
    write_rows(band, first_row, values.data(), values.size(), GDT_Float32);
  }
  void write(std::size_t band, int first_row, std::span<const std::uint8_t> values) override {
    write_rows(band, first_row, values.data(), values.size(), GDT_Byte);
  }

  void commit() override {
    const GdalSession session;
    GDALFlushCache(dataset_.get());
    dataset_.reset();
    if (session.has_failed()) fail_to_write(path_, session);
    file_.commit();
  }

 private:
  void write_rows(std::size_t band, int first_row, const void* values, std::size_t count, GDALDataType type) {
    const GdalSession session;
    const int rows = static_cast<int>(count / static_cast<std::size_t>(columns_));
    // GDAL takes what it only reads without const.
    const CPLErr result =
        GDALRasterIO(GDALGetRasterBand(dataset_.get(), static_cast<int>(band) + 1), GF_Write, 0, first_row,
                     columns_, rows, const_cast<void*>(values), columns_, rows, type, 0, 0);
    if (result != CE_None || session.has_failed()) fail_to_write(path_, session);
  }

  std::filesystem::path path_;
  AtomicFile file_;
  int columns_;
  Dataset dataset_;
};

}  // namespace

std::unique_ptr<BandedRasterWriter> create_banded_raster(const std::filesystem::path& path,
                                                         const BandedRaster& raster, Existing existing) {
  return std::make_unique<BandedGeoTiff>(path, raster, existing);
}

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
  const bool is_marked = describe(band, raster.nodata, raster.unit, raster.description);
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
