#pragma once

#include <vector>

#include "host/base/height_tile.h"

namespace offing::terrain {

/// What a map does beyond its edges.
enum class MapEdge {
  ends,     ///< there is nothing
  repeats,  ///< it begins again
  mirrors,  ///< it goes back
};

/// A map as its tiles have it.
struct TiledMap {
  TileSetShape shape;
  double spacing_x_m = 1.0, spacing_z_m = 1.0;
  float lowest_m = 0.0f, highest_m = 0.0f;
  MapEdge edge = MapEdge::ends;
  double origin_x_m = 0.0, origin_z_m = 0.0;  ///< of the first post

  double width_m() const { return spacing_x_m * (shape.columns - 1); }
  double depth_m() const { return spacing_z_m * (shape.rows - 1); }
};

/// From where tiles are looked at, and how closely.
struct CutView {
  double eye_x_m = 0.0, eye_z_m = 0.0;
  double above_m = 0.0;     ///< of the eye over the map's highest post, at least 0
  double pixel_rad = 1e-3;  ///< angle that a pixel sees
};

/// Tiles that cover the map once, each so coarse that a cell is at most about a pixel wide, and at most
/// `most_tiles` (or as many as the coarsest level has): where they do not suffice, all are coarser by the
/// same factor. Those that are seen most coarsely come first.
std::vector<TileKey> choose_cut(const TiledMap& map, const CutView& view, std::size_t most_tiles);

}  // namespace offing::terrain
