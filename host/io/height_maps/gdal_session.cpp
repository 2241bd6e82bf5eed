#include "host/io/height_maps/gdal_session.h"

#include <algorithm>
#include <array>
#include <mutex>
#include <string_view>
#include <vector>

#include <cpl_conv.h>
#include <ogr_spatialref.h>

#include "host/base/error.h"

namespace offing::height_maps {

namespace {

constexpr std::array<const char*, 26> plain{
    "GTiff", "SRTMHGT", "USGSDEM", "AAIGrid", "GRASSASCIIGrid", "DTED", "PNG",    "JPEG", "JP2OpenJPEG",
    "WEBP",  "BMP",     "GIF",     "EHdr",    "ENVI",           "HFA",  "BT",     "XYZ",  "GSAG",
    "GSBG",  "GS7BG",   "SAGA",    "RST",     "Terragen",       "HF2",  "netCDF", nullptr};

bool is_used(std::string_view driver) {
  return driver == "MEM" || driver == "VRT" ||
         std::find_if(plain.begin(), plain.end() - 1, [&](const char* name) { return driver == name; }) !=
             plain.end() - 1;
}

bool has_features(std::string_view driver) {
  return driver == "GPKG" || driver == "GeoJSON";
}

/// The drivers of features, and who uses them now.
struct {
  std::mutex mutex;
  std::vector<GDALDriverH> drivers;
  int users = 0;
} features;

/// Files that lead to others (masks, overviews, sources of a VRT) have GDAL open them as any driver it knows.
void register_used_drivers() {
  std::vector<GDALDriverH> others;
  for (int i = 0; i < GDALGetDriverCount(); ++i) others.push_back(GDALGetDriver(i));
  GDALAllRegister();
  for (int i = GDALGetDriverCount() - 1; i >= 0; --i) {
    const GDALDriverH driver = GDALGetDriver(i);
    const std::string_view name = GDALGetDriverShortName(driver);
    if (is_used(name) || std::ranges::find(others, driver) != others.end()) continue;
    GDALDeregisterDriver(driver);
    if (has_features(name)) {
      features.drivers.push_back(driver);
    } else {
      GDALDestroyDriver(driver);
    }
  }
  OSRSetPROJEnableNetwork(0);
}

/// The bounds of GDAL's only cache that live now.
struct {
  std::mutex mutex;
  int count = 0;
  GIntBig bytes_without = 0;
} cache_bounds;

}  // namespace

const char* const* plain_formats() {
  return plain.data();
}

CacheBound::CacheBound(GDALDatasetH raster) {
  if (CPLGetConfigOption("GDAL_CACHEMAX", nullptr) != nullptr || GDALGetRasterCount(raster) == 0) return;
  const GDALRasterBandH band = GDALGetRasterBand(raster, 1);
  int block_columns = 0, block_rows = 0;
  GDALGetBlockSize(band, &block_columns, &block_rows);
  // Twice the rows of a block, of a VRT of its sources' usual ones: none is read again for the next rows.
  const GIntBig rows = 2 * std::clamp(block_rows, 256, 4096);
  const GIntBig row_bytes = GIntBig{GDALGetRasterXSize(raster)} * GDALGetRasterCount(raster) *
                            GDALGetDataTypeSizeBytes(GDALGetRasterDataType(band));
  constexpr GIntBig mebibyte = 1 << 20;
  const GIntBig wanted_bytes = std::clamp(rows * row_bytes, 16 * mebibyte, 1024 * mebibyte);
  const std::lock_guard lock(cache_bounds.mutex);
  const bool is_first = cache_bounds.count++ == 0;
  if (is_first) cache_bounds.bytes_without = GDALGetCacheMax64();
  GDALSetCacheMax64(is_first ? wanted_bytes : std::max(wanted_bytes, GDALGetCacheMax64()));
  is_set_ = true;
}

CacheBound::~CacheBound() {
  if (!is_set_) return;
  const std::lock_guard lock(cache_bounds.mutex);
  if (--cache_bounds.count == 0) GDALSetCacheMax64(cache_bounds.bytes_without);
}

GdalSession::GdalSession() {
  static std::once_flag once;
  std::call_once(once, register_used_drivers);
  CPLPushErrorHandlerEx(note, this);
}

GdalSession::~GdalSession() {
  CPLPopErrorHandler();
}

FeatureDrivers::FeatureDrivers() {
  const std::lock_guard lock(features.mutex);
  if (features.users++ > 0) return;
  for (const GDALDriverH driver : features.drivers) GDALRegisterDriver(driver);
}

FeatureDrivers::~FeatureDrivers() {
  const std::lock_guard lock(features.mutex);
  if (--features.users > 0) return;
  for (const GDALDriverH driver : features.drivers) GDALDeregisterDriver(driver);
}

void CPL_STDCALL GdalSession::note(CPLErr severity, CPLErrorNum /*number*/, const char* message) {
  auto* const session = static_cast<GdalSession*>(CPLGetErrorHandlerUserData());
  if (severity >= CE_Failure && session->first_failure_.empty()) {
    session->first_failure_ = one_line(message);
  }
}

std::string GdalSession::failure() const {
  return first_failure_.empty() ? "no reason given" : first_failure_;
}

SpatialReference spatial_reference(const std::string& text) {
  SpatialReference reference(OSRNewSpatialReference(nullptr));
  if (OGRSpatialReference::FromHandle(reference.get())
          ->SetFromUserInput(text.c_str(), OGRSpatialReference::SET_FROM_USER_INPUT_LIMITATIONS_get()) !=
      OGRERR_NONE) {
    return nullptr;
  }
  OSRSetAxisMappingStrategy(reference.get(), OAMS_TRADITIONAL_GIS_ORDER);
  return reference;
}

std::string wkt_of(OGRSpatialReferenceH reference) {
  char* text = nullptr;
  const bool is_written = OSRExportToWkt(reference, &text) == OGRERR_NONE;
  const std::string wkt = is_written ? text : "";
  CPLFree(text);
  return wkt;
}

}  // namespace offing::height_maps
