#include "tests/terrain/analysis/gdal_viewshed.h"

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include <gdal.h>
#include <gdal_alg.h>
#include <ogr_srs_api.h>

namespace offing::test {
namespace {

void require(bool is_done, const char* what) {
  if (!is_done) throw std::runtime_error(std::string("GDAL: ") + what);
}

/// WGS 84, UTM, only for the size of its ellipsoid.
void set_reference(GDALDatasetH dataset) {
  const OGRSpatialReferenceH reference = OSRNewSpatialReference(nullptr);
  const bool is_set =
      OSRImportFromEPSG(reference, 32610) == OGRERR_NONE && GDALSetSpatialRef(dataset, reference) == CE_None;
  OSRDestroySpatialReference(reference);
  require(is_set, "no reference system");
}

}  // namespace

void GdalViewshed::CloseDataset::operator()(void* dataset) const {
  GDALClose(dataset);
}

GdalViewshed::GdalViewshed(const offing::HeightMap& map) : columns_(map.columns), rows_(map.rows) {
  GDALAllRegister();
  heights_.reset(GDALCreate(GDALGetDriverByName("MEM"), "", columns_, rows_, 1, GDT_Float32, nullptr));
  require(heights_ != nullptr, "no dataset");
  std::array<double, 6> corner{-0.5 * map.spacing_x_m, map.spacing_x_m, 0.0, 0.5 * map.spacing_z_m, 0.0,
                               -map.spacing_z_m};
  require(GDALSetGeoTransform(heights_.get(), corner.data()) == CE_None, "no place");
  set_reference(heights_.get());
  // GDAL takes what it only reads without const.
  auto* const values = const_cast<float*>(map.heights_m.data());
  require(GDALRasterIO(GDALGetRasterBand(heights_.get(), 1), GF_Write, 0, 0, columns_, rows_, values,
                       columns_, rows_, GDT_Float32, 0, 0) == CE_None,
          "no heights");
}

std::vector<std::uint8_t> GdalViewshed::at(const terrain::ViewshedParameters& parameters) const {
  const bool is_curved = std::isfinite(parameters.curve.radius_m);
  const double farthest_m = std::isfinite(parameters.radius_m) ? parameters.radius_m : 0.0;
  const std::unique_ptr<void, CloseDataset> seen(
      GDALViewshedGenerate(GDALGetRasterBand(heights_.get(), 1), "MEM", "", nullptr, parameters.observer_x_m,
                           -parameters.observer_z_m, parameters.observer_height_m, parameters.target_height_m,
                           255.0, 0.0, 0.0, -1.0, is_curved ? 1.0 - parameters.curve.refraction : 0.0,
                           GVM_Edge, farthest_m, nullptr, nullptr, GVOT_NORMAL, nullptr));
  require(seen != nullptr, "no viewshed");
  require(GDALGetRasterXSize(seen.get()) == columns_ && GDALGetRasterYSize(seen.get()) == rows_,
          "a part of the map");
  std::vector<std::uint8_t> answers(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  require(GDALRasterIO(GDALGetRasterBand(seen.get(), 1), GF_Read, 0, 0, columns_, rows_, answers.data(),
                       columns_, rows_, GDT_Byte, 0, 0) == CE_None,
          "no answers");
  return answers;
}

}  // namespace offing::test
