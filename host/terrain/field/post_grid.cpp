// The posts of height fields: their limits, and places among them.
#include "host/terrain/field/post_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "host/base/error.h"

namespace offing::terrain {
namespace {

constexpr int most_posts_a_side = 1 << 20;
constexpr long long most_posts = 1LL << 30;
constexpr double past_last_post = 1.0 + 2.0 * std::numeric_limits<double>::epsilon();

[[noreturn]] void refuse(const std::string& what, const std::string& hint) {
  throw Error(ErrorKind::bad_input, what, hint);
}

void require_posts(const char* name, int count) {
  if (count >= 2 && count <= most_posts_a_side) return;
  refuse(fmt::format("height field: {}: expected 2 ... {}, found {}", name, most_posts_a_side, count),
         "give a map of at least 2 x 2 posts");
}

void require_spacing(const char* name, double spacing_m) {
  if (std::isfinite(spacing_m) && spacing_m > 0.0) return;
  refuse(fmt::format("height field: {}: expected a finite distance above 0, found {:g}", name, spacing_m),
         "give the distance of neighbouring posts in metres");
}

}  // namespace

void require_valid(const PostGrid& grid) {
  require_posts("columns", grid.columns);
  require_posts("rows", grid.rows);
  if (static_cast<long long>(grid.columns) * grid.rows > most_posts) {
    refuse(fmt::format("height field: expected at most {} posts, found {} x {}", most_posts, grid.columns,
                       grid.rows),
           "cut the map into parts");
  }
  require_spacing("spacing_x_m", grid.spacing_x_m);
  require_spacing("spacing_z_m", grid.spacing_z_m);
  for (const double origin_m : {grid.origin_x_m, grid.origin_z_m}) {
    if (!std::isfinite(origin_m)) {
      refuse(fmt::format("height field: origin: expected finite metres, found {:g}", origin_m),
             "give the position of the first post");
    }
  }
}

PostGrid post_grid(const HeightMap& map) {
  return {.columns = map.columns,
          .rows = map.rows,
          .spacing_x_m = map.spacing_x_m,
          .spacing_z_m = map.spacing_z_m};
}

double place_in_posts(double from_first_m, double spacing_m, int posts) {
  const double place = from_first_m / spacing_m, last = posts - 1;
  return place > last && place <= past_last_post * last ? last : place;
}

glm::dvec2 cells_of(const PostGrid& grid, double x_m, double z_m) {
  return {place_in_posts(x_m - grid.origin_x_m, grid.spacing_x_m, grid.columns),
          place_in_posts(z_m - grid.origin_z_m, grid.spacing_z_m, grid.rows)};
}

double cells_beyond(const PostGrid& grid, double x_m, double z_m) {
  const glm::dvec2 place = cells_of(grid, x_m, z_m);
  return std::max({0.0, -place.x, place.x - (grid.columns - 1), -place.y, place.y - (grid.rows - 1)});
}

}  // namespace offing::terrain
