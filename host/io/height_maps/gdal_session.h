#pragma once

#include <memory>
#include <string>

#include <cpl_error.h>
#include <gdal.h>
#include <ogr_srs_api.h>

namespace offing::height_maps {

/// Collects what GDAL complains about while it lives, instead of letting it print; the drivers are there.
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

struct CloseDataset {
  void operator()(void* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<void, CloseDataset>;

struct DestroySpatialReference {
  void operator()(void* reference) const { OSRDestroySpatialReference(reference); }
};
/// Axes in the order that pictures use: east before north.
using SpatialReference = std::unique_ptr<void, DestroySpatialReference>;

/// The system that WKT, "EPSG:n" or another text that PROJ understands stands for; null if none does.
SpatialReference spatial_reference(const std::string& text);

/// A coordinate system as WKT.
std::string wkt_of(OGRSpatialReferenceH reference);

}  // namespace offing::height_maps
