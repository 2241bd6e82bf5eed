#include "tests/io/height_maps/raster_writer.h"

#include <memory>
#include <stdexcept>

#include <cpl_string.h>
#include <gdal.h>
#include <ogr_srs_api.h>

namespace offing::test {

namespace {

void require(bool condition, const std::string& what) {
  if (!condition) throw std::runtime_error("raster_writer: " + what);
}

}  // namespace

Raster raster_of(int columns, int rows, const std::function<double(int, int)>& height) {
  Raster raster;
  raster.columns = columns;
  raster.rows = rows;
  raster.bands.emplace_back();
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) raster.bands[0].push_back(height(column, row));
  }
  return raster;
}

void write_raster(const std::filesystem::path& path, const std::string& driver, const Raster& raster) {
  GDALAllRegister();
  const GDALDataType type = GDALGetDataTypeByName(raster.type.c_str());
  const GDALDatasetH memory = GDALCreate(GDALGetDriverByName("MEM"), "", raster.columns, raster.rows,
                                         static_cast<int>(raster.bands.size()), type, nullptr);
  require(memory != nullptr, "no memory raster");
  if (raster.geotransform) {
    std::array<double, 6> corner = *raster.geotransform;
    GDALSetGeoTransform(memory, corner.data());
  }
  if (!raster.coordinate_system.empty()) {
    const OGRSpatialReferenceH reference = OSRNewSpatialReference(nullptr);
    require(OSRSetFromUserInput(reference, raster.coordinate_system.c_str()) == OGRERR_NONE,
            "no such system");
    GDALSetSpatialRef(memory, reference);
    OSRDestroySpatialReference(reference);
  }
  if (raster.is_point) GDALSetMetadataItem(memory, GDALMD_AREA_OR_POINT, GDALMD_AOP_POINT, nullptr);
  for (std::size_t i = 0; i < raster.bands.size(); ++i) {
    const GDALRasterBandH band = GDALGetRasterBand(memory, static_cast<int>(i) + 1);
    if (raster.nodata) GDALSetRasterNoDataValue(band, *raster.nodata);
    if (!raster.unit.empty()) GDALSetRasterUnitType(band, raster.unit.c_str());
    std::vector<double> samples = raster.bands[i];
    require(GDALRasterIO(band, GF_Write, 0, 0, raster.columns, raster.rows, samples.data(), raster.columns,
                         raster.rows, GDT_Float64, 0, 0) == CE_None,
            "samples");
  }
  char** options = nullptr;
  for (const std::string& option : raster.creation_options) options = CSLAddString(options, option.c_str());
  const GDALDatasetH written = GDALCreateCopy(GDALGetDriverByName(driver.c_str()), path.c_str(), memory,
                                              FALSE, options, nullptr, nullptr);
  CSLDestroy(options);
  require(written != nullptr, "cannot write " + path.string());
  GDALClose(written);
  GDALClose(memory);
}

}  // namespace offing::test
