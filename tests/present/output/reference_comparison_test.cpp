// offing-view --compare-reference as its users run it; it needs no OpenGL.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
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

using testing::HasSubstr;

class ReferenceComparisonTest : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

  std::string scene(const std::string& clouds) const {
    std::ofstream(path("scene.toml")) << "version = 1\n[sun]\nelevation_deg = 40\nazimuth_deg = 130\n"
                                         "[camera]\ny_m = 900\nz_m = 1200\npitch_deg = 5\n"
                                      << clouds;
    return path("scene.toml");
  }
  ProgramResult compare(const std::string& scene, std::vector<std::string> more = {}) const {
    more.insert(more.begin(),
                {scene, "--compare-reference", "-o", path("compared"), "--size", "24x14", "--samples", "8"});
    return run_offing(more);
  }

  TemporaryFolder folder_;
};

// Fails if pictures or numbers are missing or not of each other: orders add up to the reference, and what is
// drawn is about as bright. 336 pixels of 8 paths have a mean to some 5 %; textures take and give light.
TEST_F(ReferenceComparisonTest, WritesBothAndWhatDiffers) {
  const ProgramResult result = compare(scene("[[cloud]]\ny_m = 1000\nscale = 0.6\n"), {"--json", "--quiet"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const auto json = nlohmann::json::parse(result.output);
  EXPECT_EQ(json["samples"], 8);
  EXPECT_GT(json["covered_share"], 0.1);
  EXPECT_NEAR(json["drawn_kcdpm2"].get<double>() / json["reference_kcdpm2"].get<double>(), 1.0, 0.35);
  double shares = 0.0;
  for (const auto& order : json["orders"]) shares += order["share"].get<double>();
  EXPECT_NEAR(shares, 1.0, 1e-4);
  for (const char* name : {"drawn.png", "reference.png", "error.png"}) {
    const RgbImage image = read_png(path("compared/" + std::string(name)));
    EXPECT_EQ(image.width, 24) << name;
    EXPECT_EQ(image.height, 14) << name;
  }
  const ExrContent light = read_exr(path("compared/compared.exr"));
  double sum = 0.0, reference = 0.0;
  for (std::size_t i = 0; i < 24 * 14; ++i) {
    reference += light.channel("reference.G")[i];
    for (const auto& order : json["orders"])
      sum += light.channel("order" + std::to_string(order["order"].get<int>()) + ".G")[i];
  }
  EXPECT_NEAR(sum, reference, 1e-3 * reference);
}

// Fails if pictures that are there are replaced unasked, or not at all.
TEST_F(ReferenceComparisonTest, KeepsWhatIsThere) {
  const std::string clouds = scene("[[cloud]]\ny_m = 1000\nscale = 0.3\n");
  std::filesystem::create_directory(path("compared"));
  std::ofstream(path("compared/error.png")) << "mine";
  const ProgramResult refused = compare(clouds);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, HasSubstr("error.png: expected a new file"));
  EXPECT_FALSE(std::filesystem::exists(path("compared/drawn.png")));
  std::ifstream file(path("compared/error.png"));
  EXPECT_EQ((std::string{std::istreambuf_iterator<char>(file), {}}), "mine");
  EXPECT_EQ(compare(clouds, {"--force"}).exit_code, 0);
  EXPECT_EQ(read_png(path("compared/error.png")).width, 24);
}

// Fails if a file that the scene reads is replaced, even where replacing is allowed.
TEST_F(ReferenceComparisonTest, KeepsWhatTheSceneReads) {
  std::filesystem::create_directory(path("compared"));
  std::ofstream(path("compared/drawn.png")) << "heights";
  const ProgramResult refused =
      compare(scene("[terrain]\nfile = \"compared/drawn.png\"\n[[cloud]]\ny_m = 1000\n"), {"--force"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, HasSubstr("drawn.png: expected an output file, found an input"));
  std::ifstream file(path("compared/drawn.png"));
  EXPECT_EQ((std::string{std::istreambuf_iterator<char>(file), {}}), "heights");
}

// Fails if what cannot be compared is not said to be so.
TEST_F(ReferenceComparisonTest, RefusesWhatCannotBeCompared) {
  const ProgramResult empty = compare(scene(""));
  EXPECT_EQ(empty.exit_code, 2);
  EXPECT_THAT(empty.errors, HasSubstr("expected a scene with clouds"));
  const ProgramResult mixed = compare(scene("[[cloud]]\n[[cloud]]\ng = 0.5\n"));
  EXPECT_EQ(mixed.exit_code, 2);
  EXPECT_THAT(mixed.errors, HasSubstr("one phase function"));
  EXPECT_THAT(run_offing({scene("[[cloud]]\n"), "--compare-reference"}).errors,
              HasSubstr("expected a folder"));
  EXPECT_THAT(run_offing({scene("[[cloud]]\n"), "--samples", "4", "-o", path("a.png")}).errors,
              HasSubstr("expected --compare-reference"));
}

}  // namespace
}  // namespace offing::test
