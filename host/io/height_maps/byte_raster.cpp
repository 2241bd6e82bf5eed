#include "host/io/height_maps/byte_raster.h"

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/atomic_file.h"
#include "host/io/height_maps/new_raster.h"

namespace offing {

void write_byte_raster(const std::filesystem::path& path, const ByteRaster& raster, Existing existing) {
  const auto posts = static_cast<std::size_t>(raster.columns) * static_cast<std::size_t>(raster.rows);
  if (raster.values.size() != posts) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("{}: expected {}x{} values, found {}", path.string(), raster.columns, raster.rows,
                            raster.values.size()),
                "give a value for each post");
  }
  AtomicFile file(path, existing);
  const height_maps::GdalSession session;
  height_maps::Dataset dataset = height_maps::create_raster(
      {.name = path,
       .temporary = file.temporary(),
       .columns = raster.columns,
       .rows = raster.rows,
       .type = GDT_Byte,
       .georeference = raster.georeference,
       .options = {"COMPRESS=DEFLATE", "ZLEVEL=1", "TILED=YES", "BIGTIFF=IF_SAFER"}},
      session);
  const GDALRasterBandH band = GDALGetRasterBand(dataset.get(), 1);
  const bool is_marked = !raster.nodata || GDALSetRasterNoDataValue(band, *raster.nodata) == CE_None;
  // GDAL takes what it only reads without const.
  auto* const values = const_cast<std::uint8_t*>(raster.values.data());
  if (!is_marked || GDALRasterIO(band, GF_Write, 0, 0, raster.columns, raster.rows, values, raster.columns,
                                 raster.rows, GDT_Byte, 0, 0) != CE_None) {
    height_maps::fail_to_write(path, session);
  }
  GDALFlushCache(dataset.get());
  dataset.reset();
  if (session.has_failed()) height_maps::fail_to_write(path, session);
  file.commit();
}

}  // namespace offing
