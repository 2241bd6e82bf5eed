// The functions of this folder as the module `gdal` has them.
#include "host/io/height_maps/gdal_module.h"
#include "host/io/module.h"

namespace offing {
namespace {

const height_maps::GdalModule& gdal() {
  return module_functions<height_maps::GdalModule>("gdal", "read or write maps");
}

}  // namespace

HeightMapFile read_height_map(const std::filesystem::path& path, const HeightMapOptions& options) {
  return gdal().read_height_map(path, options);
}

void warn_of_assumed_spacing(const std::filesystem::path& path, const HeightMapSource& source) {
  gdal().warn_of_assumed_spacing(path, source);
}

HeightMapSource stream_height_map(const std::filesystem::path& path, const HeightMapOptions& options,
                                  const std::function<void(const HeightMapFile&)>& begin,
                                  const TakeRow& row) {
  return gdal().stream_height_map(path, options, begin, row);
}

ColourMap read_colour_map(const std::filesystem::path& path, const HeightMap& map, const FileTrust& trust) {
  return gdal().read_colour_map(path, map, trust);
}

void write_byte_raster(const std::filesystem::path& path, const ByteRaster& raster, Existing existing) {
  gdal().write_byte_raster(path, raster, existing);
}

void write_post_raster(const std::filesystem::path& path, const PostRaster& raster, Existing existing) {
  gdal().write_post_raster(path, raster, existing);
}

std::unique_ptr<HeightRasterWriter> create_height_raster(const std::filesystem::path& path, int columns,
                                                         int rows, double spacing_m, Existing existing) {
  return gdal().create_height_raster(path, columns, rows, spacing_m, existing);
}

std::unique_ptr<BandedRasterWriter> create_banded_raster(const std::filesystem::path& path,
                                                         const BandedRaster& raster, Existing existing) {
  return gdal().create_banded_raster(path, raster, existing);
}

std::unique_ptr<MapCoordinates> map_coordinates(const MapFrame& map, const std::string& system,
                                                const std::string& flag) {
  return gdal().map_coordinates(map, system, flag);
}

FeatureTable read_features(const std::filesystem::path& path, FeatureShape shape, const std::string& layer) {
  return gdal().read_features(path, shape, layer);
}

std::unique_ptr<FeatureWriter> create_features(const std::filesystem::path& path, const NewFeatures& features,
                                               Existing existing) {
  return gdal().create_features(path, features, existing);
}

std::vector<std::filesystem::path> height_maps::files_of_raster(const std::filesystem::path& path,
                                                                Trust trust) {
  return gdal().files_of_raster(path, trust);
}

}  // namespace offing
