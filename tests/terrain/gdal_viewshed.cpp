#include "tests/terrain/gdal_viewshed.h"

#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>

#include <gdal.h>
#include <gdal_alg.h>
#include <ogr_srs_api.h>

namespace offing::test {
namespace {

struct CloseDataset {
  void operator()(void* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<void, CloseDataset>;

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

std::vector<std::uint8_t> gdal_viewshed(const offing::HeightMap& map,
                                        const terrain::ViewshedParameters& parameters) {
  GDALAllRegister();
  const Dataset heights(
      GDALCreate(GDALGetDriverByName("MEM"), "", map.columns, map.rows, 1, GDT_Float32, nullptr));
  require(heights != nullptr, "no dataset");
  std::array<double, 6> corner{-0.5 * map.spacing_x_m, map.spacing_x_m, 0.0, 0.5 * map.spacing_z_m, 0.0,
                               -map.spacing_z_m};
  require(GDALSetGeoTransform(heights.get(), corner.data()) == CE_None, "no place");
  set_reference(heights.get());
  const GDALRasterBandH band = GDALGetRasterBand(heights.get(), 1);
  auto* const values = const_cast<float*>(map.heights_m.data());
  require(GDALRasterIO(band, GF_Write, 0, 0, map.columns, map.rows, values, map.columns, map.rows,
                       GDT_Float32, 0, 0) == CE_None,
          "no heights");
  const bool is_curved = std::isfinite(parameters.curve.radius_m);
  const double farthest_m = std::isfinite(parameters.radius_m) ? parameters.radius_m : 0.0;
  const Dataset seen(GDALViewshedGenerate(band, "MEM", "", nullptr, parameters.observer_x_m,
                                          -parameters.observer_z_m, parameters.observer_height_m,
                                          parameters.target_height_m, 255.0, 0.0, 0.0, -1.0,
                                          is_curved ? 1.0 - parameters.curve.refraction : 0.0, GVM_Edge,
                                          farthest_m, nullptr, nullptr, GVOT_NORMAL, nullptr));
  require(seen != nullptr, "no viewshed");
  std::vector<std::uint8_t> answers(map.heights_m.size());
  require(GDALGetRasterXSize(seen.get()) == map.columns && GDALGetRasterYSize(seen.get()) == map.rows,
          "a part of the map");
  require(GDALRasterIO(GDALGetRasterBand(seen.get(), 1), GF_Read, 0, 0, map.columns, map.rows, answers.data(),
                       map.columns, map.rows, GDT_Byte, 0, 0) == CE_None,
          "no answers");
  return answers;
}

}  // namespace offing::test
