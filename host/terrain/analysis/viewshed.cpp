#include "host/terrain/analysis/viewshed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <span>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/ocl/program.h"
#include "host/terrain/cast/image_rays.h"
#include "kernels/shared/terrain_sight.h"

namespace offing::terrain {
namespace {

constexpr double highest_above_m = 1e6;
constexpr std::size_t octants = 8;

void require(bool is_valid, const char* name, const char* expected, double found) {
  if (is_valid) return;
  throw Error(ErrorKind::bad_input,
              fmt::format("viewshed: {}: expected {}, found {:g}", name, expected, found),
              "give a number within that range");
}

/// A place in cells to 2^-20, so that its fraction, and 1 less that, are floats.
double on_lattice(double cells) {
  return std::round(cells * 0x1p20) * 0x1p-20;
}

/// Copies two posts that lie side by side, the first of which this is.
using ReadPosts = std::function<void(std::size_t first, std::span<float, 2> heights_m)>;

/// The ground under a place in cells.
double terrain_m(const PostGrid& grid, const ReadPosts& read, double x, double z) {
  const int column = std::min(static_cast<int>(x), grid.columns - 2);
  const int row = std::min(static_cast<int>(z), grid.rows - 2);
  const auto edge_m = [&](int of_row) {
    std::array<float, 2> heights_m{};
    read(static_cast<std::size_t>(of_row) * static_cast<std::size_t>(grid.columns) +
             static_cast<std::size_t>(column),
         heights_m);
    return std::lerp(static_cast<double>(heights_m[0]), static_cast<double>(heights_m[1]), x - column);
  };
  return std::lerp(edge_m(row), edge_m(row + 1), z - row);
}

TerrainSight sight_over(const PostGrid& grid, const ViewshedParameters& parameters, const ReadPosts& read) {
  require_valid(parameters, grid);
  const double x = on_lattice((parameters.observer_x_m - grid.origin_x_m) / grid.spacing_x_m);
  const double z = on_lattice((parameters.observer_z_m - grid.origin_z_m) / grid.spacing_z_m);
  const double eye_m = terrain_m(grid, read, x, z) + parameters.observer_height_m;
  const auto eye_float_m = static_cast<float>(eye_m);
  const double bend_perm = parameters.curve.bend_perm(), radius_m = parameters.radius_m;
  const auto squared = [](double value) { return static_cast<float>(value * value); };
  return {.cell_x = static_cast<int>(x),
          .cell_z = static_cast<int>(z),
          .fraction_x = static_cast<float>(x - std::floor(x)),
          .fraction_z = static_cast<float>(z - std::floor(z)),
          .eye_m = eye_float_m,
          .eye_rest_m = static_cast<float>(eye_m - static_cast<double>(eye_float_m)),
          .eye_above_m = static_cast<float>(parameters.observer_height_m),
          .target_above_m = static_cast<float>(parameters.target_height_m),
          .bend_x_m = static_cast<float>(bend_perm * grid.spacing_x_m * grid.spacing_x_m),
          .bend_z_m = static_cast<float>(bend_perm * grid.spacing_z_m * grid.spacing_z_m),
          .radius_share_x = squared(grid.spacing_x_m / radius_m),
          .radius_share_z = squared(grid.spacing_z_m / radius_m)};
}
}  // namespace

void require_valid(const ViewshedParameters& parameters, const PostGrid& grid) {
  const double x_m = parameters.observer_x_m - grid.origin_x_m,
               z_m = parameters.observer_z_m - grid.origin_z_m;
  require(x_m >= 0.0 && x_m <= grid.spacing_x_m * (grid.columns - 1), "observer_x_m",
          "a place within the map", parameters.observer_x_m);
  require(z_m >= 0.0 && z_m <= grid.spacing_z_m * (grid.rows - 1), "observer_z_m", "a place within the map",
          parameters.observer_z_m);
  const auto require_height = [](const char* name, double height_m) {
    require(height_m >= 0.0 && height_m <= highest_above_m, name, "0 ... 1e6 m", height_m);
  };
  require_height("observer_height_m", parameters.observer_height_m);
  require_height("target_height_m", parameters.target_height_m);
  require(parameters.radius_m > 0.0, "radius_m", "above 0 m", parameters.radius_m);
  require_valid(parameters.curve);
}

Viewshed::Viewshed(const ocl::Device& device)
    : rays_(ray_tuning(device)),
      walk_(
          ocl::Program::build(device, "terrain/sight_walk.cl",
                              ocl::Defines().set("LANES", rays_.lanes).set("UP_RULE", TERRAIN_UP_WITH_PARENT))
              .kernel("sight_walk")) {
  if (rays_.shape == ocl::KernelShape::simd) {
    sweep_ = ocl::Program::build(device, "terrain/horizon_sweep.cl", ocl::Defines().set("LANES", rays_.lanes))
                 .kernel("horizon_sweep");
  }
}

TerrainSight Viewshed::sight_from(const PostGrid& grid, std::span<const float> heights_m,
                                  const ViewshedParameters& parameters) {
  return sight_over(grid, parameters, [&](std::size_t first, std::span<float, 2> two_m) {
    std::ranges::copy(heights_m.subspan(first, 2), two_m.begin());
  });
}

void Viewshed::at(const HeightField& field, const ViewshedParameters& parameters,
                  ocl::Buffer<std::uint8_t>& seen) const {
  const auto read = [&](std::size_t first, std::span<float, 2> two_m) {
    field.heights_m().read(two_m, first);
  };
  at(field, sight_over(field.grid(), parameters, read), seen);
}

void Viewshed::at(const HeightField& field, const TerrainSight& sight,
                  ocl::Buffer<std::uint8_t>& seen) const {
  const PostGrid& grid = field.grid();
  const auto columns = static_cast<std::size_t>(grid.columns), rows = static_cast<std::size_t>(grid.rows);
  require_room("viewshed", columns * rows, seen.size());
  seen.fill(SIGHT_UNDECIDED);
  const bool is_simd = rays_.shape == ocl::KernelShape::simd;
  if (is_simd) {
    // Rays a line of posts, and two aside.
    const std::size_t wedges = std::max(columns, rows) + 2,
                      wedges_each = SIGHT_FINE_PARTS * (static_cast<std::size_t>(rays_.lanes) - 1);
    sweep_.launch({{wedges / wedges_each + 1, octants}, {rays_.group}}, field.heights_m(),
                  field.pyramid().maxima_m(), field.device_field(CastMethod::parity), sight, seen);
  }
  // Few lines are left of a row, which fill vectors only together.
  const std::size_t columns_each = is_simd ? columns : 1;
  const ocl::LaunchShape shape =
      is_simd ? ocl::LaunchShape{{1, rows}, {rays_.group}} : ocl::LaunchShape{{columns, rows}};
  walk_.launch(shape, field.heights_m(), field.pyramid().maxima_m(), field.device_field(CastMethod::parity),
               sight, static_cast<int>(columns_each), seen);
}

}  // namespace offing::terrain
