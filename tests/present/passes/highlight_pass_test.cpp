// Highlights in pictures: where theory has them, and nowhere else.
#include "present/passes/meshes/highlight_pass.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "host/highlights/projectors/texture_shapes.h"
#include "host/highlights/search/face_tree.h"
#include "tests/present/passes/mesh_stage.h"

namespace offing::present {
namespace {

using highlights::HighlightTexture;
using test::MeshStage;

class HighlightPassTest : public MeshStage {
 protected:
  static world::MeshParameters shining(const mesh_shapes::Shape& shape, HighlightTexture texture,
                                       double softness) {
    world::MeshParameters mesh = mesh_of(shape);
    mesh.material.colour = glm::dvec3(0.1);
    mesh.has_highlights = true;
    mesh.rules = {{.controls = {.texture = texture, .softness = softness}}};
    return mesh;
  }

  /// Pictures with the highlights and without.
  struct Pair {
    std::vector<float> with, without;
  };
  Pair pictures(double time_s = 0.0) {
    world::WorldMesh& mesh = world_->meshes()[0];
    const std::vector<highlights::HighlightRule> rules = mesh.parameters().rules;
    Pair pair{.with = light(time_s), .without = {}};
    highlights::HighlightRule hidden;
    hidden.controls.opacity = 0.0;
    mesh.set_rules({hidden});
    pair.without = light(time_s);
    mesh.set_rules(rules);
    return pair;
  }

  /// How much of a highlight each pixel has, 0 ... 1, over the mesh: of white in all light, in the sun's
  /// colour.
  std::vector<double> opacities(const Pair& pair) const {
    const sky::Illuminance& sky = world_->illuminance();
    const double sun_klx = sky::luminance(sky.sun_klx), all_klx = sun_klx + sky::luminance(sky.sky_klx);
    const double white = sky.sun_klx[1] * all_klx / sun_klx / std::numbers::pi;
    std::vector<double> shares;
    for (std::size_t i = 1; i < pair.with.size(); i += 4) {
      shares.push_back((pair.with[i] - pair.without[i]) / (white - pair.without[i]));
    }
    return shares;
  }

  glm::dvec3 toward_sun() const {
    const auto& [x, y, z] = world_->parameters().sun.sun_direction;
    return {x, y, z};
  }
};

// Fails if a highlight's middle is not where N = H: on the unit sphere, the n that is (L + V) / |L + V| for V
// from n to the eye, by fixed point. Pixels of more than 0.9 of a dot of softness 1 reach a fifth of its half
// width, so that their mean is off the middle by less than 0.1 px. Gate 0.3 px.
TEST_F(HighlightPassTest, HasItsMiddleWhereTheNormalIsTheHalfVector) {
  open(shining(mesh_shapes::make_sphere(1.0, 4), HighlightTexture::dot, 1.0));
  glm::dvec3 normal(0.0, 0.0, 1.0);
  for (int i = 0; i < 50; ++i) {
    const glm::dvec3 toward_eye = glm::normalize(camera().eye_m - (place_m + normal));
    normal = glm::normalize(toward_sun() + toward_eye);
  }
  const std::vector<double> shares = opacities(pictures());
  glm::dvec2 sum(0.0);
  double count = 0.0;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      if (shares[static_cast<std::size_t>(row * width + column)] < 0.9) continue;
      sum += glm::dvec2(column + 0.5, row + 0.5);
      count += 1.0;
    }
  }
  ASSERT_GT(count, 5.0);
  const glm::dvec2 expected = pixel_of(place_m + normal);
  EXPECT_LT(glm::distance(sum / count, expected), 0.3);
}

