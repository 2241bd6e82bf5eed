#pragma once

#include <memory>

#include "host/io/height_maps/files_of_raster.h"
#include "host/io/height_maps/map_coordinates.h"
#include "host/io/height_maps/map_features.h"
#include "host/io/height_maps/new_raster.h"
#include "host/io/height_maps/read_colour_map.h"
#include "host/io/height_maps/read_height_map.h"

namespace offing::height_maps {

/// The functions of the module `gdal`.
struct GdalModule {
  decltype(&offing::read_height_map) read_height_map;
  decltype(&offing::warn_of_assumed_spacing) warn_of_assumed_spacing;
  decltype(&offing::stream_height_map) stream_height_map;
  decltype(&offing::read_colour_map) read_colour_map;
  decltype(&offing::write_byte_raster) write_byte_raster;
  decltype(&offing::write_post_raster) write_post_raster;
  decltype(&offing::create_height_raster) create_height_raster;
  decltype(&offing::create_banded_raster) create_banded_raster;
  decltype(&offing::map_coordinates) map_coordinates;
  decltype(&offing::read_features) read_features;
  decltype(&offing::create_features) create_features;
  decltype(&height_maps::files_of_raster) files_of_raster;
};

}  // namespace offing::height_maps
