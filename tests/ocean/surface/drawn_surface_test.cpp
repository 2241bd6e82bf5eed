// Queries against a fine grid of the composed surface: vertices at labels, moved, with flat triangles between
// them. What OpenGL draws is compared in tests/present.
#include <algorithm>
#include <cmath>
#include <random>

#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include "tests/ocean/query/queried_sea.h"

namespace offing::ocean {
namespace {

constexpr int compared_points = 1000;

/// A grid of moved vertices.
struct DrawnSurface {
  int columns = 0, rows = 0;
  std::vector<glm::dvec3> vertices;

  const glm::dvec3& vertex(int row, int column) const {
    return vertices[static_cast<std::size_t>(row * columns + column)];
  }
};

/// Points on triangles chosen at random among the cells of rows [0, last_row), of a fixed seed.
std::vector<glm::dvec3> points_on(const DrawnSurface& surface, int last_row) {
  std::mt19937_64 generator(3);
  const auto uniform = [&] { return static_cast<double>(generator() >> 11) * 0x1p-53; };
  std::vector<glm::dvec3> points;
  for (int i = 0; i < compared_points; ++i) {
    const int row = static_cast<int>(uniform() * last_row);
    const int column = static_cast<int>(uniform() * (surface.columns - 1));
    double u = uniform(), v = uniform();
    const bool is_upper = u + v > 1.0;
    const glm::dvec3& corner = is_upper ? surface.vertex(row + 1, column + 1) : surface.vertex(row, column);
    const glm::dvec3& beside = is_upper ? surface.vertex(row + 1, column) : surface.vertex(row, column + 1);
    const glm::dvec3& behind = is_upper ? surface.vertex(row, column + 1) : surface.vertex(row + 1, column);
    if (is_upper) {
      u = 1.0 - u;
      v = 1.0 - v;
    }
    points.push_back(corner + u * (beside - corner) + v * (behind - corner));
  }
  return points;
}

/// Root mean square of how far queries are off the heights of these points.
double rms_m(HybridSea& sea, const std::vector<glm::dvec3>& points, const WaterQuery& query) {
  std::vector<WaterPoint> places;
  for (const glm::dvec3& point : points) places.push_back({point.x, point.z});
  const std::vector<WaterSample> samples = sea.ocean.sample(places, query);
  double squares = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double off_m = samples[i].height_m - points[i].y;
    squares += off_m * off_m;
  }
  return std::sqrt(squares / static_cast<double>(points.size()));
}

// Fails if a boat would float beside the drawn water: seen from 20 m straight above, on a grid of 5 cm with
// all waves, what is left is the flatness of triangles, an eighth of curvature times spacing squared (0.3 mm
// at 1 /m), and the kinks between the cascades' texels. Promised 1 cm.
TEST(DrawnSurface, IsWhereQueriesSay) {
  HybridSea sea = hybrid_sea(ocl::Device::open(), 512);
  sea.ocean.at(42.0);
  constexpr double spacing_m = 0.05;
  const SampleGrid grid{.origin_x_m = -12.0,
                        .origin_z_m = 55.0,
                        .spacing_x_m = spacing_m,
                        .spacing_z_m = spacing_m,
                        .columns = 480,
                        .rows = 480};
  const ComposedFields fields = sea.ocean.read_composed(grid);
  DrawnSurface surface{.columns = grid.columns, .rows = grid.rows, .vertices = {}};
  for (int i = 0; i < grid.rows * grid.columns; ++i) {
    surface.vertices.emplace_back(grid.origin_x_m + i % grid.columns * spacing_m + fields.displacement_x[i],
                                  fields.displacement_y[i],
                                  grid.origin_z_m + i / grid.columns * spacing_m + fields.displacement_z[i]);
  }
  const std::vector<glm::dvec3> points = points_on(surface, grid.rows - 1);
  const double off_m = rms_m(sea, points, {.accuracy = WaterQuery::Accuracy::frame_maps});
  RecordProperty("rms_mm", std::to_string(1e3 * off_m));
  EXPECT_LT(off_m, 0.01);
  // The drawn water lacks what straight lines between samples lose, 1.1 cm of these waves.
  EXPECT_LT(rms_m(sea, points, {}), 0.015);
}

}  // namespace
}  // namespace offing::ocean