// Fails if a shape is drawn shifted, mirrored, upside down, beyond its box or with another rim: each pixel
// has the opacity of texture_shapes.h where its ray meets the mesh, in the projector's box. A pixel's width
// of the shader is a difference to its neighbour; the mean difference over the box's pixels is below 0.02,
// and beyond a pixel of the box nothing changes at all.
TEST_F(HighlightPassTest, DrawsShapesInTheirBoxAndNothingBeyond) {
  for (int kind = 0; kind < 6; ++kind) {
    const auto texture = static_cast<HighlightTexture>(kind);
    world::MeshParameters mesh = shining(mesh_shapes::make_ellipsoid({1.0, 0.8, 0.9}, 4), texture, 0.25);
    mesh.tracks.size.flat_limit = highlights::FlatLimit::mean_edges;  // all of the box within the outline
    mesh.rules[0].controls.scale = 2.0;
    mesh.rules[0].controls.rotation_rad = 0.4;
    open(mesh);
    const Pair pair = pictures();
    const std::vector<double> shares = opacities(pair);
    const std::vector<highlights::DrawnHighlight>& shown = world_->meshes()[0].highlights();
    ASSERT_EQ(shown.size(), 0u) << "the last picture hides them";
    light();
    ASSERT_EQ(world_->meshes()[0].highlights().size(), 1u);
    const glm::dmat4 to_box = highlights::projection_of(world_->meshes()[0].highlights()[0].projector);
    const highlights::FaceTree tree(world_->meshes()[0].surface().mesh());
    double difference = 0.0, within = 0.0, opaque = 0.0;
    for (int row = 0; row < height; ++row) {
      for (int column = 0; column < width; ++column) {
        const auto i = static_cast<std::size_t>(row * width + column);
        const glm::dvec3 eye_m = camera().eye_m - place_m, ray = ray_of(column, row);
        const auto hit = tree.first_hit(eye_m, ray, 100.0);
        const glm::dvec2 q =
            hit ? glm::dvec2(to_box * glm::dvec4(eye_m + hit->distance * ray, 1.0)) : glm::dvec2(9.0);
        const double beyond = std::max(std::abs(q.x), std::abs(q.y));
        if (beyond > 1.1) {
          EXPECT_EQ(pair.with[4 * i + 1], pair.without[4 * i + 1]) << column << ", " << row;
        } else {
          const double expected = beyond > 1.0 ? 0.0 : highlights::shape_opacity(texture, q, 0.25, 0.05);
          difference += std::abs(shares[i] - expected);
          within += 1.0;
          opaque += expected;
        }
      }
    }
    EXPECT_GT(within, 1000.0);
    EXPECT_GT(opaque, 0.03 * within);
    RecordProperty(std::string(highlights::name_of(texture)) + "_1e5",
                   static_cast<int>(1e5 * difference / within));
    EXPECT_LT(difference / within, 2e-3) << highlights::name_of(texture);
  }
}

// Fails if pictures are turned, mirrored or upside down, or their opacity is not: the corners of one are red,
// green, blue and clear, from the upper left one on (texture_place() in
// host/highlights/projectors/projector.h). Light is that of the corner over the mesh, half precision; gate 1
// %.
TEST_F(HighlightPassTest, ShowsImagesUpright) {
  auto picture = std::make_shared<RgbaImage>(RgbaImage{.width = 8, .height = 8, .rgba = {}});
  constexpr std::array<std::array<std::uint8_t, 4>, 4> corners{
      {{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}, {9, 9, 9, 0}}};
  for (int row = 0; row < 8; ++row) {
    for (int column = 0; column < 8; ++column) {
      const auto& texel = corners[static_cast<std::size_t>(2 * (row / 4) + column / 4)];
      picture->rgba.insert(picture->rgba.end(), texel.begin(), texel.end());
    }
  }
  world::MeshParameters mesh =
      shining(mesh_shapes::make_ellipsoid({1.0, 0.8, 0.9}, 4), HighlightTexture::image, 0.3);
  mesh.rules[0].controls.picture = 0;
  mesh.rules[0].controls.scale = 2.0;
  world::WorldParameters parameters = world_of(mesh);
  parameters.pictures = {picture};
  open(parameters);
  const Pair pair = pictures();
  light();
  const highlights::Projector projector = world_->meshes()[0].highlights().at(0).projector;
  const highlights::FaceTree tree(world_->meshes()[0].surface().mesh());
  const sky::Illuminance& sky = world_->illuminance();
  const double sun_klx = sky::luminance(sky.sun_klx);
  const double gain = (sun_klx + sky::luminance(sky.sky_klx)) / sun_klx / std::numbers::pi;
  for (std::size_t corner = 0; corner < 4; ++corner) {
    const double right = corner % 2 == 0 ? -0.25 : 0.25, up = corner < 2 ? 0.25 : -0.25;
    const glm::dvec3 above_m = projector.centre_m + right * projector.width_m * projector.right +
                               up * projector.height_m * projector.up + projector.normal;
    const auto hit = tree.first_hit(above_m, -projector.normal, 2.0);
    ASSERT_TRUE(hit);
    const glm::ivec2 pixel(pixel_of(place_m + above_m - hit->distance * projector.normal));
    const auto i = 4 * static_cast<std::size_t>(pixel.y * width + pixel.x);
    for (std::size_t c = 0; c < 3; ++c) {
      const double expected = corner == 3   ? static_cast<double>(pair.without[i + c])
                              : c == corner ? sky.sun_klx[c] * gain
                                            : 0.0;
      EXPECT_NEAR(pair.with[i + c], expected, 0.01 * std::max(expected, 1.0)) << corner << ", " << c;
    }
  }
}

