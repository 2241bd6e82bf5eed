#include "host/io/height_maps/raster_files.h"

#include <memory>

#include <cpl_string.h>

#include "host/base/error.h"
#include "host/io/height_maps/raster_file.h"

namespace offing::height_maps {

std::vector<std::filesystem::path> raster_files(const std::filesystem::path& path) {
  const GdalSession session;
  Dataset dataset;
  try {
    dataset = open_raster(path, {});
  } catch (const Error&) {
    return {};  // whoever reads it says what is wrong
  }
  if (!dataset) return {};
  const std::unique_ptr<char*, void (*)(char**)> names(GDALGetFileList(dataset.get()), CSLDestroy);
  std::vector<std::filesystem::path> files;
  for (char** name = names.get(); name != nullptr && *name != nullptr; ++name) files.emplace_back(*name);
  return files;
}

}  // namespace offing::height_maps
