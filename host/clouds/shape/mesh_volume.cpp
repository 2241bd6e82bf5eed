#include "host/clouds/shape/mesh_volume.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "host/base/error.h"
#include "host/base/parallel_for.h"
#include "host/base/parameter_check.h"
#include "host/clouds/shape/ball_bins.h"
#include "host/clouds/shape/mesh_inside.h"

namespace offing::clouds {
namespace {

constexpr double most_cells = 1 << 27;
constexpr float far_away = 1e20f;

void require_valid(const TriangleMesh& mesh, const MeshVolumeOptions& options) {
  require_within("cloud.shape.cell_m", options.cell_m, 1e-3, 1e5);
  require_within("cloud.shape.thickness_m", options.thickness_m, 1e-6, 1e6);
  require_within("cloud.shape.fluff_m", options.fluff_m, 0.0, 1e6);
  for (const TriangleIndices& face : mesh.faces) {
    for (const std::uint32_t vertex : face) {
      if (vertex < mesh.positions_m.size()) continue;
      throw Error(
          ErrorKind::bad_input,
          fmt::format("cloud shape: expected vertices below {}, found {}", mesh.positions_m.size(), vertex),
          "check the mesh with `offing-mesh check`");
    }
  }
}

/// Squared distances along a line from each place to the nearest of parabolas standing on `heights`: the
/// lower envelope (Felzenszwalb & Huttenlocher 2012, Distance transforms of sampled functions).
class LowerEnvelope {
 public:
  explicit LowerEnvelope(std::size_t length) : roots_(length), starts_(length + 1) {}

  void apply(std::vector<float>& heights) {
    const std::size_t count = heights.size();
    const auto meets = [&](std::size_t a,
                           std::size_t b) {  // where the parabola of b goes below that of a < b
      const auto x = static_cast<double>(a), y = static_cast<double>(b);
      return (static_cast<double>(heights[b]) + y * y - static_cast<double>(heights[a]) - x * x) /
             (2.0 * (y - x));
    };
    std::size_t top = 0;
    roots_[0] = 0;
    starts_[0] = -std::numeric_limits<double>::infinity();
    starts_[1] = std::numeric_limits<double>::infinity();
    for (std::size_t next = 1; next < count; ++next) {
      double start = meets(roots_[top], next);
      while (top > 0 && start <= starts_[top]) start = meets(roots_[--top], next);
      roots_[++top] = next;
      starts_[top] = start;
      starts_[top + 1] = std::numeric_limits<double>::infinity();
    }
    result_.resize(count);
    std::size_t piece = 0;
    for (std::size_t i = 0; i < count; ++i) {
      while (starts_[piece + 1] < static_cast<double>(i)) ++piece;
      const double away = static_cast<double>(i) - static_cast<double>(roots_[piece]);
      result_[i] = heights[roots_[piece]] + static_cast<float>(away * away);
    }
    heights.swap(result_);
  }

 private:
  std::vector<std::size_t> roots_;
  std::vector<double> starts_;
  std::vector<float> result_;
};

/// From each cell to the nearest one that is (not) inside, in cells: 0 there itself.
std::vector<float> distances(const std::vector<std::uint8_t>& inside, std::uint8_t to,
                             const std::array<int, 3>& cells) {
  std::vector<float> squares(inside.size());
  for (std::size_t i = 0; i < inside.size(); ++i) squares[i] = inside[i] == to ? 0.0f : far_away;
  const std::array<std::size_t, 3> step{
      1, static_cast<std::size_t>(cells[0]),
      static_cast<std::size_t>(cells[0]) * static_cast<std::size_t>(cells[1])};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t first = (axis + 1) % 3, second = (axis + 2) % 3;
    const auto length = static_cast<std::size_t>(cells[axis]);
    parallel_rows(cells[second], [&](int row) {
      LowerEnvelope envelope(length);
      std::vector<float> line(length);
      for (int column = 0; column < cells[first]; ++column) {
        const std::size_t begin =
            static_cast<std::size_t>(row) * step[second] + static_cast<std::size_t>(column) * step[first];
        for (std::size_t i = 0; i < length; ++i) line[i] = squares[begin + i * step[axis]];
        envelope.apply(line);
        for (std::size_t i = 0; i < length; ++i) squares[begin + i * step[axis]] = line[i];
      }
    });
  }
  for (float& square : squares) square = std::sqrt(square);
  return squares;
}

}  // namespace

