#include "host/io/height_maps/raster_files.h"

#include <cpl_string.h>

#include "host/io/height_maps/gdal_session.h"

namespace offing::height_maps {

std::vector<std::filesystem::path> raster_files(const std::filesystem::path& path) {
  const GdalSession session;
  const Dataset dataset(
      GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr));
  if (!dataset) return {};
  char** const list = GDALGetFileList(dataset.get());
  std::vector<std::filesystem::path> files;
  for (char** name = list; name != nullptr && *name != nullptr; ++name) files.emplace_back(*name);
  CSLDestroy(list);
  return files;
}

}  // namespace offing::height_maps
