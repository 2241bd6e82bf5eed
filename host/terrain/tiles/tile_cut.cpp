#include "host/terrain/tiles/tile_cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>

namespace offing::terrain {
namespace {

/// From a place to an interval, of which an infinite map has many.
double distance_to(double place, double from, double to, double side, MapEdge edge) {
  const auto plain = [&place](double low, double high) { return std::max({low - place, place - high, 0.0}); };
  double distance = plain(from, to);
  if (edge == MapEdge::ends) return distance;
  // Of the copies those around the one that the place is in.
  const double period = edge == MapEdge::repeats ? side : 2.0 * side;
  place -= std::floor(place / period) * period;
  distance = std::numeric_limits<double>::infinity();
  for (const double moved : {-period, 0.0, period}) {
    distance = std::min(distance, plain(from + moved, to + moved));
    if (edge == MapEdge::mirrors) distance = std::min(distance, plain(moved - to, moved - from));
  }
  return distance;
}

struct Candidate {
  double pixels;  ///< that a cell covers
  TileKey key;

  bool operator<(const Candidate& other) const {
    return pixels != other.pixels ? pixels < other.pixels : key > other.key;
  }
};

class Cut {
 public:
  Cut(const TiledMap& map, const CutView& view) : map_(map), view_(view) {}

  Candidate candidate(const TileKey& key) const {
    const double scale = std::ldexp(1.0, key.level), tile = scale * tile_cells;
    const double x = distance_to(view_.eye_x_m - map_.origin_x_m, tile * key.column * map_.spacing_x_m,
                                 tile * (key.column + 1) * map_.spacing_x_m, map_.width_m(), map_.edge);
    const double z = distance_to(view_.eye_z_m - map_.origin_z_m, tile * key.row * map_.spacing_z_m,
                                 tile * (key.row + 1) * map_.spacing_z_m, map_.depth_m(), map_.edge);
    const double distance_m = std::max(std::hypot(x, z, view_.above_m), 1e-3);
    return {scale * std::max(map_.spacing_x_m, map_.spacing_z_m) / (distance_m * view_.pixel_rad), key};
  }

  std::vector<TileKey> children(const TileKey& key) const {
    const int level = key.level - 1;
    std::vector<TileKey> found;
    for (int row = 2 * key.row; row < std::min(2 * key.row + 2, map_.shape.tiles_z(level)); ++row) {
      for (int column = 2 * key.column; column < std::min(2 * key.column + 2, map_.shape.tiles_x(level));
           ++column) {
        found.push_back({level, column, row});
      }
    }
    return found;
  }

 private:
  const TiledMap& map_;
  const CutView& view_;
};

}  // namespace

std::vector<TileKey> choose_cut(const TiledMap& map, const CutView& view, std::size_t most_tiles) {
  const Cut cut(map, view);
  std::priority_queue<Candidate> open;
  const int coarsest = map.shape.coarsest();
  for (int row = 0; row < map.shape.tiles_z(coarsest); ++row) {
    for (int column = 0; column < map.shape.tiles_x(coarsest); ++column) {
      open.push(cut.candidate({coarsest, column, row}));
    }
  }
  std::vector<Candidate> chosen;
  while (!open.empty()) {
    const Candidate next = open.top();
    open.pop();
    const std::vector<TileKey> children =
        next.key.level > 0 ? cut.children(next.key) : std::vector<TileKey>{};
    const bool has_room = open.size() + chosen.size() + children.size() <= most_tiles;
    if (next.pixels <= 1.0 || children.empty() || !has_room) {
      chosen.push_back(next);
    } else {
      for (const TileKey& key : children) open.push(cut.candidate(key));
    }
  }
  std::sort(chosen.begin(), chosen.end(), [](const Candidate& a, const Candidate& b) { return b < a; });
  std::vector<TileKey> keys;
  for (const Candidate& candidate : chosen) keys.push_back(candidate.key);
  return keys;
}

}  // namespace offing::terrain
