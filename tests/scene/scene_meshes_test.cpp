// From a scene to the meshes, lights and rules of its world.
#include "host/scene/prepare/scene_meshes.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/io/meshes/prepared_mesh.h"
#include "host/io/meshes/write_mesh.h"
#include "host/io/png_image.h"
#include "host/mesh_shapes/shape.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/file/scene_files.h"
#include "host/scene/prepare/world_scene.h"
#include "host/scene/schema/unused_parameters.h"
#include "tests/io/temporary_folder.h"

namespace offing::scene {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

Scene scene_of(const std::string& text, const std::filesystem::path& folder = "") {
  return parse_scene("version = 1\n" + text, "a.toml", folder);
}

template <class Make>
std::string refusal(Make make) {
  try {
    make();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_FALSE(error.hint().empty());
    return error.what();
  }
  return "";
}

void expect_near(const glm::dvec3& found, const glm::dvec3& expected) {
  EXPECT_LT(glm::distance(found, expected), 1e-12)
      << found.x << ' ' << found.y << ' ' << found.z << " instead of " << expected.x << ' ' << expected.y
      << ' ' << expected.z;
}

// Fails if a shape has another size, or another fineness than is promised: the knot of the paper's figure 8
// has 2,880 faces.
TEST(SceneMeshes, ShapesAreMade) {
  const auto meshes = prepare_meshes(
      scene_of("[[mesh]]\nflat_limit = \"edges\"\n[[mesh]]\nshape = \"sphere\"\nsize_m = 3\nscale = "
               "2\ndetail = 1\nname = \"ball\"\n"
               "smoothing_rounds = 4\nthreshold = 0.9\ncap_radius_m = 0.5\nhighlights = \"off\"\n"));
  ASSERT_EQ(meshes.size(), 2u);
  EXPECT_EQ(meshes[0].mesh->faces.size(), 2880u);
  ASSERT_TRUE(meshes[0].curvatures);
  const world::MeshParameters& ball = meshes[1];
  EXPECT_EQ(ball.mesh->faces.size(), 20u * 4 * 4 * 4);
  for (const glm::dvec3& place_m : ball.mesh->positions_m) EXPECT_NEAR(glm::length(place_m), 6.0, 1e-12);
  double area_m2 = 0.0;
  for (std::size_t i = 0; i < ball.mesh->positions_m.size(); ++i) {
    EXPECT_NEAR(ball.curvatures->k_min_per_m[i], 1.0 / 6.0, 1e-12);
    area_m2 += ball.curvatures->area_m2[i];
  }
  // Of a sphere of radius 6, less what flat faces of level 3 cut off: 0.48 %.
  EXPECT_NEAR(area_m2 / (4.0 * std::numbers::pi * 36.0), 0.995, 0.002);
  EXPECT_EQ(ball.name, "ball");
  EXPECT_EQ(ball.surface.smoothing_rounds, 4);
  EXPECT_EQ(ball.tracks.size.threshold, 0.9);
  EXPECT_EQ(ball.tracks.size.cap_radius_m, 0.5);
  EXPECT_FALSE(ball.has_highlights);
  EXPECT_TRUE(meshes[0].has_highlights);
  EXPECT_EQ(ball.tracks.size.flat_limit, highlights::FlatLimit::surface);
  EXPECT_EQ(meshes[0].tracks.size.flat_limit, highlights::FlatLimit::mean_edges);
}

// Fails if a shape that a scene can name cannot be made at all details.
TEST(SceneMeshes, EachShapeCanBeMade) {
  for (const char* shape :
       {"knot", "sphere", "ellipsoid", "torus", "saddle", "head", "ship", "bird", "boat", "box"}) {
    for (const char* detail : {"0", "3"}) {
      const Scene scene =
          scene_of(std::string("[[mesh]]\nshape = \"") + shape + "\"\ndetail = " + detail + "\n");
      const auto meshes = prepare_meshes(scene);
      EXPECT_GT(meshes[0].mesh->faces.size(), std::string(shape) == "box" ? 10u : 100u) << shape;
    }
  }
}

// Fails if the animation of a file does not begin again, begins at another time than it ends, or is not
// scaled.
TEST(SceneMeshes, AnimationsRepeat) {
  const auto form_at = [&](const std::string& more, double time_s) {
    const auto meshes = prepare_meshes(scene_of("[[mesh]]\nfile = \"gltf/moving\"\n" + more, OFFING_CORPUS));
    return meshes.at(0).deformation.form_at(time_s).positions_m;
  };
  const std::vector<glm::dvec3> once_m = form_at("", 0.25);
  EXPECT_EQ(form_at("animation_repeat = \"on\"", 2.25), once_m);
  EXPECT_NE(form_at("", 2.25), once_m);
  expect_near(form_at("scale = 3", 0.25)[2], 3.0 * once_m[2]);
}

// Fails if numbered files are not one mesh that deforms, if the files that a scene reads do not have them, or
// if a sequence without files is refused without its place in the scene.
TEST(SceneMeshes, SequencesDeform) {
  const TemporaryFolder folder;
  for (int i = 0; i < 3; ++i) {
    std::ofstream(folder.path() / ("wave_" + std::to_string(i) + ".obj"))
        << "v 0 0 0\nv 1 0 0\nv 0 " << 1 + i << " 0\nf 1 2 3\n";
  }
  const std::string text = "[[mesh]]\nfile = \"wave_%d.obj\"\nsequence_fps = 2\nscale = 10\n";
  const Scene scene = scene_of(text, folder.path());
  const auto meshes = prepare_meshes(scene);
  expect_near(meshes[0].deformation.form_at(0.25).positions_m[2], {0, 15, 0});
  EXPECT_EQ(meshes[0].deformation.end_s, 1.0);
  EXPECT_EQ(files_of(scene).size(), 4u);  // the name, too
  EXPECT_NE(refusal([&] {
              prepare_meshes(scene_of(text, folder.path() / "none"));
            }).find("a.toml:3:8: mesh.file: expected a mesh, got no such file"),
            std::string::npos);
}

// Fails if a mesh stands or turns another way than the scene says: yaw is clockwise from above, so that what
// looked north (-z) looks east (+x) after 90 degrees; a spin of 45 degrees a second adds 90 in two seconds;
// the -z side goes up by pitch, the +x side down by roll.
TEST(SceneMeshes, MeshesMoveAsTheSceneSays) {
  const Scene scene = scene_of(R"([[mesh]]
x_m = 1
y_m = 2
z_m = { keys = [{ t = 0, value = 0 }, { t = 4, value = 8 }], interpolation = "linear" }
yaw_deg = 90
spin_deg_per_s = 45
[[mesh]]
pitch_deg = 30
[[mesh]]
roll_deg.keys = [{ t = 0, value = 0 }, { t = 2, value = 90 }]
)");
  const auto meshes = prepare_meshes(scene);
  const highlights::RigidMotion start = meshes[0].motion(0.0), later = meshes[0].motion(2.0);
  expect_near(start.translation_m, {1.0, 2.0, 0.0});
  expect_near(start.rotation * glm::dvec3(0.0, 0.0, -1.0), {1.0, 0.0, 0.0});
  expect_near(later.translation_m, {1.0, 2.0, 4.0});
  expect_near(later.rotation * glm::dvec3(0.0, 0.0, -1.0), {0.0, 0.0, 1.0});
  expect_near(meshes[1].motion(7.0).rotation * glm::dvec3(0.0, 0.0, -1.0),
              {0.0, std::sin(30.0 * degree), -std::cos(30.0 * degree)});
  expect_near(meshes[2].motion(2.0).rotation * glm::dvec3(1.0, 0.0, 0.0), {0.0, -1.0, 0.0});
  expect_near(meshes[2].motion(9.0).rotation * glm::dvec3(1.0, 0.0, 0.0), {0.0, -1.0, 0.0});
}

// Fails if the scene's folder is forgotten, a prepared mesh loses its curvatures, another one gets some, or
// scale does not reach them.
TEST(SceneMeshes, FilesAreRead) {
  const TemporaryFolder folder;
  mesh_shapes::Shape shape = mesh_shapes::make_sphere(1.0, 2);
  write_mesh(folder.path() / "plain.ply", shape.mesh);
  write_mesh(folder.path() / "plain.obj", shape.mesh);
  write_prepared(folder.path() / "prepared.ply", {shape.mesh, *shape.truth});
  const auto meshes =
      prepare_meshes(scene_of("[[mesh]]\nfile = \"plain.ply\"\n[[mesh]]\nfile = \"plain.obj\"\n"
                              "[[mesh]]\nfile = \"prepared.ply\"\nscale = 0.001\n",
                              folder.path()));
  for (const world::MeshParameters& mesh : meshes) EXPECT_EQ(mesh.mesh->faces, shape.mesh.faces);
  EXPECT_FALSE(meshes[0].curvatures);
  EXPECT_FALSE(meshes[1].curvatures);
  ASSERT_TRUE(meshes[2].curvatures);
  EXPECT_NEAR(meshes[2].curvatures->k_max_per_m[5], 1000.0, 1e-2);  // floats in the file
  EXPECT_NEAR(glm::length(meshes[2].mesh->positions_m[5]), 0.001, 1e-9);
}

// Fails if a file that is missing or broken is told without the place that names it.
TEST(SceneMeshes, FaultsOfFilesAreToldWithTheirPlace) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "broken.ply") << "ply\nformat ascii 1.0\n";
  std::ofstream(folder.path() / "broken.png") << "PNG";
  const auto prepare = [&](const std::string& text) {
    return refusal([&] { prepare_world(scene_of(text, folder.path())); });
  };
  const std::string base = folder.path().string();
  EXPECT_EQ(prepare("[[mesh]]\n[[mesh]]\nfile = \"nowhere.obj\"\n"),
            "a.toml:4:8: mesh.file: expected a mesh, got no such file, " + base + "/nowhere.obj");
  EXPECT_TRUE(prepare("[[mesh]]\nfile = \"broken.ply\"\n").starts_with("a.toml:3:8: mesh.file: " + base));
  const std::string highlight = "[[mesh]]\n[[mesh.highlight]]\ntexture = \"image\"\n";
  EXPECT_EQ(prepare(highlight),
            "a.toml:4:11: mesh.highlight.texture: expected a mesh.highlight.picture beside it, found none");
  EXPECT_EQ(prepare(highlight + "picture = \"nowhere.png\"\n"),
            "a.toml:5:11: mesh.highlight.picture: expected a PNG picture, got no such file, " + base +
                "/nowhere.png");
  EXPECT_TRUE(prepare(highlight + "picture = \"broken.png\"\n")
                  .starts_with("a.toml:5:11: mesh.highlight.picture: " + base));
}

