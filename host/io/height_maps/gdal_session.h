#pragma once

#include <memory>
#include <string>

#include <cpl_error.h>
#include <gdal.h>
#include <ogr_srs_api.h>

namespace offing::height_maps {

/// GDAL's names of the formats that are read, ended by a null pointer: those whose files hold their own
/// samples, and lead to no server and no program.
const char* const* plain_formats();

/// Collects what GDAL complains about while it lives, instead of letting it print. GDAL then knows the plain
/// formats, its memory and VRT: the others are taken from it, but for those that the program around Offing
/// had registered before.
class GdalSession {
 public:
  GdalSession();
  GdalSession(const GdalSession&) = delete;
  GdalSession& operator=(const GdalSession&) = delete;
  ~GdalSession();

  /// First failure since the session began, as one line; "no reason given" without one.
  std::string failure() const;
  bool has_failed() const { return !first_failure_.empty(); }

 private:
  static void CPL_STDCALL note(CPLErr severity, CPLErrorNum number, const char* message);

  std::string first_failure_;
};

/// While it lives, GDAL knows GeoPackage and GeoJSON too. Otherwise it does not: the mask or the overviews
/// beside a stranger's raster could be a database. Needs a GdalSession.
class FeatureDrivers {
 public:
  FeatureDrivers();
  FeatureDrivers(const FeatureDrivers&) = delete;
  FeatureDrivers& operator=(const FeatureDrivers&) = delete;
  ~FeatureDrivers();
};

/// How a Dataset ends.
struct CloseDataset {
  void operator()(void* dataset) const { GDALClose(dataset); }
};
/// An open raster, of the GDALDatasetH that it holds.
using Dataset = std::unique_ptr<void, CloseDataset>;

/// How a SpatialReference ends.
struct DestroySpatialReference {
  void operator()(void* reference) const { OSRDestroySpatialReference(reference); }
};
/// Axes in the order that pictures use: east before north.
using SpatialReference = std::unique_ptr<void, DestroySpatialReference>;

/// While it lives, GDAL's cache of blocks, 5 % of the machine's memory by itself, has room for a few hundred
/// rows of a raster: of the largest, where several are read at once. Leaves it alone where GDAL_CACHEMAX is
/// set.
class CacheBound {
 public:
  explicit CacheBound(GDALDatasetH raster);
  CacheBound(const CacheBound&) = delete;
  CacheBound& operator=(const CacheBound&) = delete;
  ~CacheBound();

 private:
  bool is_set_ = false;
};

/// The system that WKT, "EPSG:n" or another text that PROJ understands stands for; null if none does. Texts
/// that name files or servers are none.
SpatialReference spatial_reference(const std::string& text);

/// A coordinate system as WKT.
std::string wkt_of(OGRSpatialReferenceH reference);

}  // namespace offing::height_maps
