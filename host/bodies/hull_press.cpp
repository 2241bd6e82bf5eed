#include "host/bodies/hull_press.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>

#include "host/ocl/program.h"
#include "host/ocl/tuning.h"

namespace offing::bodies {
namespace {

constexpr int levels = 128;
// Of a hull's upright shadow: one that lies on its side casts less, and presses as if it stood upright.
constexpr double least_shadow = 0.3;
constexpr double cells_of_tent = 1.0;

/// What the map's underside displaces up to each of the levels.
std::vector<double> volumes_below(const HullMap& map, double lowest_m, double step_m) {
  std::vector<double> volumes_m3(levels, 0.0);
  for (const float bottom_m : map.bottom_m) {
    if (bottom_m == std::numeric_limits<float>::infinity()) continue;
    for (int i = 0; i < levels; ++i) {
      volumes_m3[static_cast<std::size_t>(i)] +=
          std::max(0.0, lowest_m + i * step_m - static_cast<double>(bottom_m)) * map.cell_x_m * map.cell_z_m;
    }
  }
  return volumes_m3;
}

/// Along and across the hull by its axes' shadows on the water plane: columns are body x and z.
glm::dmat2 shadow_of(const glm::dmat3& axes) {
  const glm::dmat2 shadow({axes[0].x, axes[0].z}, {axes[2].x, axes[2].z});
  if (glm::determinant(shadow) >= least_shadow) return shadow;
  const double heading_rad = std::atan2(axes[0].z, axes[0].x);
  return {{std::cos(heading_rad), std::sin(heading_rad)}, {-std::sin(heading_rad), std::cos(heading_rad)}};
}

/// Side of the largest square of at most this many cells whose side is a power of two.
std::size_t side_of(std::size_t cells) {
  std::size_t side = 1;
  while (4 * side * side <= cells) side *= 2;
  return side;
}

}  // namespace

HullPresser::HullPresser(const ocl::Device& device, const HullMap& map, const glm::dvec3& mass_centre_m)
    : kernel_(ocl::Program::build(device, "bodies/hull_press.cl").kernel("hull_press")),
      group_side_(side_of(ocl::tuning_for(device.info(), "hull_press").group)),
      bottom_(device, map.bottom_m, "hull's underside"),
      low_x_m_(map.low_x_m),
      low_z_m_(map.low_z_m),
      cell_x_m_(map.cell_x_m),
      cell_z_m_(map.cell_z_m),
      mass_centre_m_(mass_centre_m) {
  lowest_m_ = *std::min_element(map.bottom_m.begin(), map.bottom_m.end());
  const double highest_m = *std::max_element(map.rim_m.begin(), map.rim_m.end());
  level_step_m_ = std::max(highest_m - lowest_m_, 1e-6) / (levels - 1);
  volumes_m3_ = volumes_below(map, lowest_m_, level_step_m_);
}

double HullPresser::level_m(double displaced_m3) const {
  const auto above = std::upper_bound(volumes_m3_.begin(), volumes_m3_.end(), std::max(displaced_m3, 0.0));
  if (above == volumes_m3_.begin()) return lowest_m_;
  if (above == volumes_m3_.end()) return lowest_m_ + (levels - 1) * level_step_m_;
  const double below_m3 = *std::prev(above);
  return lowest_m_ + level_step_m_ * (static_cast<double>(above - volumes_m3_.begin()) - 1.0 +
                                      (displaced_m3 - below_m3) / (*above - below_m3));
}

void HullPresser::press(const BodyPose& pose, double factor, const WakeGrid& grid,
                        ocl::Buffer<float>& displaced) const {
  if (pose.displaced_m3 <= 0.0 || factor == 0.0) return;
  const glm::dmat3 axes = glm::mat3_cast(pose.turn);
  const glm::dmat2 shadow = shadow_of(axes);
  const double level = level_m(pose.displaced_m3), above_m = level - mass_centre_m_.y;
  const double cell_m = static_cast<double>(grid.cell_m);
  // The point of the waterline's plane above the mass centre, moved to where the water there is at rest: a
  // window holds water by that place. From it along and across the hull.
  const glm::dvec2 middle_m = glm::dvec2(pose.mass_centre_m.x, pose.mass_centre_m.z) +
                              above_m * glm::dvec2(axes[1].x, axes[1].z) - pose.shift_m;
  const auto in_map = [&](const glm::dvec2& in_body_m) {
    return glm::dvec2((in_body_m.x + mass_centre_m_.x - low_x_m_) / cell_x_m_,
                      (in_body_m.y + mass_centre_m_.z - low_z_m_) / cell_z_m_);
  };
  // The cells of the window that the map's rectangle touches.
  glm::dvec2 low(std::numeric_limits<double>::infinity()), high = -low;
  for (const auto& [column, row] :
       {std::array{0, 0}, {HullMap::columns, 0}, {0, HullMap::rows}, {HullMap::columns, HullMap::rows}}) {
    const glm::dvec2 corner_m =
        middle_m + shadow * glm::dvec2(low_x_m_ + column * cell_x_m_ - mass_centre_m_.x,
                                       low_z_m_ + row * cell_z_m_ - mass_centre_m_.z);
    low = glm::min(low, corner_m / cell_m - cells_of_tent);
    high = glm::max(high, corner_m / cell_m + cells_of_tent);
  }
  const double from_column = std::max(std::floor(low.x), static_cast<double>(grid.first_column));
  const double from_row = std::max(std::floor(low.y), static_cast<double>(grid.first_row));
  const double to_column =
      std::min(std::ceil(high.x), static_cast<double>(grid.first_column + grid.size - 1));
  const double to_row = std::min(std::ceil(high.y), static_cast<double>(grid.first_row + grid.size - 1));
  if (!(to_column >= from_column && to_row >= from_row)) return;

  const glm::dmat2 back = glm::inverse(shadow);
  const glm::dvec2 first = in_map(back * (glm::dvec2(from_column, from_row) * cell_m - middle_m));
  const glm::dvec2 by_column = cell_m * back[0] / glm::dvec2(cell_x_m_, cell_z_m_);
  const glm::dvec2 by_row = cell_m * back[1] / glm::dvec2(cell_x_m_, cell_z_m_);
  const HullPress values{.first_column = static_cast<int>(from_column),
                         .first_row = static_cast<int>(from_row),
                         .columns = static_cast<int>(to_column - from_column) + 1,
                         .rows = static_cast<int>(to_row - from_row) + 1,
                         .size = grid.size,
                         .along = static_cast<float>(first.x),
                         .across = static_cast<float>(first.y),
                         .along_by_column = static_cast<float>(by_column.x),
                         .along_by_row = static_cast<float>(by_row.x),
                         .across_by_column = static_cast<float>(by_column.y),
                         .across_by_row = static_cast<float>(by_row.y),
                         .map_columns = HullMap::columns,
                         .map_rows = HullMap::rows,
                         .level_m = static_cast<float>(level),
                         .factor = static_cast<float>(factor)};
  // Groups of one shape, whatever the hull covers: some drivers compile a kernel anew for each shape.
  const auto whole = [&](int count) {
    return (static_cast<std::size_t>(count) + group_side_ - 1) / group_side_ * group_side_;
  };
  kernel_.launch({{whole(values.columns), whole(values.rows), 1}, {group_side_, group_side_, 1}}, values,
                 bottom_, displaced);
}

}  // namespace offing::bodies
