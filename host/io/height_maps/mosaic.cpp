#include "host/io/height_maps/mosaic.h"

#include <algorithm>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include <cpl_vsi.h>
#include <fmt/format.h>
#include <gdal_utils.h>

#include "host/base/error.h"
#include "host/io/height_maps/gdal_session.h"
#include "host/io/height_maps/raster_file.h"

namespace offing::height_maps {

Mosaic::Mosaic(const std::filesystem::path& folder, Trust trust)
    : path_(fmt::format("{}{}/mosaic.vrt", own_memory, static_cast<const void*>(this))) {
  const GdalSession session;
  std::vector<std::string> names;
  bool has_real_grids = false;
  std::error_code status, of_file;
  for (std::filesystem::directory_iterator entry(folder, status), end; !status && entry != end;
       entry.increment(status)) {
    const std::filesystem::path file = std::filesystem::absolute(entry->path());
    if (!entry->is_regular_file(of_file) || !is_plain_raster(file)) continue;
    if (trust == Trust::untrusted) require_below(folder, file);
    has_real_grids = is_real_grid(file, trust) || has_real_grids;
    names.push_back(file.string());
  }
  if (status) {
    throw Error(ErrorKind::file, fmt::format("{}: cannot be read: {}", folder.string(), status.message()),
                "check the permissions of the folder");
  }
  if (names.empty()) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected a folder of height maps, found none in it", folder.string()),
                "give a folder of GeoTIFF or HGT tiles, or a file");
  }
  std::sort(names.begin(), names.end());
  std::vector<const char*> pointers;
  for (const std::string& name : names) pointers.push_back(name.c_str());
  // A raster that does not fit in is an error, not left out.
  char strict[] = "-strict", option[] = "-oo", as_real[] = "DATATYPE=Float64";
  char* arguments[] = {strict, has_real_grids ? option : nullptr, as_real, nullptr};
  const std::unique_ptr<GDALBuildVRTOptions, void (*)(GDALBuildVRTOptions*)> options(
      GDALBuildVRTOptionsNew(arguments, nullptr), GDALBuildVRTOptionsFree);
  int is_wrong = 0;
  const Dataset mosaic(GDALBuildVRT(path_.c_str(), static_cast<int>(pointers.size()), nullptr,
                                    pointers.data(), options.get(), &is_wrong));
  if (!mosaic || is_wrong != 0) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("{}: expected height maps that fit together, found {} that do not all fit: {}",
                    folder.string(), names.size(), session.failure()),
        "convert them to one coordinate system with gdalwarp, and move other rasters out of the folder");
  }
}

Mosaic::~Mosaic() {
  VSIUnlink(path_.c_str());
}

}  // namespace offing::height_maps
