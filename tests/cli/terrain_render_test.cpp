#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/io/exr_image.h"
#include "host/io/png_image.h"
#include "tests/cli/offing_program.h"
#include "tests/io/temporary_folder.h"

namespace offing::test {
namespace {

/// A level map of 100 m, 21 x 21 posts, 50 m apart.
class TerrainRender : public ::testing::Test {
 protected:
  TerrainRender() {
    std::ofstream grid(path("grid.asc"));
    grid << "ncols 21\nnrows 21\nxllcenter 0\nyllcenter 0\ncellsize 50\n";
    for (int row = 0; row < 21; ++row) {
      for (int column = 0; column < 21; ++column) grid << "100 ";
      grid << "\n";
    }
  }
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  ProgramResult render(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"terrain", "render", path("grid.asc"), "-o", path("out.png")});
    return run_offing(arguments);
  }

  TemporaryFolder folder_;
};

// Fails if the camera does not stand where it is told, or the depth is not that of the ground below it: 40 m
// straight down in the middle, 40 / cos(30 degrees) at the middle of the upper edge, but for half a pixel.
TEST_F(TerrainRender, DrawsPictureAndDepth) {
  const ProgramResult result = render({"--camera", "500,140,500,0,-90", "--size", "65x65", "--relief", "0",
                                       "--depth", path("depth.exr"), "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const auto json = nlohmann::json::parse(result.output);
  EXPECT_EQ(json["ground_share"], 1.0);
  EXPECT_EQ(json["eye_m"], nlohmann::json({500.0, 140.0, 500.0}));
  const RgbImage image = read_png(path("out.png"));
  EXPECT_EQ(image.width, 65);
  EXPECT_EQ(image.height, 65);
  const std::vector<float> depth_m = read_exr(path("depth.exr")).channel("Z");
  EXPECT_NEAR(depth_m[65 * 32 + 32], 40.0, 1e-4);
  EXPECT_NEAR(depth_m[32], 40.0 / 0.8660, 0.4);
}

// A pit 20 m deep with 15 m of water, from straight above. Fails if the depth is that of the lake's bed, or
// if a lake's distances are written where no memory is: once they were, of any picture of 1024 pixels.
TEST_F(TerrainRender, DepthIsThatOfLakes) {
  std::ofstream grid(path("grid.asc"));
  grid << "ncols 21\nnrows 21\nxllcenter 0\nyllcenter 0\ncellsize 50\n";
  for (int row = 0; row < 21; ++row) {
    for (int column = 0; column < 21; ++column)
      grid << (std::max(std::abs(row - 10), std::abs(column - 10)) < 5 ? "80 " : "100 ");
    grid << "\n";
  }
  grid.close();
  const ProgramResult result = render({"--camera", "500,140,500,0,-90", "--size", "65x65", "--relief", "0",
                                       "--lake", "500,500,95", "--depth", path("depth.exr")});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_NEAR(read_exr(path("depth.exr")).channel("Z")[65 * 32 + 32], 45.0, 1e-3);
}

// Fails if an eye in the ground makes a picture of the ground's inside, without a word, or if one off the map
// does so.
TEST_F(TerrainRender, WarnsOfEyesInTheGroundAndOffTheMap) {
  const auto eye_of = [&](const std::string& camera, const char* warning) {
    const ProgramResult result = render({"--camera", camera, "--size", "32x32", "--force", "--json"});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    if (*warning == '\0') {
      EXPECT_EQ(result.errors, "") << camera;
    } else {
      EXPECT_THAT(result.errors, ::testing::HasSubstr(warning)) << camera;
    }
    const auto json = nlohmann::json::parse(result.output);
    // Relief around an eye that is 10 cm above the map hides more than half: 0.84 there, 1 from inside.
    EXPECT_LT(json["ground_share"].get<double>(), 0.9) << camera;
    return json["eye_m"][1].get<double>();
  };
  EXPECT_NEAR(eye_of("500,60,500,0,0", "is 40.0 m below the ground; raised to y = 101.7 m, 1.7 m above it"),
              101.7, 1e-9);
  EXPECT_NEAR(eye_of("500,100,500,0,0", "is 0.0 m below the ground; raised"), 101.7, 1e-9);
  EXPECT_NEAR(eye_of("-300,60,1400,0,0", "is 500.0 m beyond the map, which reaches from x = 0.0 to 1000.0 m"),
              60.0, 1e-9);
  EXPECT_NEAR(eye_of("500,100.1,500,0,0", ""), 100.1, 1e-9);
}

// Over 12 degrees of a sky each of 8 bits' steps is many pixels wide: neighbours differ at their edges alone,
// unless noise smaller than a step hides these. Measured: 3 % of the neighbours without, 49 % with, none by
// more than a step.
TEST_F(TerrainRender, SkiesHaveNoBands) {
  ASSERT_EQ(render({"--camera", "500,140,500,20,12", "--fov-deg", "12", "--size", "64x64", "--sun", "225,8"})
                .exit_code,
            0);
  const RgbImage image = read_png(path("out.png"));
  int different = 0, pairs = 0;
  for (std::size_t pixel = 0; pixel + 1 < 64 * 64; ++pixel) {
    if (pixel % 64 == 63) continue;
    const int step = std::abs(image.rgb[3 * pixel + 2] - image.rgb[3 * (pixel + 1) + 2]);
    EXPECT_LE(step, 1) << pixel;
    different += step;
    ++pairs;
  }
  std::printf("%d of %d neighbours differ\n", different, pairs);
  EXPECT_GT(different, pairs / 4);
}

// Fails if the ground between posts is level all the same, or higher than twice the usual relief of turf.
TEST_F(TerrainRender, DrawsReliefBetweenPosts) {
  ASSERT_EQ(
      render({"--camera", "500,140,500,0,-90", "--size", "65x65", "--depth", path("depth.exr")}).exit_code,
      0);
  const std::vector<float> depth_m = read_exr(path("depth.exr")).channel("Z");
  const auto [nearest, farthest] =
      std::minmax_element(depth_m.begin() + 65 * 32 + 28, depth_m.begin() + 65 * 32 + 37);
  EXPECT_GT(*farthest - *nearest, 0.05f);
  EXPECT_NEAR(depth_m[65 * 32 + 32], 40.0, 6.0);
}

// Fails if the flag does not come to the picture: patterns near the eye.
TEST_F(TerrainRender, LeavesOutFineDetail) {
  const auto deviation = [&](const char* finest_m) {
    EXPECT_EQ(render({"--camera", "500,102,500,0,-60", "--size", "64x64", "--relief", "0", "--force",
                      "--finest-detail-m", finest_m})
                  .exit_code,
              0);
    const RgbImage image = read_png(path("out.png"));
    double sum = 0.0, squares = 0.0;
    for (const auto value : image.rgb) sum += value, squares += 1.0 * value * value;
    const auto count = static_cast<double>(image.rgb.size());
    return squares / count - sum * sum / count / count;
  };
  EXPECT_LT(deviation("120"), 0.9 * deviation("0"));
}

// Above the horizon of "walk" there is sky, below it the level ground: half the picture each, but for the row
// at the horizon. Fails if relief hides more, or the eye stands on the map's surface in spite of it.
TEST_F(TerrainRender, WalksOnTheGround) {
  const ProgramResult rough = render({"--camera", "walk", "--size", "64x64", "--json"});
  ASSERT_EQ(rough.exit_code, 0) << rough.errors;
  const auto of_relief = nlohmann::json::parse(rough.output);
  EXPECT_NEAR(of_relief["eye_m"][1].get<double>(), 101.7, 6.0);
  EXPECT_GT(std::abs(of_relief["eye_m"][1].get<double>() - 101.7), 1e-3);
  EXPECT_NEAR(of_relief["ground_share"].get<double>(), 0.5, 0.15);
  const ProgramResult result =
      render({"--camera", "walk", "--size", "64x64", "--relief", "0", "--force", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const auto json = nlohmann::json::parse(result.output);
  EXPECT_NEAR(json["eye_m"][1].get<double>(), 101.7, 1e-9);
  EXPECT_NEAR(json["ground_share"].get<double>(), 0.5, 0.02);
}

// A picture of steps needs no light: it differs from that of the light, and the sky of it is blue throughout.
TEST_F(TerrainRender, ShowsSteps) {
  ASSERT_EQ(render({"--camera", "walk", "--size", "32x32", "--show", "steps"}).exit_code, 0);
  const RgbImage image = read_png(path("out.png"));
  EXPECT_GT(image.rgb[2], 100);
  EXPECT_LT(image.rgb[0], 60);
}

// A picture of one colour, stretched over the map: the ground is red, and greener without it. Fails if the
// flag is read and dropped.
TEST_F(TerrainRender, ColoursTheTerrain) {
  const RgbImage red{2, 2, {200, 10, 10, 200, 10, 10, 200, 10, 10, 200, 10, 10}};
  write_png(path("red.png"), red);
  const std::vector<std::string> view{"--camera", "500,140,500,0,-90", "--size", "9x9", "--force"};
  std::vector<std::string> coloured = view;
  coloured.insert(coloured.end(), {"--colour", path("red.png")});
  ASSERT_EQ(render(coloured).exit_code, 0);
  const RgbImage with = read_png(path("out.png"));
  EXPECT_GT(with.rgb[0], 2 * with.rgb[1]);
  ASSERT_EQ(render(view).exit_code, 0);
  const RgbImage without = read_png(path("out.png"));
  EXPECT_LT(without.rgb[0], 2 * without.rgb[1]);
}

// Automatic samples are for the horizon, where ground and sky meet. Fails if --samples does nothing.
TEST_F(TerrainRender, CastsManyRaysAPixel) {
  const auto refined_share = [&](const std::string& samples) {
    const ProgramResult result =
        render({"--camera", "walk", "--size", "8x65", "--samples", samples, "--force", "--json"});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return nlohmann::json::parse(result.output)["refined_share"].get<double>();
  };
  EXPECT_EQ(refined_share("1"), 0.0);
  EXPECT_EQ(refined_share("4"), 1.0);
  EXPECT_GT(refined_share("auto"), 0.0);
  EXPECT_LT(refined_share("auto"), 0.5);
}

TEST_F(TerrainRender, RefusesWithAHint) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"--camera", "stand"},
                                                    {"--camera", "1,2,3,4"},
                                                    {"--camera", "1,2,3,4,99"},
                                                    {"--size", "640"},
                                                    {"--size", "0x10"},
                                                    {"--fov-deg", "180"},
                                                    {"--sun", "10"},
                                                    {"--sun", "10,100"},
                                                    {"--show", "light,steps"},
                                                    {"--snow-line-m", "high"},
                                                    {"--relief", "-1"},
                                                    {"--relief", "high"},
                                                    {"--samples", "0"},
                                                    {"--samples", "many"},
                                                    {"--sky-visibility", "some"},
                                                    {"--colour", "none.png"},
                                                    {"--exposure-ev", "nan"}}) {
    const ProgramResult result = render(arguments);
    EXPECT_EQ(result.exit_code, 2) << arguments.back();
    EXPECT_THAT(result.errors, ::testing::MatchesRegex("error: [^\n]+\nhint: [^\n]+\n")) << arguments.back();
    EXPECT_FALSE(std::filesystem::exists(path("out.png"))) << arguments.back();
  }
}

