#include "host/terrain/tiles/tile_builder.h"

#include <algorithm>
#include <utility>

namespace offing::terrain {
namespace {

// A row of tiles takes ringed_tile_posts rows; the next begins with the last three of them.
constexpr int rows_kept = ringed_tile_posts + 1;

/// A row of values with ways on beyond its ends.
struct Row {
  const std::vector<float>& values;

  int last() const { return static_cast<int>(values.size()) - 1; }
  float held(int at) const { return values[static_cast<std::size_t>(std::clamp(at, 0, last()))]; }
  /// Straight on for one value, and held from there.
  float straight(int at) const {
    if (at < 0) return 2.0f * held(0) - held(1);
    return at > last() ? 2.0f * held(last()) - held(last() - 1) : held(at);
  }
};

/// What lies half a cell before the mean of a cell, straight on from the next one's.
float before(float mean, float next) {
  return 1.5f * mean - 0.5f * next;
}

/// Of each post the higher of the two cells beside it in a row.
std::vector<float> highest_posts(const std::vector<float>& cells) {
  std::vector<float> posts(cells.size() + 1);
  posts.front() = cells.front();
  posts.back() = cells.back();
  for (std::size_t i = 1; i < cells.size(); ++i) posts[i] = std::max(cells[i - 1], cells[i]);
  return posts;
}

/// Of each post the mean of the two cells beside it in a row.
std::vector<float> mean_posts(const std::vector<float>& cells) {
  const std::size_t last = cells.size() - 1;
  std::vector<float> posts(cells.size() + 1);
  posts.front() = last > 0 ? before(cells[0], cells[1]) : cells[0];
  posts.back() = last > 0 ? before(cells[last], cells[last - 1]) : cells[0];
  for (std::size_t i = 1; i < cells.size(); ++i) posts[i] = 0.5f * (cells[i - 1] + cells[i]);
  return posts;
}

template <class Join>
void join_into(std::vector<float>& values, const std::vector<float>& others, Join join) {
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = join(values[i], others[i]);
}

float higher(float a, float b) {
  return std::max(a, b);
}
float mean(float a, float b) {
  return 0.5f * (a + b);
}

}  // namespace

TileBuilder::TileBuilder(const TileSetShape& shape, std::function<void(HeightTile)> take)
    : shape_(shape),
      take_(std::move(take)),
      levels_(static_cast<std::size_t>(shape.levels)),
      is_void_(rows_kept) {
  for (int level = 0; level < shape.levels; ++level) {
    Level& of = levels_[static_cast<std::size_t>(level)];
    of.posts_x = shape.cells_x(level) + 1;
    of.posts_z = shape.cells_z(level) + 1;
    of.highest_m.resize(rows_kept);
    if (level > 0) of.means_m.resize(rows_kept);
  }
}

void TileBuilder::add_row(std::span<const float> heights_m, std::span<const std::uint8_t> is_void) {
  const bool has_voids =
      std::any_of(is_void.begin(), is_void.end(), [](std::uint8_t each) { return each != 0; });
  is_void_[static_cast<std::size_t>(levels_.front().rows % rows_kept)].assign(
      is_void.begin(), has_voids ? is_void.end() : is_void.begin());
  add_posts(0, heights_m, heights_m);
  if (!row_before_m_.empty() && shape_.levels > 1) {
    const std::size_t cells = heights_m.size() - 1;
    CellRow row{std::vector<float>(cells), std::vector<float>(cells)};
    for (std::size_t i = 0; i < cells; ++i) {
      const float north = higher(row_before_m_[i], row_before_m_[i + 1]),
                  south = higher(heights_m[i], heights_m[i + 1]);
      row.highest_m[i] = higher(north, south);
      row.means_m[i] =
          mean(mean(row_before_m_[i], row_before_m_[i + 1]), mean(heights_m[i], heights_m[i + 1]));
    }
    add_cells_below(1, row);
  }
  row_before_m_.assign(heights_m.begin(), heights_m.end());
}

void TileBuilder::add_cells_below(int level, const CellRow& cells) {
  Level& of = levels_[static_cast<std::size_t>(level)];
  const std::size_t count = (cells.highest_m.size() + 1) / 2, pairs = cells.highest_m.size() / 2;
  CellRow row{std::vector<float>(count, cells.highest_m.back()),
              std::vector<float>(count, cells.means_m.back())};
  for (std::size_t i = 0; i < pairs; ++i) {
    row.highest_m[i] = higher(cells.highest_m[2 * i], cells.highest_m[2 * i + 1]);
    row.means_m[i] = mean(cells.means_m[2 * i], cells.means_m[2 * i + 1]);
  }
  ++of.cell_rows_below;
  const bool is_first = of.cell_rows_below % 2 == 1;
  if (is_first && of.cell_rows_below < shape_.cells_z(level - 1)) {
    of.half = std::move(row);
    return;
  }
  if (!is_first) {
    join_into(row.highest_m, of.half.highest_m, higher);
    join_into(row.means_m, of.half.means_m, mean);
  }
  add_cells(level, row);
}

void TileBuilder::add_cells(int level, const CellRow& cells) {
  Level& of = levels_[static_cast<std::size_t>(level)];
  const int row = of.cell_rows++, last = shape_.cells_z(level) - 1;
  CellRow posts{highest_posts(cells.highest_m), mean_posts(cells.means_m)};
  const auto add_edge = [&](const CellRow& edge, const CellRow& inner) {
    std::vector<float> means_m = edge.means_m;
    join_into(means_m, inner.means_m, before);
    add_posts(level, edge.highest_m, means_m);
  };
  if (last == 0) {
    add_posts(level, posts.highest_m, posts.means_m);
    add_posts(level, posts.highest_m, posts.means_m);
  } else if (row > 0) {
    if (row == 1) add_edge(of.before, posts);
    CellRow between = posts;
    join_into(between.highest_m, of.before.highest_m, higher);
    join_into(between.means_m, of.before.means_m, mean);
    add_posts(level, between.highest_m, between.means_m);
    if (row == last) add_edge(posts, of.before);
  }
  of.before = std::move(posts);
  if (level + 1 < shape_.levels) add_cells_below(level + 1, cells);
}

void TileBuilder::add_posts(int level, std::span<const float> highest_m, std::span<const float> means_m) {
  Level& of = levels_[static_cast<std::size_t>(level)];
  const auto place = static_cast<std::size_t>(of.rows % rows_kept);
  of.highest_m[place].assign(highest_m.begin(), highest_m.end());
  if (level > 0) of.means_m[place].assign(means_m.begin(), means_m.end());
  ++of.rows;
  const auto last_needed = [&] { return std::min((of.next_tiles + 1) * tile_cells + 1, of.posts_z - 1); };
  while (of.next_tiles < shape_.tiles_z(level) && of.rows > last_needed()) {
    cut_tiles(level);
    ++of.next_tiles;
  }
}

void TileBuilder::cut_tiles(int level) {
  const Level& of = levels_[static_cast<std::size_t>(level)];
  const auto& means_m = level > 0 ? of.means_m : of.highest_m;
  const int first_row = of.next_tiles * tile_cells, last_row = of.posts_z - 1;
  const auto kept = [&](const std::vector<std::vector<float>>& rows, int row) {
    return Row{rows[static_cast<std::size_t>(std::clamp(row, 0, last_row) % rows_kept)]};
  };
  for (int column = 0; column < shape_.tiles_x(level); ++column) {
    HeightTile tile{{level, column, of.next_tiles}, {}, {}};
    tile.highest_m.reserve(tile_posts * tile_posts);
    tile.means_m.reserve(ringed_tile_posts * ringed_tile_posts);
    const int first = column * tile_cells;
    for (int row = first_row; row < first_row + tile_posts; ++row) {
      const Row values = kept(of.highest_m, row);
      for (int i = 0; i < tile_posts; ++i) tile.highest_m.push_back(values.held(first + i));
    }
    for (int row = first_row - 1; row <= first_row + tile_posts; ++row) {
      const Row values = kept(means_m, row);
      // The row beyond the edge goes on from the last two.
      const bool is_beyond = row < 0 || row > last_row;
      const Row inner = kept(means_m, row < 0 ? 1 : last_row - 1);
      for (int i = -1; i <= tile_posts; ++i) {
        const float at = values.straight(first + i);
        tile.means_m.push_back(is_beyond ? 2.0f * at - inner.straight(first + i) : at);
      }
    }
    if (level == 0) cut_voids(tile);
    take_(std::move(tile));
  }
}

void TileBuilder::cut_voids(HeightTile& tile) const {
  const int first_row = tile.key.row * tile_cells, first = tile.key.column * tile_cells;
  std::vector<std::uint8_t> mask(static_cast<std::size_t>(tile_posts) * tile_posts);
  bool has_voids = false;
  for (int row = 0; row < std::min(tile_posts, shape_.rows - first_row); ++row) {
    const std::vector<std::uint8_t>& is_void =
        is_void_[static_cast<std::size_t>((first_row + row) % rows_kept)];
    if (is_void.empty()) continue;
    for (int i = 0; i < std::min(tile_posts, shape_.columns - first); ++i) {
      const std::uint8_t here = is_void[static_cast<std::size_t>(first + i)];
      mask[static_cast<std::size_t>(row * tile_posts + i)] = here;
      has_voids = has_voids || here != 0;
    }
  }
  if (has_voids) tile.is_void = std::move(mask);
}

}  // namespace offing::terrain
