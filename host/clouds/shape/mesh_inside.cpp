#include "host/clouds/shape/mesh_inside.h"

#include <algorithm>
#include <cmath>

namespace offing::clouds {
namespace {

/// A place where a line meets a face: +1 where it goes in.
struct Crossing {
  double along;  // cells
  int sign;
};

/// Whether a place lies to the left of an edge. One on the edge counts as a little further along both axes,
/// so that it is to the left of the edge or of the same edge turned around, never of both, and on the same
/// side whichever axis its line is along.
bool is_left(double ax, double ay, double bx, double by, double px, double py) {
  const bool turned = ax > bx || (ax == bx && ay > by);
  if (turned) {
    std::swap(ax, bx);
    std::swap(ay, by);
  }
  // The same arithmetic for both faces of an edge, so that rounding decides for one of them.
  const double side = (bx - ax) * (py - ay) - (by - ay) * (px - ax);
  const bool left = side > 0.0 || (side == 0.0 && ax != bx);
  return left != turned;
}

/// Crossings of lines along an axis through the middles of cells: [second][first] of the other two axes.
std::vector<std::vector<Crossing>> crossings(const TriangleMesh& mesh, const glm::dvec3& corner_m,
                                             double cell_m, const std::array<int, 3>& cells, int axis) {
  const int first = (axis + 1) % 3, second = (axis + 2) % 3;
  const int columns = cells[static_cast<std::size_t>(first)], rows = cells[static_cast<std::size_t>(second)];
  std::vector<std::vector<Crossing>> lines(static_cast<std::size_t>(columns) *
                                           static_cast<std::size_t>(rows));
  for (const TriangleIndices& face : mesh.faces) {
    std::array<glm::dvec3, 3> p;  // in cells, middles at whole numbers
    for (std::size_t i = 0; i < 3; ++i) p[i] = (mesh.positions_m[face[i]] - corner_m) / cell_m - 0.5;
    const double area = (p[1][first] - p[0][first]) * (p[2][second] - p[0][second]) -
                        (p[1][second] - p[0][second]) * (p[2][first] - p[0][first]);
    if (area == 0.0) continue;
    // Seen from + along the axis: anticlockwise faces are left there, others entered.
    if (area < 0.0) std::swap(p[1], p[2]);
    const auto range = [&](int of, int count) {
      const auto [low, high] = std::minmax({p[0][of], p[1][of], p[2][of]});
      return std::array{std::max(0, static_cast<int>(std::ceil(low))),
                        std::min(count - 1, static_cast<int>(std::floor(high)))};
    };
    const auto [first_row, last_row] = range(second, rows);
    const auto [first_column, last_column] = range(first, columns);
    for (int row = first_row; row <= last_row; ++row) {
      for (int column = first_column; column <= last_column; ++column) {
        bool is_inside = true;
        for (std::size_t i = 0; i < 3 && is_inside; ++i) {
          const glm::dvec3 &a = p[i], &b = p[(i + 1) % 3];
          is_inside = is_left(a[first], a[second], b[first], b[second], column, row);
        }
        if (!is_inside) continue;
        const double of_1 = ((column - p[0][first]) * (p[2][second] - p[0][second]) -
                             (row - p[0][second]) * (p[2][first] - p[0][first])) /
                            std::abs(area);
        const double of_2 = ((p[1][first] - p[0][first]) * (row - p[0][second]) -
                             (p[1][second] - p[0][second]) * (column - p[0][first])) /
                            std::abs(area);
        lines[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
              static_cast<std::size_t>(column)]
            .push_back({p[0][axis] + of_1 * (p[1][axis] - p[0][axis]) + of_2 * (p[2][axis] - p[0][axis]),
                        area < 0.0 ? 1 : -1});
      }
    }
  }
  return lines;
}

}  // namespace

std::vector<std::uint8_t> cells_inside(const TriangleMesh& mesh, const glm::dvec3& corner_m, double cell_m,
                                       const std::array<int, 3>& cells) {
  const auto columns = static_cast<std::size_t>(cells[0]), rows = static_cast<std::size_t>(cells[1]);
  std::vector<std::uint8_t> votes(columns * rows * static_cast<std::size_t>(cells[2]), 0);
  for (int axis = 0; axis < 3; ++axis) {
    const auto along = static_cast<std::size_t>(axis), first = (along + 1) % 3, second = (along + 2) % 3;
    auto lines = crossings(mesh, corner_m, cell_m, cells, axis);
    std::size_t number = 0;
    std::array<int, 3> cell{};
    for (cell[second] = 0; cell[second] < cells[second]; ++cell[second]) {
      for (cell[first] = 0; cell[first] < cells[first]; ++cell[first]) {
        std::vector<Crossing>& line = lines[number++];
        if (line.empty()) continue;
        std::sort(line.begin(), line.end(), [](const Crossing& a, const Crossing& b) {
          return a.along != b.along ? a.along < b.along : a.sign > b.sign;
        });
        int winding = 0;
        std::size_t next = 0;
        for (cell[along] = 0; cell[along] < cells[along]; ++cell[along]) {
          while (next < line.size() && line[next].along <= cell[along]) winding += line[next++].sign;
          if (winding == 0) continue;
          ++votes[(static_cast<std::size_t>(cell[2]) * rows + static_cast<std::size_t>(cell[1])) * columns +
                  static_cast<std::size_t>(cell[0])];
        }
      }
    }
  }
  for (std::uint8_t& vote : votes) vote = vote >= 2 ? 1 : 0;
  return votes;
}

}  // namespace offing::clouds
