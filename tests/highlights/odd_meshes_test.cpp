// Meshes as they come: not manifold, open, in pieces, with faces and vertices that have no surface.
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/io/meshes/read_mesh.h"
#include "mesh_tools/curvature/curvature.h"
#include "tests/highlights/highlight_frame.h"
#include "tests/highlights/turning_mesh.h"

namespace offing::highlights {
namespace {

bool is_unit(const glm::dvec3& v) {
  return std::abs(glm::length(v) - 1.0) < 1e-6;
}

/// Turns the mesh by a quarter and asks whether every number of every frame makes sense. Returns how many
/// highlights were shown, frames together.
std::size_t expect_sound(const TriangleMesh& mesh, int smoothing_rounds) {
  const ocl::Device device = ocl::Device::open();
  const HighlightSurface surface(device, mesh, mesh_tools::vertex_curvatures(mesh).curvatures,
                                 {.smoothing_rounds = smoothing_rounds});
  const test::TurningMesh turning{.degrees_per_frame = 3.0, .moving_frames = 30};
  HighlightTracker tracks(surface, turning.lighting_at(surface));
  RegionSearch regions(surface);
  HighlightFrame frame;
  std::size_t shown_in_all = 0;
  for (int number = 0; number < turning.moving_frames; ++number) {
    tracks.advance_to(number / turning.frames_per_s);
    make_frame(tracks.tracks(), regions, frame);
    shown_in_all += frame.highlights.size();
    for (const ShownHighlight& shown : frame.highlights) {
      const Projector& p = shown.projector;
      EXPECT_TRUE(is_unit(p.right) && is_unit(p.up) && is_unit(p.normal));
      EXPECT_LE(glm::distance(glm::cross(p.right, p.up), p.normal), 1e-6);
      EXPECT_TRUE(std::isfinite(glm::length(p.centre_m)));
      EXPECT_TRUE(p.width_m > 0.0 && p.height_m > 0.0 && std::isfinite(p.width_m + p.height_m));
      EXPECT_TRUE(shown.opacity > 0.0 && shown.opacity <= 1.0);
      const auto faces = frame.faces_of(shown);
      EXPECT_GE(faces.size(), 1u);
      EXPECT_EQ(std::set<std::uint32_t>(faces.begin(), faces.end()).size(), faces.size());
      for (const std::uint32_t face : faces) EXPECT_LT(face, mesh.faces.size());
    }
  }
  return shown_in_all;
}

// Fails if a face without an area, a face that names a vertex twice, a vertex without faces, an edge of three
// faces, a repeated or a turned face leads to NaN, a wrong index or an endless walk.
TEST(OddMeshesTest, FacesWithoutASurfaceAreNoTrouble) {
  TriangleMesh mesh;
  mesh.positions_m = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0},  {0.0, 0.0, 1.0}, {9.0, 9.0, 9.0},
                      {0.5, 0.5, 0.0}, {0.0, 0.0, 0.0}, {0.3, -1.0, 0.2}, {0.4, 0.1, -1.0}};
  const std::vector<TriangleIndices> closed{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  const std::vector<TriangleIndices> odd{{0, 0, 1}, {1, 1, 1}, {0, 1, 1}, {1, 2, 5}, {0, 1, 7},
                                         {6, 1, 8}, {0, 1, 3}, {3, 1, 0}, {0, 6, 0}, {2, 5, 1}};
  mesh.faces = closed;
  EXPECT_GE(expect_sound(mesh, 0), 1u);
  mesh.faces.insert(mesh.faces.end(), odd.begin(), odd.end());
  for (const int rounds : {0, 3}) expect_sound(mesh, rounds);
  mesh.faces = odd;
  expect_sound(mesh, 0);
  // All in one place.
  for (glm::dvec3& p : mesh.positions_m) p = glm::dvec3(1.0, 2.0, 3.0);
  EXPECT_EQ(expect_sound(mesh, 1), 0u);
}

// A file's normals may be of any length, or none, where those of faces stand for them. Fails if they are
// taken for unit vectors.
TEST(OddMeshesTest, NormalsOfAnyLengthAreNormals) {
  TriangleMesh mesh;
  mesh.positions_m = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, {1.0, 1.0, 1.0}};
  mesh.faces = {{0, 1, 2}, {1, 0, 3}};
  const ocl::Device device = ocl::Device::open();
  HighlightFinder search(device);
  const Lighting lighting{{Source::Kind::direction, {0.5, 0.6, 0.7}},
                          {{Source::Kind::direction, {0.5, 0.6, 0.7}}}};
  const auto points = [&](double length) {
    mesh.normals = {{length, 0.0, 0.0}, {0.0, 2.0, 0.0}, {0.0, 0.0, 1e-3}, {0.0, 0.0, 0.0}};
    return search.find({device, mesh, mesh_tools::vertex_curvatures(mesh).curvatures}, lighting);
  };
  const std::vector<HighlightPoint> some = points(1.0), others = points(1e-3);
  ASSERT_EQ(some.size(), 2u);
  ASSERT_EQ(others.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_LE(glm::distance(some[i].position_m, others[i].position_m), 1e-6);
}

// Every mesh of the test data. Fails if one crashes, leaves the range of anything, or if most show nothing
// (open ones may have no N = H in this light).
TEST(OddMeshesTest, RealMeshesAreSound) {
  const char* folder = std::getenv("OFFING_TEST_DATA");
  if (folder == nullptr) GTEST_SKIP() << "OFFING_TEST_DATA names no folder with meshes";
  std::size_t count = 0, with_highlights = 0;
  for (const auto& file : std::filesystem::directory_iterator(std::filesystem::path(folder) / "meshes")) {
    SCOPED_TRACE(file.path().filename().string());
    ++count;
    with_highlights += expect_sound(read_mesh(file.path()), 0) > 0 ? 1 : 0;
  }
  EXPECT_GE(with_highlights, (count + 1) / 2);
}

}  // namespace
}  // namespace offing::highlights
