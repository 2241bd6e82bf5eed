#include "host/io/height_maps/byte_raster.h"

#include <array>

#include <cpl_string.h>
#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/atomic_file.h"
#include "host/io/height_maps/gdal_session.h"

namespace offing {

namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const height_maps::GdalSession& session) {
  throw Error(ErrorKind::file, fmt::format("{}: cannot be written: {}", path.string(), session.failure()),
              "check the room on the disk, or name another file");
}

struct DestroyList {
  void operator()(char** list) const { CSLDestroy(list); }
};
using StringList = std::unique_ptr<char*, DestroyList>;

}  // namespace

void write_byte_raster(const std::filesystem::path& path, const ByteRaster& raster) {
  const auto posts = static_cast<std::size_t>(raster.columns) * static_cast<std::size_t>(raster.rows);
  if (raster.values.size() != posts) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("{}: expected {}x{} values, found {}", path.string(), raster.columns, raster.rows,
                            raster.values.size()),
                "give a value for each post");
  }
  AtomicFile file(path);
  const height_maps::GdalSession session;
  const GDALDriverH driver = GDALGetDriverByName("GTiff");
  if (driver == nullptr) fail(path, session);
  StringList options;
  for (const char* option : {"COMPRESS=DEFLATE", "ZLEVEL=1", "TILED=YES", "BIGTIFF=IF_SAFER"}) {
    options.reset(CSLAddString(options.release(), option));
  }
  height_maps::Dataset dataset(
      GDALCreate(driver, file.temporary().c_str(), raster.columns, raster.rows, 1, GDT_Byte, options.get()));
  if (!dataset) fail(path, session);
  const Georeference& place = raster.georeference;
  if (place.step_x != 0.0) {
    // Of the corner of the first sample.
    std::array<double, 6> corner{place.origin_x - 0.5 * place.step_x, place.step_x, 0.0,
                                 place.origin_y - 0.5 * place.step_y, 0.0,          place.step_y};
    if (GDALSetGeoTransform(dataset.get(), corner.data()) != CE_None) fail(path, session);
  }
  if (!place.coordinate_system.empty() &&
      GDALSetProjection(dataset.get(), place.coordinate_system.c_str()) != CE_None) {
    fail(path, session);
  }
  const GDALRasterBandH band = GDALGetRasterBand(dataset.get(), 1);
  if (raster.nodata && GDALSetRasterNoDataValue(band, *raster.nodata) != CE_None) fail(path, session);
  // GDAL takes what it only reads without const.
  auto* const values = const_cast<std::uint8_t*>(raster.values.data());
  if (GDALRasterIO(band, GF_Write, 0, 0, raster.columns, raster.rows, values, raster.columns, raster.rows,
                   GDT_Byte, 0, 0) != CE_None) {
    fail(path, session);
  }
  GDALFlushCache(dataset.get());
  dataset.reset();
  if (session.has_failed()) fail(path, session);
  file.commit();
}

}  // namespace offing
