// Letters as walls: whole outlines of the size that was asked for.

#include "host/io/text/text_mesh.h"

#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/base/error.h"

namespace offing {
namespace {

struct Box {
  glm::dvec3 low, high;
};

Box box_of(const TriangleMesh& mesh) {
  Box box{mesh.positions_m.front(), mesh.positions_m.front()};
  for (const glm::dvec3& place_m : mesh.positions_m) {
    box.low = glm::min(box.low, place_m);
    box.high = glm::max(box.high, place_m);
  }
  return box;
}

/// What the walls' outlines enclose, holes taken away, by the divergence theorem: the sum over faces of
/// x n_x dA / thickness.
double enclosed_m2(const TriangleMesh& mesh, double thickness_m) {
  double sum_m3 = 0.0;
  for (const TriangleIndices& face : mesh.faces) {
    const glm::dvec3 a = mesh.positions_m[face[0]], b = mesh.positions_m[face[1]],
                     c = mesh.positions_m[face[2]];
    sum_m3 += (a.x + b.x + c.x) / 3.0 * 0.5 * glm::cross(b - a, c - a).x;
  }
  return std::abs(sum_m3) / thickness_m;
}

// Fails if a letter is cut, mirrored about its middle or of another size.
TEST(TextMesh, HasTheSizeThatWasAsked) {
  for (const char* text : {"K", "O", "Offing"}) {
    const Box box = box_of(text_mesh(text, {.height_m = 200.0, .thickness_m = 60.0}));
    EXPECT_NEAR(box.high.y - box.low.y, 200.0, 1e-9) << text;
    EXPECT_NEAR(box.high.y + box.low.y, 0.0, 1e-9) << text;
    EXPECT_NEAR(box.high.x + box.low.x, 0.0, 1e-9) << text;
    EXPECT_NEAR(box.high.z, 30.0, 1e-12) << text;
    EXPECT_NEAR(box.low.z, -30.0, 1e-12) << text;
  }
}

// An O is a ring in every font: it encloses more than a tenth and less than 0.8 of its box; an l nearly all.
// Fails if holes wind the same way as outlines, or an outline is lost.
TEST(TextMesh, HolesAreHoles) {
  const TriangleMesh ring = text_mesh("O", {.height_m = 100.0, .thickness_m = 10.0});
  const Box box = box_of(ring);
  const double share = enclosed_m2(ring, 10.0) / ((box.high.x - box.low.x) * (box.high.y - box.low.y));
  EXPECT_GT(share, 0.1);
  EXPECT_LT(share, 0.7);
}

TEST(TextMesh, RefusesWhatHasNoOutlines) {
  // The last one is a letter that no font has, alone and beside one that it has: a box would be drawn.
  for (const char* text : {"", " ", "\xff\xfe", "\xf4\x8f\xbf\xbd", "K\xf4\x8f\xbf\xbd"})
    EXPECT_THROW(text_mesh(text, {}), Error) << text;
  EXPECT_THROW(text_mesh(std::string(65, 'a'), {}), Error);
}

}  // namespace
}  // namespace offing