// Fails if a light stands elsewhere than the scene says, or does not move. Azimuth 90 is east (+x).
TEST(SceneMeshes, SectionsBecomeLights) {
  const Scene scene = scene_of(R"([[light]]
azimuth_deg = { keys = [{ t = 0, value = 90 }, { t = 1, value = 180 }] }
elevation_deg = 0
illuminance_klx = 7
[[light]]
kind = "place"
x_m = 3
y_m = -4
z_m = 5
colour = { keys = [{ t = 0, value = [1, 0, 0] }, { t = 2, value = [0, 1, 0.5] }], interpolation = "linear" }
)");
  const auto lights = lights_at(scene, 0.0), later = lights_at(scene, 1.0);
  ASSERT_EQ(lights.size(), 2u);
  EXPECT_EQ(lights[0].source.kind, highlights::Source::Kind::direction);
  expect_near(lights[0].source.vector, {1.0, 0.0, 0.0});
  expect_near(later[0].source.vector, {0.0, 0.0, 1.0});
  EXPECT_EQ(lights[0].illuminance_klx, 7.0);
  EXPECT_EQ(lights[1].source.kind, highlights::Source::Kind::place);
  expect_near(lights[1].source.vector, {3.0, -4.0, 5.0});
  expect_near(later[1].colour, {0.5, 0.5, 0.25});
}

