// Meshes of a world and their highlights, without a picture.
#include "host/world/world_mesh.h"

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/highlights/curvature/diffused_curvature.h"
#include "host/mesh_shapes/shape.h"
#include "host/world/world.h"

namespace offing::world {
namespace {

using highlights::Lighting;
using highlights::Source;

MeshParameters mesh_of(const mesh_shapes::Shape& shape) {
  MeshParameters parameters;
  parameters.name = "shape";
  parameters.mesh = std::make_shared<TriangleMesh>(shape.mesh);
  return parameters;
}

/// An eye before the mesh, and a light that goes around it.
Lighting turning_light(double time_s) {
  return {.eye = {.kind = Source::Kind::place, .vector = {0.0, 1.0, 9.0}},
          .lights = {{.vector = {std::sin(0.7 * time_s), 0.8, std::cos(0.7 * time_s)}}}};
}

// Fails if a mesh that brings no curvatures gets others than its own from the device: on a sphere of 2 m the
// half width of N.H = 0.95 is 2 sqrt(1 - 0.95^2) = 0.6245 m. The method averages over facets of an eighth of
// the radius: 3 %.
TEST(WorldMeshTest, MakesCurvaturesOnTheDevice) {
  WorldMesh view(ocl::Device::open(), mesh_of(mesh_shapes::make_sphere(2.0, 3)));
  view.at(0.0, turning_light);
  ASSERT_EQ(view.highlights().size(), 1u);
  EXPECT_NEAR(0.5 * view.highlights()[0].projector.width_m, 0.6245, 0.03 * 0.6245);
  EXPECT_NEAR(0.5 * view.highlights()[0].projector.height_m, 0.6245, 0.03 * 0.6245);
  EXPECT_FALSE(view.highlight_faces().empty());
}

// A sphere where a country's map has it, millions of metres off: fails if its vertices are rounded to a
// quarter of a metre before their curvatures are made. By the rounding of doubles and floats: 1e-4.
TEST(WorldMeshTest, MakesCurvaturesFarFromTheOrigin) {
  const glm::dvec3 far_m(500000.0, 100.0, 4500000.0);
  const mesh_shapes::Shape shape = mesh_shapes::make_sphere(1.0, 3);
  mesh_shapes::Shape there = shape;
  for (glm::dvec3& position_m : there.mesh.positions_m) position_m += far_m;
  WorldMesh near_view(ocl::Device::open(), mesh_of(shape)), far_view(ocl::Device::open(), mesh_of(there));
  near_view.at(0.0, turning_light);
  far_view.at(0.0, [&](double time_s) {
    Lighting lighting = turning_light(time_s);
    lighting.eye.vector += far_m;
    return lighting;
  });
  ASSERT_EQ(far_view.highlights().size(), 1u);
  const highlights::Projector &expected = near_view.highlights().at(0).projector,
                              &found = far_view.highlights()[0].projector;
  EXPECT_NEAR(found.width_m, expected.width_m, 1e-4);
  EXPECT_NEAR(found.height_m, expected.height_m, 1e-4);
  EXPECT_LE(glm::distance(found.centre_m, far_m + expected.centre_m), 1e-4);
}

// Fails if what is shown at a time alone depends on what was before: forward, back, over the round times at
// which the past of such pictures begins, and after an eye was followed.
TEST(WorldMeshTest, DependsOnTheTimeAlone) {
  const ocl::Device device = ocl::Device::open();
  const MeshParameters parameters = mesh_of(mesh_shapes::make_torus_knot({}, {.u_cells = 60, .v_cells = 8}));
  WorldMesh used(device, parameters);
  for (const double time_s : {3.0, 21.5, 0.5, 20.1, 19.9, -7.0}) {
    WorldMesh fresh(device, parameters);
    fresh.at(time_s, turning_light);
    used.at(time_s, turning_light);
    ASSERT_FALSE(fresh.highlights().empty());
    ASSERT_EQ(used.highlights().size(), fresh.highlights().size()) << time_s;
    for (std::size_t i = 0; i < fresh.highlights().size(); ++i) {
      EXPECT_EQ(used.highlights()[i].id, fresh.highlights()[i].id);
      EXPECT_EQ(used.highlights()[i].projector, fresh.highlights()[i].projector);
      EXPECT_EQ(used.highlights()[i].opacity, fresh.highlights()[i].opacity);
    }
    EXPECT_EQ(used.highlight_faces(), fresh.highlight_faces());
    used.follow(time_s, turning_light(50.0));
  }
}

// A sphere spins, one turn in 9 s, a frame of 30 a second before 20 s and after: fails if a sequence pops
// where pictures alone have another past, or if its pictures depend on which were asked for.
TEST(WorldMeshTest, SequencesGoOnOverRoundTimes) {
  const ocl::Device device = ocl::Device::open();
  MeshParameters parameters = mesh_of(mesh_shapes::make_ellipsoid({1.0, 0.97, 1.0}, 3));
  parameters.tracks.step_s = 1.0 / 30.0;
  parameters.motion = [](double time_s) {
    const double angle = 2.0 * std::numbers::pi * time_s / 9.0, c = std::cos(angle), s = std::sin(angle);
    return highlights::RigidMotion{.rotation = glm::dmat3({c, 0.0, -s}, {0.0, 1.0, 0.0}, {s, 0.0, c})};
  };
  const auto still = [](double) { return turning_light(0.5); };
  WorldMesh view(device, parameters);
  const auto shown_at = [&](WorldMesh& shown, double time_s) {
    shown.at(time_s, still, 0.1);
    EXPECT_EQ(shown.highlights().size(), 1u);
    return shown.highlights().at(0);
  };
  const highlights::DrawnHighlight before = shown_at(view, 599 / 30.0), after = shown_at(view, 20.0);
  EXPECT_EQ(after.id, before.id);
  EXPECT_LE(glm::distance(after.projector.up, before.projector.up), 0.08);  // 4.1 degrees are 0.072
  EXPECT_LE(std::abs(after.projector.width_m / before.projector.width_m - 1.0), 0.1);
  WorldMesh fresh(device, parameters);
  EXPECT_EQ(shown_at(fresh, 20.0).projector, after.projector);
}

// Fails if a highlight that is followed jumps, stays behind or becomes another: with the light 12 degrees on
// at once, it goes 0.1 m by no more than 1.5 % of the diagonal, 0.06 m, in a 30th of a second, and is there
// soon.
TEST(WorldMeshTest, FollowsSmoothly) {
  WorldMesh view(ocl::Device::open(), mesh_of(mesh_shapes::make_sphere(1.0, 3)));
  view.follow(0.0, turning_light(0.0));
  ASSERT_EQ(view.highlights().size(), 1u);
  const highlights::DrawnHighlight start = view.highlights()[0];
  glm::dvec3 before_m = start.projector.centre_m;
  for (int frame = 0; frame < 20; ++frame) {
    view.follow(0.0, turning_light(0.3));
    ASSERT_EQ(view.highlights().size(), 1u);
    ASSERT_EQ(view.highlights()[0].id, start.id);
    const glm::dvec3 now_m = view.highlights()[0].projector.centre_m;
    EXPECT_LT(glm::distance(now_m, before_m), 0.06);
    before_m = now_m;
  }
  for (int frame = 1; frame <= 90; ++frame) view.follow(frame / 30.0, turning_light(0.3));
  EXPECT_EQ(view.tracks()->key_count(), 1u) << "keeps states that it never goes back to";
  WorldMesh fresh(ocl::Device::open(), view.parameters());
  fresh.follow(0.0, turning_light(0.3));
  const glm::dvec3 there_m = fresh.highlights().at(0).projector.centre_m;
  EXPECT_GT(glm::distance(there_m, start.projector.centre_m), 0.07);
  EXPECT_LT(glm::distance(there_m, before_m), 0.001);
}

/// A sphere that grows along y by half of its radius a second, for 2 s.
MeshParameters growing_sphere() {
  MeshParameters parameters = mesh_of(mesh_shapes::make_sphere(1.0, 3));
  parameters.tracks.step_s = 1.0 / 30.0;
  parameters.deformation = {.form_at =
                                [mesh = parameters.mesh](double time_s) {
                                  MeshForm form{.positions_m = mesh->positions_m, .normals = {}};
                                  for (glm::dvec3& p : form.positions_m) p.y *= 1.0 + 0.5 * time_s;
                                  return form;
                                },
                            .end_s = 2.0};
  return parameters;
}

// The same mesh by hand: fails if highlights of a mesh that deforms are not those of a tracker whose surface
// has the form of each step, if the surface is not that of the shown time, also going back, or if what is
// copied from it is not told of a new form, or is told without one.
TEST(WorldMeshTest, DeformsWithTime) {
  const ocl::Device device = ocl::Device::open();
  const MeshParameters parameters = growing_sphere();
  WorldMesh view(device, parameters);
  highlights::DiffusedCurvature curvature(device, *parameters.mesh);
  highlights::HighlightSurface surface(device, *parameters.mesh, curvature.of(parameters.mesh->positions_m));
  highlights::TrackOptions options = parameters.tracks;
  options.has_shadows = true;
  highlights::HighlightTracker tracks(
      surface,
      [&](double time_s) {
        MeshForm form = parameters.deformation.form_at(std::min(time_s, 2.0));
        VertexCurvatures bends = curvature.of(form.positions_m);
        surface.deform(std::move(form.positions_m), {}, std::move(bends));
        return turning_light(time_s);
      },
      options);
  tracks.reset(0.0);
  for (const double time_s : {0.5, 1.51, 3.0, 1.0}) {
    view.at(time_s, turning_light);
    ASSERT_EQ(view.highlights().size(), 1u);
    const highlights::TrackState& expected = tracks.shown_at(time_s);
    ASSERT_EQ(expected.tracks.size(), 1u);
    EXPECT_EQ(view.highlights()[0].projector, expected.tracks[0].projector) << time_s;
    EXPECT_EQ(view.surface().mesh().positions_m, surface.mesh().positions_m) << time_s;
    EXPECT_NEAR(view.surface().diagonal_m(),
                std::sqrt(8.0 + 4.0 * std::pow(1.0 + 0.5 * std::min(time_s, 2.0), 2)), 0.02);
    const std::uint64_t revision = view.revision();
    view.at(time_s, turning_light);
    EXPECT_EQ(view.revision(), revision) << time_s;
  }
  const std::uint64_t revision = view.revision();
  view.follow(2.0, turning_light(2.0));
  EXPECT_NE(view.revision(), revision);
  EXPECT_NEAR(view.surface().diagonal_m(), std::sqrt(8.0 + 16.0), 0.02);
  const std::uint64_t last = view.revision();
  view.follow(2.1, turning_light(2.1));
  EXPECT_EQ(view.revision(), last) << "a form is made anew after the last one";
}

// Fails if a mesh without highlights has some, or is in another place than it moves to.
TEST(WorldMeshTest, MovesWithoutHighlights) {
  MeshParameters parameters = mesh_of(mesh_shapes::make_sphere(1.0, 1));
  parameters.has_highlights = false;
  parameters.motion = [](double time_s) {
    return highlights::RigidMotion{.translation_m = {time_s, 0.0, 0.0}};
  };
  WorldMesh view(ocl::Device::open(), parameters);
  parameters.deformation = growing_sphere().deformation;
  parameters.deformation.form_at = [mesh = parameters.mesh](double time_s) {
    MeshForm form{.positions_m = mesh->positions_m, .normals = {}};
    for (glm::dvec3& p : form.positions_m) p *= 1.0 + time_s;
    return form;
  };
  WorldMesh grown(ocl::Device::open(), parameters);
  grown.at(1.0, turning_light);
  EXPECT_NEAR(grown.surface().diagonal_m(), 2.0 * view.surface().diagonal_m(), 1e-12);
  view.at(4.0, turning_light);
  EXPECT_EQ(view.motion().translation_m.x, 4.0);
  EXPECT_TRUE(view.highlights().empty());
  EXPECT_TRUE(view.highlight_faces().empty());
}

// Fails if a world has other lights than its own and the sun while that is up, or takes more than it can
// show.
TEST(WorldMeshTest, IsLitByLightsAndSun) {
  WorldParameters parameters;
  parameters.has_sea = false;
  parameters.lights.resize(2);
  World world(ocl::Device::open(), parameters);
  EXPECT_EQ(world.lighting({1.0, 2.0, 3.0}).lights.size(), 3u);
  EXPECT_EQ(world.lighting({1.0, 2.0, 3.0}).eye.vector, glm::dvec3(1.0, 2.0, 3.0));
  world.set_sun({{0.0, -0.6, 0.8}});
  EXPECT_EQ(world.lighting({}).lights.size(), 2u);
  try {
    world.set_lights(std::vector<Light>(most_lights + 1));
    FAIL() << "took too many lights";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_usage);
    EXPECT_STREQ(error.what(), "lights: expected at most 63, found 64");
  }
  EXPECT_EQ(world.parameters().lights.size(), 2u);
}

}  // namespace
}  // namespace offing::world
