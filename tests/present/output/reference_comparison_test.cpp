// offing-view --compare-reference as its users run it; it needs no OpenGL.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
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

// Fails if another program cannot set up the same picture: camera, sun, sky and ground as the paths have
// them.
TEST_F(ReferenceComparisonTest, PrintsWhatLightsTheClouds) {
  const ProgramResult result = compare(scene("[[cloud]]\ny_m = 1000\nscale = 0.3\n"), {"--json", "--quiet"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const auto json = nlohmann::json::parse(result.output);
  const auto near = [](const nlohmann::json& values, double x, double y, double z) {
    EXPECT_NEAR(values.at(0).get<double>(), x, 1e-6);
    EXPECT_NEAR(values.at(1).get<double>(), y, 1e-6);
    EXPECT_NEAR(values.at(2).get<double>(), z, 1e-6);
  };
  const double up = 5.0 * std::numbers::pi / 180.0, elevation = 40.0 * std::numbers::pi / 180.0,
               azimuth = 130.0 * std::numbers::pi / 180.0;
  near(json["camera"]["eye_m"], 0.0, 900.0, 1200.0);
  near(json["camera"]["forward"], 0.0, std::sin(up), -std::cos(up));
  near(json["camera"]["up"], 0.0, std::cos(up), std::sin(up));
  ASSERT_EQ(json["lights"].size(), 1);
  near(json["lights"][0]["direction"], std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
       -std::cos(azimuth) * std::cos(elevation));
  // A high sun gives 60 to 130 klx, a clear sky 1 to 10 kcd/m2, the ground less than the sun would from
  // white.
  const double sun_klx = json["lights"][0]["illuminance_klx"][1], ground = json["ground_kcdpm2"][1];
  EXPECT_GT(sun_klx, 60.0);
  EXPECT_LT(sun_klx, 130.0);
  EXPECT_GT(json["sky_kcdpm2"][1], 1.0);
  EXPECT_LT(json["sky_kcdpm2"][1], 10.0);
  EXPECT_GT(ground, 0.0);
  EXPECT_LT(ground, sun_klx / std::numbers::pi);
  EXPECT_GT(json["cell_m"], 1.0);
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

// Fails if what cannot be compared is not said to be so, or leaves a folder.
TEST_F(ReferenceComparisonTest, RefusesWhatCannotBeCompared) {
  const ProgramResult empty = compare(scene(""));
  EXPECT_EQ(empty.exit_code, 2);
  EXPECT_THAT(empty.errors, HasSubstr("expected a scene with clouds"));
  EXPECT_FALSE(std::filesystem::exists(path("compared")));
  const ProgramResult mixed = compare(scene("[[cloud]]\n[[cloud]]\ng = 0.5\n"));
  EXPECT_EQ(mixed.exit_code, 2);
  EXPECT_THAT(mixed.errors, HasSubstr("one phase function"));
  EXPECT_FALSE(std::filesystem::exists(path("compared")));
  EXPECT_THAT(run_offing({scene("[[cloud]]\n"), "--compare-reference"}).errors,
              HasSubstr("expected a folder"));
  EXPECT_THAT(run_offing({scene("[[cloud]]\n"), "--samples", "4", "-o", path("a.png")}).errors,
              HasSubstr("expected --compare-reference"));
}

/// A cloud of a genus, where the sun stands, and how far a picture may be from the paths: its mean light, and
/// the root of the mean square error of blocks over their mean.
struct PictureCase {
  const char* genus;
  double azimuth_deg, elevation_deg, mean_limit, rms_limit;
  int samples = 128;
  bool is_fitted = true;  ///< a sun that the light of clouds was fitted to
};

constexpr std::size_t picture_width = 320, picture_height = 180;

/// A picture of luminances.
struct Picture {
  std::size_t width = 0, height = 0;
  std::vector<double> values;  ///< [height][width], row 0 at the top

  double at(std::size_t column, std::size_t row) const { return values[row * width + column]; }
};

/// The means of blocks of so many pixels on a side.
Picture means_of_blocks(const Picture& picture, std::size_t side) {
  Picture means{.width = picture.width / side, .height = picture.height / side, .values = {}};
  for (std::size_t row = 0; row < means.height; ++row) {
    for (std::size_t column = 0; column < means.width; ++column) {
      double sum = 0.0;
      for (std::size_t i = 0; i < side * side; ++i)
        sum += picture.at(column * side + i % side, row * side + i / side);
      means.values.push_back(sum / static_cast<double>(side * side));
    }
  }
  return means;
}

/// What the means of blocks of this many pixels on a side are off those of blocks twice as large, in the
/// blocks twice as large again of which the cloud covers more than this share: light at one to two times that
/// scale.
std::vector<double> band_of(const Picture& light, const Picture& cover, double least_cover,
                            std::size_t side) {
  const Picture fine = means_of_blocks(light, side), coarse = means_of_blocks(light, 2 * side),
                covers = means_of_blocks(cover, 4 * side);
  std::vector<double> band;
  for (std::size_t row = 0; row < 4 * covers.height; ++row) {
    for (std::size_t column = 0; column < 4 * covers.width; ++column) {
      if (covers.at(column / 4, row / 4) > least_cover)
        band.push_back(fine.at(column, row) - coarse.at(column / 2, row / 2));
    }
  }
  return band;
}

/// The mean product: of two pictures with independent noise, what both show.
double mean_product(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0) / static_cast<double>(a.size());
}

/// Light of some of the pixels.
struct Part {
  double ours = 0.0, right = 0.0;

  void add(double ours_there, double right_there) {
    ours += ours_there;
    right += right_there;
  }
};

/// A stratus fills no blocks.
bool genus_is_thin(const PictureCase& of) {
  return of.genus == std::string("stratus");
}

constexpr double parts_limit = 0.15, contrast_limit = 0.25;

class CloudPictureTest : public ReferenceComparisonTest, public testing::WithParamInterface<PictureCase> {};

/// Seen whole.
std::string scene_of(const PictureCase& of) {
  const std::string sun = fmt::format("version = 1\n[sun]\nazimuth_deg = {}\nelevation_deg = {}\n[ocean]\n",
                                      of.azimuth_deg, of.elevation_deg);
  const std::string genus = of.genus;
  const char* from = genus == "cumulus"   ? "y_m = 250\nz_m = 2350\npitch_deg = 17\n"
                     : genus == "stratus" ? "y_m = 100\nz_m = 4000\npitch_deg = 4\n"
                                          : "y_m = 2000\nz_m = 26000\npitch_deg = 8\n";
  return sun + "[camera]\nfov_deg = 45\n" + from + "[[cloud]]\ngenus = \"" + genus + "\"\n" +
         (genus == "cumulus" ? "y_m = 650\n" : "");
}

Picture luminance_of(const ExrContent& light, const std::string& layer) {
  Picture picture{.width = picture_width, .height = picture_height, .values = {}};
  const auto red = light.channel(layer + ".R"), green = light.channel(layer + ".G"),
             blue = light.channel(layer + ".B");
  for (std::size_t texel = 0; texel < picture_width * picture_height; ++texel)
    picture.values.push_back(0.2126 * red[texel] + 0.7152 * green[texel] + 0.0722 * blue[texel]);
  return picture;
}

// Means of 2 x 2 pixels are judged, and blocks of 8 x 8 of them of which 2 % show cloud. Limits: mean 7 %,
// rms 0.11 from the side and the front, 0.14 from behind; at suns that nothing was fitted to 10 % and 0.16.
// The rest of a cloud is within 15 %: its underside, the lowest fifth of the pixels of a column that it
// fills; its lit side, the brightest quarter of the blocks that it fills; and its rim, pixels of which it
// covers 5 to 90 %. Noise of the paths adds 0.01 or less, 0.03 to the cumulonimbus. Contrast at 2 to 4 and at
// 4 to 8 pixels, where the cloud fills them (a stratus 70 % of them), is within 25 %; halves of the paths
// have independent noise, so that their mean product has none. Fails if light does not reach the right parts
// of a cloud.
TEST_P(CloudPictureTest, ShowsTheLightOfPaths) {
  constexpr std::size_t width = picture_width / 2, height = picture_height / 2, block = 8;
  const PictureCase& of = GetParam();
  std::ofstream(path("scene.toml")) << scene_of(of);
  const ProgramResult result =
      run_offing({path("scene.toml"), "--compare-reference", "-o", path("compared"), "--size", "320x180",
                  "--samples", std::to_string(of.samples), "--quiet"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const ExrContent light = read_exr(path("compared/compared.exr"));
  const Picture drawn_light = luminance_of(light, "drawn");
  const auto opacities = light.channel("reference.A");
  const Picture opacity{picture_width, picture_height, {opacities.begin(), opacities.end()}};
  const Picture ours_there = means_of_blocks(drawn_light, 2), cover_there = means_of_blocks(opacity, 2),
                right_there = means_of_blocks(luminance_of(light, "reference"), 2);
  const auto ours_at = [&](std::size_t texel) { return ours_there.values[texel]; };
  const auto right_at = [&](std::size_t texel) { return right_there.values[texel]; };
  const auto cover_at = [&](std::size_t texel) { return cover_there.values[texel]; };
  double drawn = 0.0, reference = 0.0, squares = 0.0, blocks = 0.0;
  std::vector<std::pair<double, double>> full;  // reference and ours, of blocks
  for (std::size_t row = 0; row + block <= height; row += block) {
    for (std::size_t column = 0; column < width; column += block) {
      double ours = 0.0, right = 0.0, covered = 0.0;
      for (std::size_t i = 0; i < block * block; ++i) {
        const std::size_t texel = (row + i / block) * width + column + i % block;
        ours += ours_at(texel);
        right += right_at(texel);
        covered += cover_at(texel);
      }
      if (covered < 0.02 * block * block) continue;
      if (covered > 0.97 * block * block) full.emplace_back(right, ours);
      drawn += ours;
      reference += right;
      squares += (ours - right) * (ours - right);
      blocks += 1.0;
    }
  }
  ASSERT_GT(blocks, 20.0);
  const double rms = std::sqrt(squares / blocks) / (reference / blocks);
  EXPECT_NEAR(drawn / reference, 1.0, of.mean_limit);
  EXPECT_LT(rms, of.rms_limit);
  Part underside, lit, rim;
  for (std::size_t column = 0; column < width; ++column) {
    std::vector<std::size_t> filled;  // from the top
    for (std::size_t row = 0; row < height; ++row) {
      const std::size_t texel = row * width + column;
      if (cover_at(texel) > 0.97) filled.push_back(texel);
      if (cover_at(texel) > 0.05 && cover_at(texel) < 0.9) rim.add(ours_at(texel), right_at(texel));
    }
    if (filled.size() < 10) continue;
    for (std::size_t i = filled.size() - filled.size() / 5; i < filled.size(); ++i)
      underside.add(ours_at(filled[i]), right_at(filled[i]));
  }
  std::sort(full.rbegin(), full.rend());
  for (std::size_t i = 0; i < full.size() / 4; ++i) lit.add(full[i].second, full[i].first);
  for (const auto& [name, part] : {std::pair("underside", underside), {"lit", lit}, {"rim", rim}}) {
    if (part.right == 0.0) {
      EXPECT_TRUE(name != std::string("rim") && genus_is_thin(of)) << name << ": none";
      continue;
    }
    EXPECT_NEAR(part.ours / part.right, 1.0, parts_limit) << name;
    RecordProperty(name, std::to_string(part.ours / part.right));
  }
  RecordProperty("mean", std::to_string(drawn / reference));
  RecordProperty("rms", std::to_string(rms));
  const double least_cover = genus_is_thin(of) ? 0.7 : 0.97;
  const Picture half = luminance_of(light, "half1"), other = luminance_of(light, "half2");
  for (const std::size_t side : {2u, 4u}) {
    const std::vector<double> ours = band_of(drawn_light, opacity, least_cover, side);
    const double right =
        mean_product(band_of(half, opacity, least_cover, side), band_of(other, opacity, least_cover, side));
    ASSERT_GT(ours.size(), 100u);
    ASSERT_GT(right, 0.0);
    const double ratio = std::sqrt(mean_product(ours, ours) / right) * reference / drawn;
    const std::string name = "contrast" + std::to_string(side);
    if (of.is_fitted) {
      EXPECT_NEAR(ratio, 1.0, contrast_limit) << name;
    }
    RecordProperty(name, std::to_string(ratio));
  }
}

INSTANTIATE_TEST_SUITE_P(Suns, CloudPictureTest,
                         testing::Values(PictureCase{"cumulus", 75, 35, 0.07, 0.11},
                                         PictureCase{"cumulus", 170, 35, 0.07, 0.11},
                                         PictureCase{"cumulus", 10, 15, 0.07, 0.14},
                                         PictureCase{"cumulus", 40, 60, 0.1, 0.16, 128, false},
                                         PictureCase{"cumulus", 110, 10, 0.1, 0.16, 128, false},
                                         PictureCase{"cumulus", 150, 60, 0.1, 0.16, 128, false},
                                         PictureCase{"stratus", 75, 35, 0.07, 0.11, 256},
                                         PictureCase{"stratus", 170, 35, 0.07, 0.11, 256},
                                         PictureCase{"stratus", 10, 15, 0.07, 0.14, 256},
                                         PictureCase{"cumulonimbus", 75, 35, 0.07, 0.11, 512},
                                         PictureCase{"cumulonimbus", 170, 35, 0.07, 0.11, 256},
                                         PictureCase{"cumulonimbus", 10, 15, 0.07, 0.14, 256}),
                         [](const auto& of) {
                           return fmt::format("{}_{}_{}", of.param.genus, of.param.azimuth_deg,
                                              of.param.elevation_deg);
                         });

class ShippedCloudsTest : public ReferenceComparisonTest, public testing::WithParamInterface<const char*> {};

// The clouds of shipped scenes, as their cameras see them: mean light within 12 % of that of paths. Noise of
// 64 paths a pixel is 1 % of the mean. Fails if clouds do not light each other: layers are then up to 17 %
// too dark.
TEST_P(ShippedCloudsTest, HaveTheLightOfPaths) {
  const std::string scene = std::string(OFFING_SCENES "/") + GetParam() + ".toml";
  const ProgramResult result = run_offing({scene, "--compare-reference", "-o", path("compared"), "--size",
                                           "160x90", "--samples", "64", "--quiet", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const auto json = nlohmann::json::parse(result.output);
  const double mean = json["drawn_kcdpm2"].get<double>() / json["reference_kcdpm2"].get<double>();
  EXPECT_NEAR(mean, 1.0, 0.12);
  RecordProperty("mean", std::to_string(mean));
}

INSTANTIATE_TEST_SUITE_P(Scenes, ShippedCloudsTest,
                         testing::Values("stratus", "cirrus", "shapes", "flight", "world", "sky", "dusk"),
                         [](const auto& of) { return std::string(of.param); });

}  // namespace
}  // namespace offing::test
