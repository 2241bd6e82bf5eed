#include "host/io/height_maps/gdal_module.h"

#include "host/io/module.h"

namespace offing::height_maps {
namespace {

constexpr GdalModule table{.read_height_map = read_height_map,
                           .warn_of_assumed_spacing = warn_of_assumed_spacing,
                           .stream_height_map = stream_height_map,
                           .read_colour_map = read_colour_map,
                           .write_byte_raster = write_byte_raster,
                           .write_post_raster = write_post_raster,
                           .create_height_raster = create_height_raster,
                           .create_banded_raster = create_banded_raster,
                           .map_coordinates = map_coordinates,
                           .read_features = read_features,
                           .create_features = create_features,
                           .files_of_raster = files_of_raster};

}  // namespace
}  // namespace offing::height_maps

OFFING_MODULE(offing::height_maps::table);
