#include "host/highlights/projectors/texture_shapes.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/highlights/example_surfaces.h"

namespace offing::highlights {
namespace {

using std::numbers::pi;
using Outline = std::vector<glm::dvec2>;  // closed, of short sides

constexpr HighlightTexture all_shapes[] = {HighlightTexture::dot,    HighlightTexture::window,
                                           HighlightTexture::star,   HighlightTexture::ring,
                                           HighlightTexture::streak, HighlightTexture::heart};

void add_arc(Outline& outline, glm::dvec2 middle, double radius, double from_rad, double to_rad) {
  constexpr int steps = 2000;
  for (int i = 0; i < steps; ++i) {
    const double angle = from_rad + (to_rad - from_rad) * i / steps;
    outline.push_back(middle + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
  }
}

void add_line(Outline& outline, glm::dvec2 from, glm::dvec2 to) {
  constexpr int steps = 1000;
  for (int i = 0; i < steps; ++i) outline.push_back(from + (to - from) * (i / double(steps)));
}

Outline circle(double radius) {
  Outline outline;
  add_arc(outline, glm::dvec2(0.0), radius, 0.0, 2.0 * pi);
  return outline;
}

Outline pane(glm::dvec2 middle) {
  Outline outline;
  for (int corner = 0; corner < 4; ++corner) {
    const double angle = 0.5 * pi * corner;
    const glm::dvec2 way(corner == 0 || corner == 3 ? 0.38 : -0.38, corner < 2 ? 0.38 : -0.38);
    add_arc(outline, middle + way, 0.08, angle, angle + 0.5 * pi);
    const glm::dvec2 next(-way.y, way.x), out(-std::sin(angle), std::cos(angle));
    add_line(outline, middle + way + 0.08 * out, middle + next + 0.08 * out);
  }
  return outline;
}

Outline star() {
  Outline outline;
  const auto tip = [](int i) {
    const double angle = 0.5 * pi + 0.2 * pi * i;
    return (i % 2 == 0 ? 1.0 : 0.45) * glm::dvec2(std::cos(angle), std::sin(angle));
  };
  for (int i = 0; i < 10; ++i) add_line(outline, tip(i), tip(i + 1));
  return outline;
}

// The arc through (0, -1), (0.22, 0) and (0, 1), and its mirror picture.
Outline streak() {
  const double radius = 0.5 * (0.22 + 1.0 / 0.22), half = std::asin(1.0 / radius);
  Outline outline;
  add_arc(outline, {0.22 - radius, 0.0}, radius, -half, half);
  add_arc(outline, {radius - 0.22, 0.0}, radius, pi - half, pi + half);
  return outline;
}

Outline heart() {
  // The tangent from (0, -1) stands across the radius that it touches: by Thales' circle.
  const double way = std::hypot(0.46, 1.46);
  const double touch = std::atan2(-1.46, -0.46) + std::acos(0.54 / way);
  const double cleft = std::acos(-0.46 / 0.54);
  const glm::dvec2 right(0.46, 0.46), left(-0.46, 0.46), tip(0.0, -1.0);
  const glm::dvec2 reach = 0.54 * glm::dvec2(std::cos(touch), std::sin(touch));
  Outline outline;
  add_line(outline, tip, right + reach);
  add_arc(outline, right, 0.54, touch, cleft);
  add_arc(outline, left, 0.54, pi - cleft, pi - touch);
  add_line(outline, left + glm::dvec2(-reach.x, reach.y), tip);
  return outline;
}

std::vector<Outline> outlines(HighlightTexture shape) {
  switch (shape) {
    case HighlightTexture::window:
      return {pane({0.54, 0.54}), pane({-0.54, 0.54}), pane({-0.54, -0.54}), pane({0.54, -0.54})};
    case HighlightTexture::star:
      return {star()};
    case HighlightTexture::ring:
      return {circle(1.0), circle(0.6)};
    case HighlightTexture::streak:
      return {streak()};
    case HighlightTexture::heart:
      return {heart()};
    default:
      return {circle(1.0)};
  }
}

// Distance to the nearest of an outline's points, negative where a line to the right crosses the outlines an
// odd number of times.
double measured_distance(const std::vector<Outline>& all, const glm::dvec2& q) {
  double least = 1e9;
  bool is_inside = false;
  for (const Outline& outline : all) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const glm::dvec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
      least = std::min(least, glm::distance(a, q));
      if ((a.y > q.y) != (b.y > q.y) && a.x + (q.y - a.y) / (b.y - a.y) * (b.x - a.x) > q.x)
        is_inside = !is_inside;
    }
  }
  return is_inside ? -least : least;
}

// Against outlines of their own description. Bound: points of an outline lie at most 3.2e-3 apart, and half
// that distance s beside the true place costs at most s^2 / (2 d) or, near the rim, s itself: 1.6e-3.
// Measured 1.6e-3. Gate 2e-3: a wrong constant of the third figure fails.
TEST(TextureShapesTest, DistancesAreThoseToTheOutline) {
  test::RandomVectors random(11);
  for (const HighlightTexture shape : all_shapes) {
    const std::vector<Outline> all = outlines(shape);
    double worst = 0.0;
    for (int i = 0; i < 300; ++i) {
      const glm::dvec2 q(2.6 * random.uniform() - 1.3, 2.6 * random.uniform() - 1.3);
      worst = std::max(worst, std::abs(signed_distance(shape, q) - measured_distance(all, q)));
    }
    EXPECT_LE(worst, 2e-3) << name_of(shape);
  }
}

// Fails if a shape is cut by its box, or if depth_of() is not the depth: a grid of 0.005 comes within 0.0036
// of the deepest place, and distances grow no faster than places move.
TEST(TextureShapesTest, ShapesStayInTheirBoxesAndDepthsAreTheirs) {
  for (const HighlightTexture shape : all_shapes) {
    double deepest = 0.0;
    for (int row = -200; row <= 200; ++row) {
      for (int column = -200; column <= 200; ++column)
        deepest = std::max(deepest, -signed_distance(shape, {column / 200.0, row / 200.0}));
      EXPECT_GE(signed_distance(shape, {1.0, row / 200.0}), -1e-12) << name_of(shape);
      EXPECT_GE(signed_distance(shape, {row / 200.0, 1.0}), -1e-12) << name_of(shape);
      EXPECT_GE(signed_distance(shape, {row / 200.0, -1.0}), -1e-12) << name_of(shape);
    }
    EXPECT_LE(deepest, depth_of(shape) + 1e-9) << name_of(shape);
    EXPECT_GE(deepest, depth_of(shape) - 0.0036) << name_of(shape);
  }
}

// Fails if a soft rim never becomes opaque (a ring is thinner than its softness), reaches outside, or if
// softness rounds pictures off.
TEST(TextureShapesTest, RimsLieInsideAndEndOpaque) {
  for (const HighlightTexture shape : all_shapes) {
    double most = 0.0;
    for (int row = -100; row <= 100; ++row) {
      for (int column = -100; column <= 100; ++column) {
        const glm::dvec2 q(column / 100.0, row / 100.0);
        const double opacity = shape_opacity(shape, q, 0.7, 0.0);
        most = std::max(most, opacity);
        if (signed_distance(shape, q) >= 0.0) {
          EXPECT_EQ(opacity, 0.0);
        }
      }
    }
    EXPECT_GE(most, 0.99) << name_of(shape);
  }
  EXPECT_NEAR(shape_opacity(HighlightTexture::dot, {0.75, 0.0}, 0.5, 0.0), 0.5, 1e-15);
  EXPECT_NEAR(shape_opacity(HighlightTexture::dot, {0.95, 0.0}, 0.0, 0.1), 0.5, 1e-14);
  EXPECT_EQ(shape_opacity(HighlightTexture::dot, {0.999, 0.0}, 0.0, 0.0), 1.0);
  EXPECT_EQ(shape_opacity(HighlightTexture::image, {0.95, 0.95}, 1.0, 0.01), 1.0);
}

// Softness and pixels change nothing at once: a step of 1e-4 of either changes no opacity by more than that
// of the cubic's steepest rise (1.5 / rim) allows, here 1.5 / 0.05 * 1e-4 = 3e-3.
TEST(TextureShapesTest, OpacityIsContinuousInSoftness) {
  for (const HighlightTexture shape : all_shapes) {
    for (double softness = 0.05; softness < 1.0; softness += 1e-4) {
      const glm::dvec2 q(0.13, -0.41);
      EXPECT_LE(
          std::abs(shape_opacity(shape, q, softness + 1e-4, 0.0) - shape_opacity(shape, q, softness, 0.0)),
          3e-3);
    }
  }
}

}  // namespace
}  // namespace offing::highlights
