// What the debug views of meshes show: where theory has it, and nowhere else.
#include <algorithm>
#include <set>
#include <utility>

#include "host/highlights/search/face_tree.h"
#include "present/passes/frame_request.h"
#include "tests/present/passes/mesh_stage.h"

namespace offing::present {
namespace {

class MeshShowTest : public test::MeshStage {
 protected:
  std::vector<float> shown(MeshShow show) {
    FrameRequest asked = request();
    asked.meshes = show;
    return light(asked);
  }

  /// A mesh with one highlight, seen by its picture without.
  std::vector<float> open_with_one_highlight() {
    world::MeshParameters mesh = mesh_of(mesh_shapes::make_ellipsoid({1.0, 0.8, 0.9}, 3));
    mesh.has_highlights = true;
    highlights::HighlightRule rule;
    rule.controls.opacity = 0.0;
    mesh.rules = {rule};
    open(mesh);
    std::vector<float> plain = light();
    rule.controls.opacity = 1.0;
    world_->meshes()[0].set_rules({rule});
    light();
    EXPECT_EQ(world_->meshes()[0].highlights().size(), 1u);
    return plain;
  }

  glm::vec3 colour_at(const std::vector<float>& pixels, const glm::dvec3& on_mesh_m) const {
    const glm::ivec2 pixel(pixel_of(place_m + on_mesh_m));
    const float* rgba = &pixels[4 * static_cast<std::size_t>(pixel.y * width + pixel.x)];
    return {rgba[0], rgba[1], rgba[2]};
  }

  /// differs(column, row) of two pictures.
  static auto difference(const std::vector<float>& one, const std::vector<float>& other) {
    return [&](int column, int row) {
      const auto i = 4 * static_cast<std::ptrdiff_t>(row * width + column);
      return !std::equal(one.begin() + i, one.begin() + i + 3, other.begin() + i);
    };
  }
};

// A torus about the line of sight, seen from its middle's height: convex outside, a saddle inside. Fails if
// signs of curvatures or colours are exchanged.
TEST_F(MeshShowTest, CurvatureIsRedWhereConvexAndGreenAtSaddles) {
  open(mesh_of(mesh_shapes::make_torus(0.8, 0.3, {80, 32})));
  const std::vector<float> pixels = shown(MeshShow::curvature);
  for (const glm::dvec2 way : {glm::dvec2(1.0, 0.0), glm::dvec2(0.0, -1.0), glm::dvec2(-0.8, 0.6)}) {
    const glm::vec3 outside = colour_at(pixels, {0.98 * way.x, 0.98 * way.y, 0.24});
    EXPECT_GT(outside.r, 1.5f * std::max(outside.g, outside.b));
    const glm::vec3 inside = colour_at(pixels, {0.56 * way.x, 0.56 * way.y, 0.18});
    EXPECT_GT(inside.g, 1.2f * std::max(inside.r, inside.b));
  }
}

// Rays say which faces pixels see. Pixels with a neighbour that sees no face of the region, or one of it, may
// do either: the rim is resolved by several samples a pixel.
TEST_F(MeshShowTest, RegionsAreTheFacesOfTheHighlight) {
  const std::vector<float> plain = open_with_one_highlight(), pixels = shown(MeshShow::regions);
  const world::WorldMesh& mesh = world_->meshes()[0];
  const highlights::DrawnHighlight& highlight = mesh.highlights()[0];
  const auto first = mesh.highlight_faces().begin() + static_cast<std::ptrdiff_t>(highlight.first_face);
  const std::set<std::uint32_t> region(first, first + static_cast<std::ptrdiff_t>(highlight.face_count));
  const highlights::FaceTree tree(mesh.surface().mesh());
  const auto is_in_region = [&](int column, int row) {
    const auto hit = tree.first_hit(camera().eye_m - place_m, ray_of(column, row), 100.0);
    return hit && region.contains(hit->face);
  };
  const auto differs = difference(plain, pixels);
  int inside = 0, outside = 0;
  for (int row = 1; row + 1 < height; ++row) {
    for (int column = 1; column + 1 < width; ++column) {
      const bool expected = is_in_region(column, row);
      const bool is_rim =
          is_in_region(column - 1, row) != expected || is_in_region(column + 1, row) != expected ||
          is_in_region(column, row - 1) != expected || is_in_region(column, row + 1) != expected;
      if (is_rim) continue;
      EXPECT_EQ(differs(column, row), expected) << column << ", " << row;
      ++(expected ? inside : outside);
    }
  }
  EXPECT_GT(inside, 100);
  EXPECT_GT(outside, 1000);
}

double distance_to_segment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
  const double share = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
  return glm::distance(p, glm::mix(a, b, share));
}

// Fails if a box is drawn elsewhere or in part: changed pixels are near an edge's picture or that of the mark
// over the upper one, and every edge before the mesh changes pixels all along. Lines are up to 2 px wide.
TEST_F(MeshShowTest, ProjectorsAreBoxes) {
  open_with_one_highlight();
  const std::vector<float> lit = light(), pixels = shown(MeshShow::projectors);
  const highlights::Projector box = world_->meshes()[0].highlights()[0].projector;
  const double depth_m = 0.5 * std::min(box.width_m, box.height_m);
  const auto corner = [&](double right, double up, double out) {
    return pixel_of(place_m + box.centre_m + 0.5 * right * box.width_m * box.right +
                    0.5 * up * box.height_m * box.up + 0.5 * out * depth_m * box.normal);
  };
  using Segment = std::pair<glm::dvec2, glm::dvec2>;
  std::vector<Segment> front,
      others{{corner(-0.3, 1.0, 1.0), corner(0.0, 1.3, 1.0)}, {corner(0.3, 1.0, 1.0), corner(0.0, 1.3, 1.0)}};
  for (const double out : {1.0, -1.0}) {
    std::vector<Segment>& edges = out > 0.0 ? front : others;
    for (const double side : {-1.0, 1.0}) {
      edges.emplace_back(corner(-1.0, side, out), corner(1.0, side, out));
      edges.emplace_back(corner(side, -1.0, out), corner(side, 1.0, out));
      others.emplace_back(corner(side, out, -1.0), corner(side, out, 1.0));
    }
  }
  others.insert(others.end(), front.begin(), front.end());

  const auto differs = difference(lit, pixels);
  std::vector<glm::dvec2> changed;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      if (differs(column, row)) changed.emplace_back(column + 0.5, row + 0.5);
    }
  }
  for (const glm::dvec2& pixel : changed) {
    EXPECT_TRUE(std::any_of(
        others.begin(), others.end(),
        [&](const Segment& edge) { return distance_to_segment(pixel, edge.first, edge.second) < 2.0; }))
        << pixel.x << ", " << pixel.y;
  }
  for (const auto& [from, to] : front) {
    for (double share = 0.05; share < 1.0; share += 0.1) {
      const glm::dvec2 place = glm::mix(from, to, share);
      EXPECT_TRUE(std::any_of(changed.begin(), changed.end(),
                              [&](const glm::dvec2& pixel) { return glm::distance(pixel, place) < 2.0; }))
          << place.x << ", " << place.y;
    }
  }
}

}  // namespace
}  // namespace offing::present
