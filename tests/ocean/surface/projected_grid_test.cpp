#include "host/ocean/surface/projected_grid.h"

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "host/base/error.h"

namespace offing::ocean {
namespace {

using std::numbers::pi;
// Places in the grid come from quotients of heights to distances of up to 1e9 of them, in double precision:
// measured below 1e-9.
constexpr double place_tolerance = 1e-7;

struct Case {
  Camera camera;
  SurfaceReach reach;
};

/// Cameras of every height, turn and lens; a third of them over flat water.
class RandomCases {
 public:
  Case next() {
    Case result;
    result.camera = {.eye_m = {0.0, std::exp(between(std::log(1e-3), std::log(2e4))), 0.0},
                     .yaw_rad = between(-pi, pi),
                     .pitch_rad = between(-pi / 2.0, pi / 2.0),
                     .roll_rad = between(-pi, pi),
                     .vertical_field_of_view_rad = between(10.0, 120.0) * pi / 180.0,
                     .width_px = 640,
                     .height_px = 360};
    if (between(0.0, 3.0) > 1.0) result.reach = {between(0.0, 15.0), between(0.0, 15.0)};
    return result;
  }
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator_);
  }

 private:
  std::mt19937_64 generator_{20261121};
};

bool is_on_grid(glm::dvec2 place) {
  return place.x > -place_tolerance && place.x < 1.0 + place_tolerance && place.y > -place_tolerance &&
         place.y < 1.0 + place_tolerance;
}

// Fails if a shader that mixes the corners, and divides once, makes another grid.
TEST(ProjectedGrid, IsTheBilinearMeanOfItsCorners) {
  RandomCases random;
  for (int i = 0; i < 300; ++i) {
    const auto [camera, reach] = random.next();
    const auto grid = ProjectedGrid::for_camera(camera, reach);
    if (!grid) continue;
    const auto corners = grid->corners();
    const glm::dvec2 place(random.between(0.0, 1.0), random.between(0.0, 1.0));
    glm::dvec2 label(0.0);
    double w = 0.0;
    for (std::size_t corner = 0; corner < corners.size(); ++corner) {
      const double weight =
          (corner % 2 == 0 ? 1.0 - place.x : place.x) * (corner / 2 == 0 ? 1.0 - place.y : place.y);
      label += weight * corners[corner].label_m;
      w += weight * corners[corner].w;
    }
    const glm::dvec2 expected = grid->label_m(place);
    const double length_m = std::hypot(expected.x, expected.y);
    EXPECT_NEAR(label.x / w, expected.x, 1e-9 * length_m);
    EXPECT_NEAR(label.y / w, expected.y, 1e-9 * length_m);
  }
}

// A pixel below the horizon shows water at some height within the waves' reach, carried there from a label
// within their reach. A grid that ends too early leaves a hole there.
TEST(ProjectedGrid, CoversWhatAnyCameraSees) {
  RandomCases random;
  std::array<int, 5> cameras_by_corners_above{};
  int labels = 0;
  for (int i = 0; i < 10000; ++i) {
    const auto [camera, reach] = random.next();
    int corners_above = 0;
    for (const glm::dvec2 corner :
         {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(1, 1), glm::dvec2(-1, 1)}) {
      corners_above += ray_direction(camera, corner).y >= 0.0;
    }
    ++cameras_by_corners_above.at(static_cast<std::size_t>(corners_above));
    const auto grid = ProjectedGrid::for_camera(camera, reach);
    const double pixel = 2.0 * half_extent(camera).y / camera.height_px;
    for (int pixels = 0; pixels < 40; ++pixels) {
      // The picture's border is where a grid ends first.
      const bool is_border = pixels % 2 == 0;
      const glm::dvec2 clip(random.between(-1.0, 1.0), is_border ? -1.0 : random.between(-1.0, 1.0));
      const glm::dvec3 ray = ray_direction(camera, pixels % 4 == 0 ? glm::dvec2(clip.y, clip.x) : clip);
      if (ray.y > -pixel) continue;
      const double height_m = random.between(-1.0, 1.0) * reach.vertical_m;
      const double distance = (height_m - camera.eye_m.y) / ray.y;
      if (distance < 0.0) continue;  // that height is above the eye
      const double turn_rad = random.between(-pi, pi);
      const glm::dvec2 label = distance * glm::dvec2(ray.x, ray.z) +
                               reach.horizontal_m * glm::dvec2(std::cos(turn_rad), std::sin(turn_rad));
      ASSERT_TRUE(grid) << "camera " << i;
      const auto place = grid->place_of(label);
      ASSERT_TRUE(place && is_on_grid(*place))
          << "camera " << i << ", label " << label.x << ' ' << label.y << ", place "
          << (place ? place->x : NAN) << ' ' << (place ? place->y : NAN);
      ++labels;
    }
  }
  // Each way the horizon can cross the picture must have been tried.
  for (const int cameras : cameras_by_corners_above) EXPECT_GT(cameras, 500);
  EXPECT_GT(labels, 100000);
}