// Fails if a rule is for another mesh or light than the scene says; the sun is the light behind all lights.
TEST(SceneMeshes, RulesNameTheirLights) {
  const Scene scene = scene_of(R"([[light]]
[[light]]
name = "lamp"
[[mesh]]
[[mesh]]
specular = { keys = [{ t = 0, value = 0 }, { t = 1, value = 1 }], interpolation = "linear" }
[[mesh.highlight]]
light = "lamp"
pin_m = [1, 2, 3]
opacity.keys = [{ t = 0, value = 0 }, { t = 2, value = 1 }]
[[mesh.highlight]]
light = "sun"
[[mesh.highlight]]
)");
  const auto rules = mesh_rules_at(scene, 1.0);
  ASSERT_EQ(rules.size(), 2u);
  EXPECT_TRUE(rules[0].empty());
  ASSERT_EQ(rules[1].size(), 3u);
  EXPECT_EQ(rules[1][0].light, 1);
  EXPECT_EQ(rules[1][0].pin_m, glm::dvec3(1.0, 2.0, 3.0));
  EXPECT_NEAR(rules[1][0].controls.opacity, 0.5, 1e-12);
  EXPECT_EQ(rules[1][1].light, 2);
  EXPECT_FALSE(rules[1][2].light);
  EXPECT_NEAR(mesh_materials_at(scene, 0.25)[1].specular, 0.25, 1e-12);
  EXPECT_EQ(refusal([] {
              mesh_rules_at(
                  scene_of("[[light]]\nname = \"a\"\n[[mesh]]\n[[mesh.highlight]]\nlight = \"b\"\n"), 0.0);
            }),
            "a.toml:6:9: mesh.highlight.light: expected the name of a [[light]] or sun, got \"b\"");
  EXPECT_THROW(lights_at(scene, 1e9), Error);
  for (const std::string twice : {"a", "sun"}) {
    EXPECT_EQ(refusal([&] {
                lights_at(scene_of("[[light]]\nname = \"a\"\n[[light]]\nname = \"" + twice + "\"\n"), 0.0);
              }),
              "a.toml:5:8: light.name: expected a name that no other light has, got \"" + twice + '"');
  }
}

