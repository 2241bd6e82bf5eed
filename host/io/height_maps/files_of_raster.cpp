#include "host/io/height_maps/files_of_raster.h"

#include "host/base/error.h"
#include "host/io/height_maps/raster_file.h"

namespace offing::height_maps {

std::vector<std::filesystem::path> files_of_raster(const std::filesystem::path& path, Trust trust) {
  const GdalSession session;
  try {
    const Dataset raster = open_raster(path, {.trust = trust});
    return raster ? files_of_dataset(raster.get()) : std::vector<std::filesystem::path>();
  } catch (const Error&) {
    return {};  // whoever reads it says what is wrong
  }
}

}  // namespace offing::height_maps
