// Lakes by a flood of the posts from the lowest on (Barnes, Lehman & Mulla 2014, Priority-flood).
#include "host/terrain/lakes/lake.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <queue>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/terrain/field/post_grid.h"

namespace offing::terrain {
namespace {

// A bit of memory each, and a byte where they are in the box around the lake.
constexpr double most_map_posts = 1 << 30;
constexpr std::size_t posts_between_polls = 1 << 16;

struct LakePost {
  int column, row;
};

/// A way from post to post, or off the map.
struct LakeStep {
  double height_m;  ///< of the highest place on the way
  LakePost to;
  glm::dvec2 highest;  ///< where that is, in posts
  bool operator>(const LakeStep& other) const { return height_m > other.height_m; }
};

class LakeFlood {
 public:
  LakeFlood(const TerrainPosts& posts, const Work& work)
      : posts_(posts),
        work_(work),
        is_seen_(static_cast<std::size_t>(posts.columns) * static_cast<std::size_t>(posts.rows)) {}

  double height_m(const LakePost& post) const { return posts_.height_m(post.column, post.row); }
  bool is_on_edge(const LakePost& post) const {
    return post.column == 0 || post.row == 0 || post.column == posts_.columns - 1 ||
           post.row == posts_.rows - 1;
  }
  bool is_seen(const LakePost& post) const { return is_seen_[index(post)]; }
  /// False from the second time on. Throws what the work's poll() throws.
  bool see(const LakePost& post) {
    const std::size_t at = index(post);
    if (is_seen_[at]) return false;
    is_seen_[at] = true;
    if (++seen_ % posts_between_polls == 0) work_.poll();
    return true;
  }
  std::size_t seen() const { return seen_; }
  void forget() {
    std::fill(is_seen_.begin(), is_seen_.end(), false);
    seen_ = 0;
  }

  /// From a post that is not on the map's edge: along the sides of cells, and over the saddles within them.
  template <class Take>
  void steps_from(const LakePost& from, const Take& take) const {
    const double here_m = height_m(from);
    const auto side = [&](int right, int down) {
      const LakePost to{from.column + right, from.row + down};
      const double to_m = height_m(to);
      const LakePost& highest = to_m > here_m ? to : from;
      take(LakeStep{std::max(here_m, to_m), to, glm::dvec2(highest.column, highest.row)});
      return to_m;
    };
    const double east_m = side(1, 0), west_m = side(-1, 0), south_m = side(0, 1), north_m = side(0, -1);
    for (const int right : {-1, 1}) {
      for (const int down : {-1, 1}) {
        const LakePost to{from.column + right, from.row + down};
        const double to_m = height_m(to), beside_m = right > 0 ? east_m : west_m,
                     below_m = down > 0 ? south_m : north_m;
        if (std::max(here_m, to_m) >= std::min(beside_m, below_m)) continue;
        // A bilinear patch is level along both axes where its slopes are 0.
        const double c = here_m + to_m - beside_m - below_m;
        const glm::dvec2 saddle((here_m - below_m) / c, (here_m - beside_m) / c);
        take(LakeStep{(here_m * to_m - beside_m * below_m) / c, to,
                      glm::dvec2(from.column + right * saddle.x, from.row + down * saddle.y)});
      }
    }
  }

 private:
  std::size_t index(const LakePost& post) const {
    return static_cast<std::size_t>(post.row) * static_cast<std::size_t>(posts_.columns) +
           static_cast<std::size_t>(post.column);
  }

