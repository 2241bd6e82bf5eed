#pragma once

#include "host/ocean/query/depth_map.h"
#include "host/world/world_terrain.h"

namespace offing::world {

/// How deep the sea is over this ground, as its waves feel it: the map's posts, or every so many that 1024
/// along a side are left, each with the highest ground of those around it, so that nowhere it is deeper than
/// it is; of a map in tiles, the whole map as coarsely as its coarsest tiles have it. Land is no higher than
/// the steepest bed falls between two posts; then slopes are limited (ocean::limit_slopes()). Throws what
/// reading tiles throws.
ocean::DepthMap sea_bed(const TerrainParameters& terrain, double sea_level_m);

/// The mean slope of the cells of a bed that the waterline crosses; 0 if there are none.
double beach_slope(const ocean::DepthMap& bed);

}  // namespace offing::world
