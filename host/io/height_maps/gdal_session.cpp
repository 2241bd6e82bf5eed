#include "host/io/height_maps/gdal_session.h"

#include <mutex>

#include <cpl_conv.h>

#include "host/base/error_report.h"

namespace offing::height_maps {

GdalSession::GdalSession() {
  static std::once_flag once;
  std::call_once(once, GDALAllRegister);
  CPLPushErrorHandlerEx(note, this);
}

GdalSession::~GdalSession() {
  CPLPopErrorHandler();
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
  if (OSRSetFromUserInput(reference.get(), text.c_str()) != OGRERR_NONE) {
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