// All triangles turn the same way round and all vertices are finite in single precision: nothing fires back
// from behind the horizon.
TEST(ProjectedGrid, TurnsNoTriangleOver) {
  constexpr int cells = 24;
  RandomCases random;
  for (int i = 0; i < 10000; ++i) {
    const auto [camera, reach] = random.next();
    const auto grid = ProjectedGrid::for_camera(camera, reach);
    if (!grid) continue;
    const auto vertex = [&](int column, int row) {
      return grid->label_m(glm::dvec2(column, row) / static_cast<double>(cells));
    };
    for (int row = 0; row < cells; ++row) {
      for (int column = 0; column < cells; ++column) {
        const glm::dvec2 corner = vertex(column, row), opposite = vertex(column + 1, row + 1);
        ASSERT_TRUE(std::isfinite(static_cast<float>(opposite.x)) &&
                    std::isfinite(static_cast<float>(opposite.y)));
        for (const glm::dvec2 other : {vertex(column + 1, row), vertex(column, row + 1)}) {
          const glm::dvec2 a = other - corner, b = opposite - corner;
          const double turn = (a.x * b.y - a.y * b.x) * (other == vertex(column + 1, row) ? 1.0 : -1.0);
          // x right and z toward the eye: the plane seen from above turns the other way.
          ASSERT_LT(turn, 0.0) << "camera " << i << ", cell " << column << ' ' << row;
        }
      }
    }
  }
}

TEST(ProjectedGrid, FindsTheLabelsOfItsPlaces) {
  const auto grid = ProjectedGrid::for_camera({.eye_m = {0.0, 5.0, 0.0}, .yaw_rad = 1.0}, {2.0, 1.0});
  ASSERT_TRUE(grid);
  for (const glm::dvec2 place : {glm::dvec2(0.0, 0.0), glm::dvec2(0.3, 0.9), glm::dvec2(1.0, 1.0)}) {
    const auto found = grid->place_of(grid->label_m(place));
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->x, place.x, place_tolerance);
    EXPECT_NEAR(found->y, place.y, place_tolerance);
  }
}

// Over flat water a level head's grid is the picture itself, from its lower corners to the horizon.
TEST(ProjectedGrid, FitsTheImageOfALevelHead) {
  const Camera camera{.eye_m = {0.0, 10.0, 0.0}, .pitch_rad = -0.2};
  const auto grid = ProjectedGrid::for_camera(camera, {});
  ASSERT_TRUE(grid);
  EXPECT_DOUBLE_EQ(grid->projector_height_m(), 10.0);
  for (const double side : {0.0, 1.0}) {
    const glm::dvec3 ray = ray_direction(camera, {2.0 * side - 1.0, -1.0});
    const auto place = grid->place_of(glm::dvec2(ray.x, ray.z) * (-10.0 / ray.y));
    ASSERT_TRUE(place);
    EXPECT_NEAR(place->x, side, place_tolerance);
    EXPECT_NEAR(place->y, 0.0, place_tolerance);
  }
  // The far row lies a quarter of a pixel below the horizon.
  const double pixel = 2.0 * half_extent(camera).y / camera.height_px;
  const glm::dvec2 far_m = grid->label_m({0.5, 1.0});
  EXPECT_NEAR(10.0 / std::hypot(far_m.x, far_m.y), 0.25 * pixel, 0.05 * pixel);
}

TEST(ProjectedGrid, IsEmptyWhereNoWaterIsSeen) {
  EXPECT_FALSE(ProjectedGrid::for_camera({.eye_m = {0.0, 10.0, 0.0}, .pitch_rad = 1.2}, {1.0, 1.0}));
  // Below the crests water may stand before any eye.
  EXPECT_TRUE(ProjectedGrid::for_camera({.eye_m = {0.0, 0.5, 0.0}, .pitch_rad = 1.2}, {1.0, 1.0}));
  EXPECT_TRUE(ProjectedGrid::for_camera({.eye_m = {0.0, 0.5, 0.0}, .pitch_rad = 1.2}, {0.0, 1.0}));
}

TEST(ProjectedGrid, RefusesEyesBelowTheWater) {
  EXPECT_THROW(ProjectedGrid::for_camera({.eye_m = {0.0, -1.0, 0.0}}, {}), Error);
  EXPECT_THROW(ProjectedGrid::for_camera({}, {-1.0, 0.0}), Error);
  EXPECT_THROW(ProjectedGrid::for_camera({}, {0.0, NAN}), Error);
}

}  // namespace
}  // namespace offing::ocean