  const TerrainPosts& posts_;
  const Work& work_;
  std::vector<bool> is_seen_;
  std::size_t seen_ = 0;
};

/// The corner of a place's patch to which its ground falls: from anywhere on a bilinear patch, first along x.
LakePost corner_below(const TerrainPosts& posts, double x_m, double z_m) {
  const double x = place_in_posts(x_m, posts.spacing_x_m, posts.columns),
               z = place_in_posts(z_m, posts.spacing_z_m, posts.rows);
  const int column = std::clamp(static_cast<int>(x), 0, posts.columns - 2),
            row = std::clamp(static_cast<int>(z), 0, posts.rows - 2);
  const auto height_m = [&](int right, int down) {
    return static_cast<double>(posts.height_m(column + right, row + down));
  };
  const double down = z - row;
  const int right =
      std::lerp(height_m(1, 0), height_m(1, 1), down) < std::lerp(height_m(0, 0), height_m(0, 1), down);
  return {column + right, row + (height_m(right, 1) < height_m(right, 0) ? 1 : 0)};
}

[[noreturn]] void refuse_lake(std::string_view name, const std::string& expected, const std::string& hint) {
  throw Error(ErrorKind::bad_input, fmt::format("{}: expected {}", name, expected), hint);
}

/// The lowest way off the map.
LakeStep spill_of(LakeFlood& flood, const LakePost& start, std::string_view name, std::size_t most_posts) {
  std::priority_queue<LakeStep, std::vector<LakeStep>, std::greater<>> ways;
  std::queue<LakePost> below;  // no higher than the highest place so far
  LakeStep highest{flood.height_m(start), start, glm::dvec2(start.column, start.row)};
  flood.see(start);
  below.push(start);
  while (!below.empty() || !ways.empty()) {
    LakePost post;
    if (!below.empty()) {
      post = below.front();
      below.pop();
    } else {
      const LakeStep way = ways.top();
      ways.pop();
      post = way.to;
      // Over a saddle, to where another way was lower.
      if (way.height_m > flood.height_m(post) && !flood.see(post)) continue;
      if (way.height_m > highest.height_m) highest = way;
    }
    if (flood.is_on_edge(post)) break;
    if (flood.seen() > most_posts) {
      refuse_lake(name, fmt::format("a basin of at most {} posts of the map, found more", most_posts),
                  "choose a place in a smaller basin, or use a coarser map");
    }
    flood.steps_from(post, [&](const LakeStep& step) {
      if (flood.is_seen(step.to)) return;
      const bool is_below = step.height_m <= highest.height_m;
      // No other way there is lower.
      if (is_below || step.height_m <= flood.height_m(step.to)) flood.see(step.to);
      if (is_below) {
        below.push(step.to);
      } else {
        ways.push(step);
      }
    });
  }
  return highest;
}

std::vector<LakePost> posts_below(LakeFlood& flood, const LakePost& start, double level_m) {
  flood.forget();
  std::vector<LakePost> wet{start};
  flood.see(start);
  for (std::size_t next = 0; next < wet.size(); ++next) {
    flood.steps_from(LakePost(wet[next]), [&](const LakeStep& step) {
      if (step.height_m < level_m && flood.see(step.to)) wet.push_back(step.to);
    });
  }
  return wet;
}

/// Share of a cell below a level, and the mean depth of all of it: by places where its corners are not alike.
std::pair<double, double> water_in_cell(const std::array<double, 4>& corners_m, double level_m) {
  const auto [lowest, highest] = std::minmax_element(corners_m.begin(), corners_m.end());
  const auto& [h00, h10, h01, h11] = corners_m;
  if (*highest <= level_m) return {1.0, level_m - 0.25 * (h00 + h10 + h01 + h11)};
  if (*lowest >= level_m) return {0.0, 0.0};
  constexpr int parts = 16;
  double share = 0.0, depth_m = 0.0;
  for (int row = 0; row < parts; ++row) {
    const double v = (row + 0.5) / parts, west_m = std::lerp(h00, h01, v), east_m = std::lerp(h10, h11, v);
    for (int column = 0; column < parts; ++column) {
      const double below_m = level_m - std::lerp(west_m, east_m, (column + 0.5) / parts);
      if (below_m <= 0.0) continue;
      share += 1.0 / (parts * parts);
      depth_m += below_m / (parts * parts);
    }
  }
  return {share, depth_m};
}

std::array<double, 4> corners_of(const TerrainPosts& posts, int column, int row) {
  return {posts.height_m(column, row), posts.height_m(column + 1, row), posts.height_m(column, row + 1),
          posts.height_m(column + 1, row + 1)};
}

/// Whether water joins the two wet corners of a cell that lie across from each other.
bool is_joined(const std::array<double, 4>& corners_m, double level_m) {
  const auto& [h00, h10, h01, h11] = corners_m;
  const double c = h00 + h11 - h10 - h01;
  return c != 0.0 && (h00 * h11 - h10 * h01) / c < level_m;
}

void measure(Lake& lake, const TerrainPosts& posts, const Work& work) {
  const double cell_m2 = posts.spacing_x_m * posts.spacing_z_m;
  for (int row = lake.first_row; row + 1 < lake.first_row + lake.rows; ++row) {
    work.poll();
    for (int column = lake.first_column; column + 1 < lake.first_column + lake.columns; ++column) {
      const bool has_water = lake.is_wet_at(column, row) || lake.is_wet_at(column + 1, row) ||
                             lake.is_wet_at(column, row + 1) || lake.is_wet_at(column + 1, row + 1);
      if (!has_water) continue;
      const std::array<double, 4> corners_m = corners_of(posts, column, row);
      const auto [share, depth_m] = water_in_cell(corners_m, lake.level_m);
      lake.area_m2 += share * cell_m2;
      lake.volume_m3 += depth_m * cell_m2;
      lake.greatest_depth_m = std::max(lake.greatest_depth_m, lake.level_m - std::ranges::min(corners_m));
    }
  }
}

void require_wet(std::string_view name, const glm::dvec2& place_m, double ground_m, const LakeStep& spill,
                 std::optional<double> level_m) {
  const std::string place = fmt::format("({:.10g}, {:.10g})", place_m.x, place_m.y);
  if (spill.height_m <= ground_m) {
    refuse_lake(
        name,
        fmt::format(
            "a place in a basin, found {}, from where water runs off the map (its ground is at {:.7g} m)",
            place, ground_m),
        "choose a place at the bottom of a hollow");
  }
  if (level_m && *level_m <= ground_m) {
    refuse_lake(name,
                fmt::format("a level above the ground at {}, which is {:.7g} m, found {:.7g} m", place,
                            ground_m, *level_m),
                fmt::format("the lake is full at {:.7g} m", spill.height_m));
  }
  if (level_m && *level_m > spill.height_m) {
    refuse_lake(
        name,
        fmt::format("a level up to its spill level, {:.7g} m, found {:.7g} m, at which water runs off "
                    "the map",
                    spill.height_m, *level_m),
        "leave out the level to fill the lake up to there");
  }
}

}  // namespace

bool Lake::is_wet_at(int column, int row) const {
  const int x = column - first_column, z = row - first_row;
  if (x < 0 || z < 0 || x >= columns || z >= rows) return false;
  return is_wet[static_cast<std::size_t>(z) * static_cast<std::size_t>(columns) +
                static_cast<std::size_t>(x)] != 0;
}

bool Lake::is_near(int column, int row) const {
  for (int z = row - 1; z <= row + 1; ++z) {
    for (int x = column - 1; x <= column + 1; ++x)
      if (is_wet_at(x, z)) return true;
  }
  return false;
}

Lake fill_lake(const TerrainPosts& posts, double x_m, double z_m, std::optional<double> level_m,
               std::string_view name, const Work& work, std::size_t most_posts) {
  if (static_cast<double>(posts.columns) * posts.rows > most_map_posts) {
    refuse_lake(name,
                fmt::format("a map of at most {:.4g} posts, found {} x {}", most_map_posts, posts.columns,
                            posts.rows),
                "cut a smaller map around the lake");
  }
  const std::optional<TerrainPoint> ground = terrain_at(posts, x_m, z_m);
  if (!ground) {
    refuse_lake(name, fmt::format("a place on the map, found ({:.10g}, {:.10g})", x_m, z_m),
                fmt::format("the map reaches {:.7g} m east and {:.7g} m south of its first post",
                            posts.width_m(), posts.depth_m()));
  }
  LakeFlood flood(posts, work);
  const LakePost start = corner_below(posts, x_m, z_m);
  const LakeStep spill = spill_of(flood, start, name, most_posts);
  require_wet(name, {x_m, z_m}, ground->height_m, spill, level_m);
  Lake lake{.level_m = level_m.value_or(spill.height_m),
            .spill_level_m = spill.height_m,
            .spill_m = spill.highest * glm::dvec2(posts.spacing_x_m, posts.spacing_z_m)};
  const std::vector<LakePost> wet = posts_below(flood, start, lake.level_m);
  const auto [west, east] = std::ranges::minmax(wet, {}, &LakePost::column);
  const auto [north, south] = std::ranges::minmax(wet, {}, &LakePost::row);
  lake.first_column = west.column - 1;
  lake.first_row = north.row - 1;
  lake.columns = east.column - west.column + 3;
  lake.rows = south.row - north.row + 3;
  lake.is_wet.resize(static_cast<std::size_t>(lake.columns) * static_cast<std::size_t>(lake.rows));
  for (const LakePost& post : wet) {
    lake.is_wet[static_cast<std::size_t>(post.row - lake.first_row) * static_cast<std::size_t>(lake.columns) +
                static_cast<std::size_t>(post.column - lake.first_column)] = 1;
  }
  measure(lake, posts, work);
  return lake;
}

double nearness_to_lake(const Lake& lake, const TerrainPosts& posts, double x_m, double z_m) {
  const double x = place_in_posts(x_m, posts.spacing_x_m, posts.columns),
               z = place_in_posts(z_m, posts.spacing_z_m, posts.rows);
  const int column = std::clamp(static_cast<int>(x), 0, posts.columns - 2),
            row = std::clamp(static_cast<int>(z), 0, posts.rows - 2);
  const auto near = [&](int right, int down) { return lake.is_near(column + right, row + down) ? 1.0 : 0.0; };
  const double right = x - column;
  return std::lerp(std::lerp(near(0, 0), near(1, 0), right), std::lerp(near(0, 1), near(1, 1), right),
                   z - row);
}

double depth_of_lake(const Lake& lake, const TerrainPosts& posts, double x_m, double z_m) {
  const std::optional<TerrainPoint> ground = terrain_at(posts, x_m, z_m);
  if (!ground || ground->height_m >= lake.level_m) return 0.0;
  const LakePost below = corner_below(posts, x_m, z_m);
  return lake.is_wet_at(below.column, below.row) ? lake.level_m - ground->height_m : 0.0;
}

std::vector<std::vector<glm::dvec2>> outline_of(const Lake& lake, const TerrainPosts& posts) {
  // A side of a cell that the shore crosses, numbered by its western or northern post, and the next one along
  // the shore.
  struct Crossing {
    std::size_t side = 0;
    glm::dvec2 place_m{};
    std::size_t next = 0;
    bool is_left = true;  // to be put into a ring
  };
  const auto columns = static_cast<std::size_t>(lake.columns);
  std::vector<Crossing> crossings;
  const auto post_m = [&](int column, int row) {
    return glm::dvec2((lake.first_column + column) * posts.spacing_x_m,
                      (lake.first_row + row) * posts.spacing_z_m);
  };
  for (int row = 0; row + 1 < lake.rows; ++row) {
    for (int column = 0; column + 1 < lake.columns; ++column) {
      // Clockwise from the north-west.
      const std::array<std::array<int, 2>, 4> corners{
          {{column, row}, {column + 1, row}, {column + 1, row + 1}, {column, row + 1}}};
      std::array<bool, 4> wet{};
      for (std::size_t i = 0; i < 4; ++i)
        wet[i] = lake.is_wet_at(lake.first_column + corners[i][0], lake.first_row + corners[i][1]);
      const auto side = [&](std::size_t i) {
        const auto [c, r] = std::min(corners[i], corners[(i + 1) % 4]);
        return 2 * (static_cast<std::size_t>(r) * columns + static_cast<std::size_t>(c)) + (i % 2);
      };
      const bool is_saddle = wet[0] == wet[2] && wet[1] == wet[3] && wet[0] != wet[1];
      const bool joins =
          is_saddle &&
          is_joined(corners_of(posts, lake.first_column + column, lake.first_row + row), lake.level_m);
      for (std::size_t in = 0; in < 4; ++in) {
        if (wet[in] || !wet[(in + 1) % 4]) continue;
        // Water begins behind this side. With the water on its left the shore goes to where it ends, or where
        // all of the water is joined, back over the dry corner.
        std::size_t out = joins ? (in + 3) % 4 : (in + 1) % 4;
        while (!joins && wet[(out + 1) % 4]) out = (out + 1) % 4;
        const auto& dry = corners[in];
        const auto& below = corners[(in + 1) % 4];
        const double dry_m = posts.height_m(lake.first_column + dry[0], lake.first_row + dry[1]),
                     below_m = posts.height_m(lake.first_column + below[0], lake.first_row + below[1]);
        const double share =
            dry_m > below_m ? std::clamp((lake.level_m - below_m) / (dry_m - below_m), 0.0, 1.0) : 1.0;
        const glm::dvec2 from_m = post_m(below[0], below[1]);
        crossings.push_back({side(in), from_m + share * (post_m(dry[0], dry[1]) - from_m), side(out)});
      }
    }
  }
  std::ranges::sort(crossings, {}, &Crossing::side);
  std::vector<std::vector<glm::dvec2>> rings;
  std::size_t outer = 0;
  double most_m2 = 0.0;
  for (auto first = crossings.begin(); first != crossings.end(); ++first) {
    if (!first->is_left) continue;
    std::vector<glm::dvec2>& ring = rings.emplace_back();
    auto next = first;
    while (next->is_left) {
      ring.push_back(next->place_m);
      next->is_left = false;
      next = std::ranges::lower_bound(crossings, next->next, {}, &Crossing::side);
    }
    ring.push_back(ring.front());
    double twice_m2 = 0.0;
    for (std::size_t i = 0; i + 1 < ring.size(); ++i)
      twice_m2 += ring[i].x * ring[i + 1].y - ring[i + 1].x * ring[i].y;
    if (std::abs(twice_m2) <= most_m2) continue;
    most_m2 = std::abs(twice_m2);
    outer = rings.size() - 1;
  }
  if (!rings.empty()) std::swap(rings.front(), rings[outer]);
  return rings;
}

bool overlap(const Lake& a, const Lake& b) {
  for (int row = std::max(a.first_row, b.first_row);
       row < std::min(a.first_row + a.rows, b.first_row + b.rows); ++row) {
    for (int column = std::max(a.first_column, b.first_column);
         column < std::min(a.first_column + a.columns, b.first_column + b.columns); ++column) {
      if (a.is_wet_at(column, row) && b.is_wet_at(column, row)) return true;
    }
  }
  return false;
}

}  // namespace offing::terrain