// Fails if a highlight is shown that the mesh keeps from its light, or one that nothing hides is not: a small
// sphere between a large one and the sun.
TEST_F(HighlightPassTest, HidesHighlightsInTheMeshsOwnShadow) {
  world::WorldParameters parameters =
      world_of(shining(mesh_shapes::make_sphere(1.0, 4), HighlightTexture::dot, 0.3));
  open(parameters);
  light();
  ASSERT_EQ(world_->meshes()[0].highlights().size(), 1u);
  EXPECT_NEAR(world_->meshes()[0].highlights()[0].opacity, 1.0, 1e-6);
  const glm::dvec3 middle_m = world_->meshes()[0].highlights()[0].projector.centre_m;
  // The other one is 3 m nearer to the sun.
  mesh_shapes::Shape large = mesh_shapes::make_sphere(1.0, 4), small = mesh_shapes::make_sphere(0.5, 3);
  const auto first = static_cast<std::uint32_t>(large.mesh.positions_m.size());
  const double shift_m = 3.0;
  for (std::size_t i = 0; i < small.mesh.positions_m.size(); ++i) {
    large.mesh.positions_m.push_back(small.mesh.positions_m[i] + middle_m + shift_m * toward_sun());
    large.mesh.normals.push_back(small.mesh.normals[i]);
  }
  for (TriangleIndices face : small.mesh.faces) {
    for (std::uint32_t& corner : face) corner += first;
    large.mesh.faces.push_back(face);
  }
  large.truth.reset();
  parameters.meshes = {shining(large, HighlightTexture::dot, 0.3)};
  open(parameters);
  light();
  std::size_t seen = 0;
  for (const highlights::DrawnHighlight& highlight : world_->meshes()[0].highlights()) {
    if (highlight.opacity == 0.0) continue;
    EXPECT_GT(glm::distance(highlight.projector.centre_m, middle_m), 1.0) << "on the large one";
    EXPECT_GT(highlight.opacity, 0.9);
    ++seen;
  }
  EXPECT_EQ(seen, 1u) << "on the small one";
}

// Fails if a picture of a turning mesh depends on the pictures before it.
TEST_F(HighlightPassTest, DependsOnTheTimeAlone) {
  world::MeshParameters mesh =
      shining(mesh_shapes::make_torus_knot({}, {.u_cells = 60, .v_cells = 8}), HighlightTexture::star, 0.2);
  mesh.motion = [](double time_s) {
    const double c = std::cos(time_s), s = std::sin(time_s);
    return highlights::RigidMotion{.rotation = glm::dmat3(c, 0.0, -s, 0.0, 1.0, 0.0, s, 0.0, c),
                                   .translation_m = place_m};
  };
  open(mesh);
  const std::vector<float> first = light(1.5);
  EXPECT_NE(light(2.0), first);
  light(0.3);
  EXPECT_EQ(light(1.5), first);
  open(mesh);
  EXPECT_EQ(light(1.5), first);
}