// Fails if somebody's picture is replaced unasked.
TEST_F(TerrainRender, KeepsFilesThatAreThere) {
  std::ofstream(path("out.png")) << "mine";
  EXPECT_EQ(render({"--size", "16x16"}).exit_code, 2);
  EXPECT_EQ(std::filesystem::file_size(path("out.png")), 4u);
  EXPECT_EQ(render({"--size", "16x16", "--force"}).exit_code, 0);
  EXPECT_NE(std::filesystem::file_size(path("out.png")), 4u);
}

// Fails if a file is another than its name says, or a picture is drawn before it is known where to write it.
TEST_F(TerrainRender, ChecksOutputsBeforeWork) {
  const auto refused = [&](const std::string& output, const std::string& depth, int exit_code) {
    const ProgramResult result = run_offing(
        {"terrain", "render", path("no_map.asc"), "-o", path(output), "--depth", path(depth), "--force"});
    EXPECT_EQ(result.exit_code, exit_code);
    EXPECT_THAT(result.errors, ::testing::MatchesRegex("error: [^\n]+\nhint: [^\n]+\n"));
    return result.errors;
  };
  EXPECT_THAT(refused("a.jpg", "a.exr", 2), ::testing::HasSubstr("name it a.png"));
  EXPECT_THAT(refused("a.png", "d.png", 2), ::testing::HasSubstr("name it d.exr"));
  EXPECT_THAT(refused("none/a.png", "a.exr", 1), ::testing::HasSubstr("none"));
  EXPECT_THAT(refused("a.png", "a.exr", 2), ::testing::HasSubstr("no_map.asc"));
}

}  // namespace
}  // namespace offing::test