// Fails if a world's own lights and those of a scene's lighting are others, by day or by night.
TEST(SceneMeshes, LightingIsThatOfTheWorld) {
  for (const char* elevation : {"20", "-20"}) {
    const Scene scene =
        scene_of(std::string("[[mesh]]\nshape = \"sphere\"\n[[light]]\nazimuth_deg = 40\n[camera]\nx_m = 3\n"
                             "[sun]\nelevation_deg = ") +
                 elevation + "\n");
    world::World world(ocl::Device::open(), prepare_world(scene));
    const ViewScene view = show_at(world, scene, 1.5);
    const highlights::Lighting expected = world.lighting(view.camera.eye_m), found = lighting_of(scene)(1.5);
    expect_near(found.eye.vector, expected.eye.vector);
    ASSERT_EQ(found.lights.size(), expected.lights.size());
    for (std::size_t i = 0; i < found.lights.size(); ++i) {
      EXPECT_EQ(found.lights[i].kind, expected.lights[i].kind);
      expect_near(found.lights[i].vector, expected.lights[i].vector);
    }
  }
}

// Fails if a live edit leaves a mesh as it was, makes one anew that needs not be, or differs from a fresh
// start.
TEST(SceneMeshes, EditsReachTheWorld) {
  const std::string text = "[[mesh]]\nshape = \"sphere\"\n";
  Scene before = scene_of(text);
  world::World world(ocl::Device::open(), prepare_world(before));
  const auto edit = [&](const std::string& more) {
    const Scene after = scene_of(text + more);
    edit_world(world, before, after);
    before = after;
    return world.meshes()[0].revision();
  };
  const auto first = world.meshes()[0].revision();
  EXPECT_EQ(edit("colour = [1, 0, 0]\n"), first);
  EXPECT_EQ(world.meshes()[0].parameters().material.colour, glm::dvec3(1.0, 0.0, 0.0));
  EXPECT_EQ(edit("[[mesh.highlight]]\nscale = 2\n[[light]]\n"), first);
  ASSERT_EQ(world.meshes()[0].parameters().rules.size(), 1u);
  EXPECT_EQ(world.meshes()[0].parameters().rules[0].controls.scale, 2.0);
  EXPECT_EQ(world.parameters().lights.size(), 1u);
  const TemporaryFolder folder;
  const std::filesystem::path picture = folder.path() / "white.png";
  write_png(picture, {2, 1, {255, 255, 255, 255, 255, 255}});
  EXPECT_EQ(edit("[[mesh.highlight]]\ntexture = \"image\"\npicture = \"" + picture.string() + "\"\n"), first);
  ASSERT_EQ(world.parameters().pictures.size(), 1u);
  EXPECT_EQ(world.parameters().pictures[0]->rgba, std::vector<std::uint8_t>(8, 255));
  EXPECT_EQ(world.meshes()[0].parameters().rules[0].controls.picture, 0);
  const auto data = world.meshes()[0].parameters().mesh;
  EXPECT_NE(edit("x_m.keys = [{ t = 0, value = 0 }, { t = 1, value = 1 }]\n"), first);
  EXPECT_EQ(world.meshes()[0].parameters().mesh, data) << "the same shape was made again";
  EXPECT_EQ(world.meshes()[0].parameters().motion(1.0).translation_m.x, 1.0);
  edit("size_m = 2\n[[mesh]]\n");
  EXPECT_NE(world.meshes()[0].parameters().mesh, data);
  EXPECT_EQ(world.meshes().size(), 2u);
}