// Fails if highlights stay behind where an eye moves while time stands: after a second of pictures they are
// where a fresh start finds them. They close in on their places by a share of what is left; 1 % of the mesh's
// diagonal may be left.
TEST_F(HighlightPassTest, FollowsAnEyeWhileTimeStands) {
  open(shining(mesh_shapes::make_sphere(1.0, 3), HighlightTexture::dot, 0.3));
  FrameRequest asked = request();
  asked.lighting_at = {};
  light(asked);
  const auto middle_m = [&] { return world_->meshes()[0].highlights().at(0).projector.centre_m; };
  const glm::dvec3 before_m = middle_m();
  asked.camera.eye_m += glm::dvec3(1.5, 0.0, -0.5);
  for (int frame = 0; frame < 30; ++frame) light(asked);
  const glm::dvec3 after_m = middle_m();
  world_->at(100.0, 3.0);
  world_->see_meshes(asked.camera.eye_m);
  EXPECT_GT(glm::distance(before_m, middle_m()), 0.1);
  EXPECT_LT(glm::distance(after_m, middle_m()), 0.035);
}

// Fails if a debug view is the plain picture, or one that was asked for once stays.
TEST_F(HighlightPassTest, ShowsDebugViews) {
  open(shining(mesh_shapes::make_ellipsoid({1.0, 0.8, 0.9}, 3), HighlightTexture::dot, 0.3));
  const std::vector<float> plain = light();
  std::vector<std::vector<float>> shown{plain};
  for (const MeshShow show : all_mesh_shows) {
    if (show == MeshShow::light) continue;
    FrameRequest asked = request();
    asked.meshes = show;
    const std::vector<float> pixels = light(asked);
    EXPECT_EQ(std::count(shown.begin(), shown.end(), pixels), 0) << to_string(show);
    shown.push_back(pixels);
  }
  EXPECT_EQ(light(), plain);
}

// Fails if a driver of another version draws another picture: without clip control depths are rounded
// otherwise, which samples at rims may show. Mean difference below 1e-3 of the mean light.
TEST_F(HighlightPassTest, IsTheSameByEveryVersionOfOpenGl) {
  const world::MeshParameters mesh =
      shining(mesh_shapes::make_torus_knot({}, {.u_cells = 60, .v_cells = 8}), HighlightTexture::ring, 0.1);
  open(mesh);
  const std::vector<float> expected = light();
  for (const char* version : {"4.1", "3.3"}) {
    frame_.reset();
    setenv("MESA_GL_VERSION_OVERRIDE", version, 1);
    context_.reset();
    context_.emplace(GlContext::headless());
    unsetenv("MESA_GL_VERSION_OVERRIDE");
    open(mesh);
    const std::vector<float> found = light();
    double difference = 0.0, mean = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      difference += std::abs(found[i] - expected[i]);
      mean += expected[i];
    }
    EXPECT_LT(difference, 1e-3 * mean) << version << ": " << context_->capabilities().version;
  }
}

// A sheet with a front and a back and without normals, and one whose normals turn over within a face: fails
// if a pixel is no number, which would spread over all that is made of the picture.
TEST_F(HighlightPassTest, NormalsThatCancelGiveNumbers) {
  mesh_shapes::Shape sheet;
  sheet.mesh.positions_m = {{-1.0, -1.0, 0.0}, {1.0, -1.0, 0.0}, {1.0, 1.0, 0.0}, {-1.0, 1.0, 0.0}};
  sheet.mesh.faces = {{0, 1, 2}, {0, 2, 1}, {0, 2, 3}, {0, 3, 2}};
  mesh_shapes::Shape turned = sheet;
  turned.mesh.normals = {{0.0, 0.0, 1.0}, {0.0, 0.0, -1.0}, {0.0, 0.0, -1.0}, {0.0, 0.0, 1.0}};
  for (const mesh_shapes::Shape& shape : {sheet, turned}) {
    for (const world::BaseShading shading : {world::BaseShading::phong, world::BaseShading::gouraud,
                                             world::BaseShading::cartoon, world::BaseShading::flat}) {
      world::MeshParameters mesh = mesh_of(shape);
      mesh.material.shading = shading;
      mesh.has_highlights = true;
      open(mesh);
      const std::vector<float> picture = light();
      EXPECT_TRUE(std::all_of(picture.begin(), picture.end(), [](float value) {
        return std::isfinite(value);
      })) << static_cast<int>(shading);
    }
  }
}

}  // namespace
}  // namespace offing::present
