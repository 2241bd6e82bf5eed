#include "host/io/height_maps/new_raster.h"

#include <array>
#include <memory>

#include <cpl_string.h>
#include <fmt/format.h>

#include "host/base/error.h"

namespace offing::height_maps {
namespace {

struct DestroyList {
  void operator()(char** list) const { CSLDestroy(list); }
};
using StringList = std::unique_ptr<char*, DestroyList>;

}  // namespace

void fail_to_write(const std::filesystem::path& path, const GdalSession& session) {
  throw Error(ErrorKind::file, fmt::format("{}: cannot be written: {}", path.string(), session.failure()),
              "check the room on the disk, or name another file");
}

Dataset create_raster(const NewRaster& raster, const GdalSession& session) {
  const GDALDriverH driver = GDALGetDriverByName("GTiff");
  if (driver == nullptr) fail_to_write(raster.name, session);
  StringList options;
  for (const char* option : raster.options) options.reset(CSLAddString(options.release(), option));
  Dataset dataset(GDALCreate(driver, raster.temporary.c_str(), raster.columns, raster.rows, 1, raster.type,
                             options.get()));
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

}  // namespace offing::height_maps