// Fails if a scene of meshes alone shows something else, if one of them leaves the picture, or if a camera
// that the scene has is moved.
TEST(SceneMeshes, AreLookedAt) {
  Scene scene = scene_of("[[mesh]]\nx_m = 40\ny_m = 3\n[[mesh]]\nshape = \"ship\"\nsize_m = 12\nx_m = 60\n");
  const world::WorldParameters parameters = prepare_shown_world(scene);
  const Camera& camera = scene.view.camera;
  const glm::dmat4 view = projection(camera, 0.1) * glm::dmat4(view_rotation(camera));
  double widest = 0.0;
  for (const world::MeshParameters& mesh : parameters.meshes) {
    const highlights::RigidMotion motion = mesh.motion(0.0);
    for (const glm::dvec3& place_m : mesh.mesh->positions_m) {
      const glm::dvec4 clip =
          view * glm::dvec4(motion.rotation * place_m + motion.translation_m - camera.eye_m, 1.0);
      ASSERT_GT(clip.w, 0.0);
      widest = std::max({widest, std::abs(clip.x / clip.w), std::abs(clip.y / clip.w)});
    }
  }
  EXPECT_LT(widest, 1.0);
  EXPECT_GT(widest, 0.3);
  Scene placed = scene_of("[[mesh]]\n[camera]\nx_m = 3\n"), wet = scene_of("[[mesh]]\n[ocean]\nsize = 32\n");
  prepare_shown_world(placed);
  prepare_shown_world(wet);
  EXPECT_EQ(placed.view.camera.eye_m, glm::dvec3(3.0, 5.0, 0.0));
  EXPECT_EQ(wet.view.camera.eye_m, glm::dvec3(0.0, 5.0, 0.0));
}

// Fails if a value that changes nothing is passed over in silence, or one that does is complained of.
TEST(SceneMeshes, UnusedValuesAreTold) {
  EXPECT_EQ(unused_parameters(scene_of(R"([[light]]
x_m = 1
[[light]]
kind = "place"
x_m = 1
azimuth_deg = 1
[[mesh]]
file = "b.obj"
size_m = 2
shininess = 4
cartoon_steps = 2
[[mesh.highlight]]
split_gap = 1
[[mesh]]
highlights = "off"
specular.keys = [{ t = 0, value = 0 }, { t = 1, value = 1 }]
shininess = 4
size_m = 3
[[mesh.highlight]]
scale = 2
)")),
            (std::vector<std::string>{
                "a.toml:7:15: light.azimuth_deg: not used: the light stands at a place",
                "a.toml:3:7: light.x_m: not used: the light is of kind direction",
                "a.toml:10:10: mesh.size_m: not used: the mesh comes from b.obj",
                "a.toml:11:13: mesh.shininess: not used: mesh.specular is 0",
                "a.toml:12:17: mesh.cartoon_steps: not used: the shading is phong",
                "a.toml:21:9: mesh.highlight.scale: not used: the mesh's highlights are off",
                "a.toml:14:13: mesh.highlight.split_gap: not used: mesh.highlight.split is 1"}));
}

}  // namespace
}  // namespace offing::scene