CloudVolume mesh_volume(const TriangleMesh& mesh, const MeshVolumeOptions& options) {
  require_valid(mesh, options);
  glm::dvec3 low_m(0.0), high_m(0.0);
  for (std::size_t i = 0; i < mesh.positions_m.size(); ++i) {
    low_m = i == 0 ? mesh.positions_m[i] : glm::min(low_m, mesh.positions_m[i]);
    high_m = i == 0 ? mesh.positions_m[i] : glm::max(high_m, mesh.positions_m[i]);
  }
  const double rim_m = options.fluff_m + 2.0 * options.cell_m;
  const BrickGrid grid = grid_around(low_m - rim_m, high_m + rim_m, options.cell_m);
  const double count = static_cast<double>(grid.brick_count() * CloudVolume::cells_of_brick);
  if (count > most_cells) {
    throw Error(ErrorKind::bad_input,
                fmt::format("cloud shape: cell_m {:g} gives {:.3g} cells, expected at most {:.3g}",
                            options.cell_m, count, most_cells),
                fmt::format("take cells of {:.2g} m", 1.1 * options.cell_m * std::cbrt(count / most_cells)));
  }
  std::array<int, 3> cells;
  for (std::size_t axis = 0; axis < 3; ++axis) cells[axis] = grid.bricks[axis] * CLOUD_BRICK_CELLS;
  const std::vector<std::uint8_t> inside = cells_inside(mesh, grid.corner_m, options.cell_m, cells);
  if (std::find(inside.begin(), inside.end(), std::uint8_t{1}) == inside.end()) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("cloud shape: {} faces enclose no cell of {:g} m", mesh.faces.size(), options.cell_m),
        "take smaller cells, or a closed mesh (`offing-mesh check`)");
  }
  const std::vector<float> depth = distances(inside, 0, cells), height = distances(inside, 1, cells);

  CloudVolume volume;
  volume.origin_m = grid.corner_m;
  volume.cell_m = options.cell_m;
  volume.bricks = grid.bricks;
  volume.brick_of.assign(grid.brick_count(), CloudVolume::no_brick);
  std::vector<float> brick(CloudVolume::cells_of_brick);
  for (std::size_t number = 0; number < volume.brick_of.size(); ++number) {
    const auto across = static_cast<std::size_t>(grid.bricks[0]),
               down = static_cast<std::size_t>(grid.bricks[1]);
    const std::array<std::size_t, 3> corner{number % across * 8, number / across % down * 8,
                                            number / across / down * 8};
    for (std::size_t i = 0; i < brick.size(); ++i) {
      const std::size_t cell =
          ((corner[2] + i / 64) * down * 8 + corner[1] + i / 8 % 8) * across * 8 + corner[0] + i % 8;
      // The surface lies half way between the middles of two cells.
      const double out = static_cast<double>(depth[cell] > 0.0f ? 0.5f - depth[cell] : height[cell] - 0.5f);
      const double share = std::clamp(
          (options.fluff_m - out * options.cell_m) / (options.fluff_m + options.thickness_m), 0.0, 1.0);
      brick[i] = static_cast<float>(share * share * (3.0 - 2.0 * share));
    }
    if (std::all_of(brick.begin(), brick.end(), [](float density) { return density == 0.0f; })) continue;
    volume.brick_of[number] = static_cast<std::int32_t>(volume.density.size() / CloudVolume::cells_of_brick);
    volume.density.insert(volume.density.end(), brick.begin(), brick.end());
  }
  return volume;
}

}  // namespace offing::clouds
