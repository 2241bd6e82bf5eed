// What hulls enclose, against closed forms.
#include "host/bodies/hull.h"

#include <numbers>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "tests/bodies/example_bodies.h"

namespace offing::bodies {
namespace {

TriangleMesh moved(TriangleMesh mesh, const glm::dvec3& by_m) {
  for (glm::dvec3& place : mesh.positions_m) place += by_m;
  return mesh;
}

// Fails if a moment is wrong, or loses digits far from the origin: 2e5 m away, products of three places have
// lost 16 digits.
TEST(EnclosedTest, Box) {
  const glm::dvec3 away(2e5, -3.0, 7.0);
  const Enclosed found = enclosed_by(moved(test::box({4.0, 2.0, 3.0}), away));
  EXPECT_NEAR(found.volume_m3, 24.0, 1e-8);
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(found.centre_m[axis], away[axis], 1e-8);
  const glm::dvec3 moments = 24.0 / 12.0 * glm::dvec3(4.0 + 9.0, 16.0 + 9.0, 16.0 + 4.0);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(found.inertia_m5[i][j], i == j ? moments[i] : 0.0, 1e-8);
  }
}

// Fails if faces count twice or not: an icosphere of level 5 has 0.17 % less than the sphere around it (the
// mean sagitta of its faces), its moments 5/3 of that.
TEST(EnclosedTest, Sphere) {
  const Enclosed found = enclosed_by(test::ball(2.0, 5));
  const double volume_m3 = 4.0 / 3.0 * std::numbers::pi * 8.0;
  EXPECT_NEAR(found.volume_m3 / volume_m3, 1.0, 2e-3);
  EXPECT_LT(found.volume_m3, volume_m3);
  EXPECT_NEAR(found.inertia_m5[1][1] / (0.4 * volume_m3 * 4.0), 1.0, 4e-3);
}

std::string fault_of(const TriangleMesh& mesh) {
  try {
    require_hull(mesh, "boat");
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_NE(error.hint(), "");
    return error.what();
  }
  return "";
}

// Fails if a mesh that water would press on from inside is taken.
TEST(HullTest, IsClosedAndTurnedOutward) {
  TriangleMesh mesh = test::box({1.0, 1.0, 1.0});
  EXPECT_EQ(fault_of(mesh), "");
  TriangleMesh open = mesh;
  open.faces.pop_back();
  EXPECT_EQ(fault_of(open), "boat: expected a closed mesh, found 3 edges that are open or turned");
  TriangleMesh inside_out = mesh;
  for (TriangleIndices& face : inside_out.faces) std::swap(face[0], face[1]);
  EXPECT_EQ(fault_of(inside_out), "boat: expected faces that point outward around a volume, found -1 m3");
  EXPECT_EQ(fault_of({}), "boat: expected a closed mesh, found no faces");
}

// Fails if the shapes that scenes have are no hulls.
TEST(HullTest, ShipsAre) {
  EXPECT_EQ(fault_of(test::ship(24.0)), "");
}

}  // namespace
}  // namespace offing::bodies
