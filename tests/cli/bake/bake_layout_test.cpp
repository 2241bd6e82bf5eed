// Layouts, axes and the description of a bake, as programs that load its files see them.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/io/exr_image.h"
#include "tests/cli/folder_content.h"
#include "tests/cli/offing_program.h"

namespace offing::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::UnorderedElementsAre;
using Maps = std::vector<std::pair<std::string, std::vector<float>>>;

constexpr int columns_of_map = 32;
constexpr const char* all_channels = "displacement,slope,gradient,jacobian,foam,velocity,normal";

class BakeLayout : public testing::Test {
 protected:
  std::filesystem::path folder(const std::string& name) const { return root_.path() / name; }

  ProgramResult try_bake(const std::string& name, const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = {"ocean",
                                          "bake",
                                          "--size",
                                          "32",
                                          "--patch-m",
                                          "200,23",
                                          "--fps",
                                          "8",
                                          "--foam-onset",
                                          "0.9",
                                          "--gerstner-count",
                                          "4",
                                          "--gerstner-split-m",
                                          "45",
                                          "-o",
                                          folder(name).string(),
                                          "--frames",
                                          "3:3"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_offing(arguments);
  }
  ProgramResult bake(const std::string& name, const std::vector<std::string>& more) const {
    ProgramResult result = try_bake(name, more);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return result;
  }

  ExrContent image(const std::string& name, const std::string& file) const {
    return read_exr(folder(name) / (file + ".0003.exr"));
  }
  json description(const std::string& name) const {
    return json::parse(file_content(folder(name) / "ocean.json"), nullptr, false);
  }

  std::set<std::string> names(const std::string& name) const {
    std::set<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(folder(name))) {
      found.insert(entry.path().filename().string());
    }
    return found;
  }

 private:
  TemporaryFolder root_;
};

std::vector<float> minus(std::vector<float> values) {
  for (float& value : values) value = -value;
  return values;
}

// Fails if a plain file has other channels than R, G, B or Y, or other values than the channels of the file a
// cascade, bit by bit, or if --layout combined is not --combined.
TEST_F(BakeLayout, PlainFilesHoldTheSameValues) {
  bake("channels", {"--channels", all_channels});
  bake("rgb", {"--layout", "rgb", "--velocity"});
  const std::set<std::string> files = {"ocean.json",
                                       "ocean.c0_displacement.0003.exr",
                                       "ocean.c0_foam.0003.exr",
                                       "ocean.c0_normal.0003.exr",
                                       "ocean.c0_velocity.0003.exr",
                                       "ocean.c1_displacement.0003.exr",
                                       "ocean.c1_foam.0003.exr",
                                       "ocean.c1_normal.0003.exr",
                                       "ocean.c1_velocity.0003.exr"};
  EXPECT_EQ(names("rgb"), files);
  for (const std::string cascade : {"ocean.c0", "ocean.c1"}) {
    const ExrContent all = image("channels", cascade);
    const ExrContent foam = image("rgb", cascade + "_foam");
    ASSERT_EQ(foam.channels.size(), 1u);
    EXPECT_EQ(foam.channel("Y"), all.channel("foam"));
    for (const std::string map : {"displacement", "normal", "velocity"}) {
      const ExrContent plain = image("rgb", cascade + "_" + map);
      ASSERT_EQ(plain.channels.size(), 3u) << map;
      EXPECT_EQ(plain.channel("R"), all.channel(map + ".X")) << map;
      EXPECT_EQ(plain.channel("G"), all.channel(map + ".Y")) << map;
      EXPECT_EQ(plain.channel("B"), all.channel(map + ".Z")) << map;
    }
  }
  bake("combined", {"--combined"});
  EXPECT_THAT(bake("combined", {"--layout", "combined"}).output,
              HasSubstr("0 frames written, 1 there already"));
}

// Fails if normals are not of unit length, or not at right angles to the tangents of the displaced surface,
// which follow from slopes and gradients. Bound: some ten roundings of 6e-8, measured 2e-7, gate 1e-6.
TEST_F(BakeLayout, NormalsAreThoseOfTheDisplacedSurface) {
  bake("out", {"--channels", all_channels, "--include-gerstner"});
  double steepest = 0.0;
  for (const std::string cascade : {"ocean.c0", "ocean.c1"}) {
    const ExrContent all = image("out", cascade);
    for (std::size_t i = 0; i < columns_of_map * columns_of_map; ++i) {
      const auto at = [&](const char* channel) { return static_cast<double>(all.channel(channel)[i]); };
      const double x = at("normal.X"), y = at("normal.Y"), z = at("normal.Z");
      ASSERT_NEAR(x * x + y * y + z * z, 1.0, 1e-6);
      ASSERT_NEAR(x * (1.0 + at("gradient.XX")) + y * at("slope.X") + z * at("gradient.XZ"), 0.0, 1e-6);
      ASSERT_NEAR(x * at("gradient.XZ") + y * at("slope.Z") + z * (1.0 + at("gradient.ZZ")), 0.0, 1e-6);
      ASSERT_GT(y * at("jacobian"), 0.0);
      steepest = std::max(steepest, std::hypot(x, z));
    }
  }
  EXPECT_GT(steepest, 0.1);
}

// Fails if a vector, a derivative or a mesh is not turned with the others, or turned to a mirrored sea: north
// is minus south.
TEST_F(BakeLayout, AxesTurnEverything) {
  bake("y", {"--channels", all_channels, "--mesh", "ply"});
  bake("z", {"--channels", all_channels, "--mesh", "ply", "--axes", "z-up"});
  bake("rgb", {"--layout", "rgb", "--axes", "z-up"});
  const ExrContent y_up = image("y", "ocean.c1"), z_up = image("z", "ocean.c1");
  ASSERT_EQ(z_up.channels.size(), y_up.channels.size());
  for (const std::string vector : {"displacement", "velocity", "normal"}) {
    EXPECT_EQ(z_up.channel(vector + ".X"), y_up.channel(vector + ".X")) << vector;
    EXPECT_EQ(z_up.channel(vector + ".Y"), minus(y_up.channel(vector + ".Z"))) << vector;
    EXPECT_EQ(z_up.channel(vector + ".Z"), y_up.channel(vector + ".Y")) << vector;
  }
  EXPECT_EQ(z_up.channel("slope.X"), y_up.channel("slope.X"));
  EXPECT_EQ(z_up.channel("slope.Y"), minus(y_up.channel("slope.Z")));
  EXPECT_EQ(z_up.channel("gradient.XX"), y_up.channel("gradient.XX"));
  EXPECT_EQ(z_up.channel("gradient.XY"), minus(y_up.channel("gradient.XZ")));
  EXPECT_EQ(z_up.channel("gradient.YY"), y_up.channel("gradient.ZZ"));
  EXPECT_EQ(z_up.channel("jacobian"), y_up.channel("jacobian"));
  const ExrContent plain = image("rgb", "ocean.c1_displacement");
  EXPECT_EQ(plain.channel("G"), z_up.channel("displacement.Y"));
  EXPECT_EQ(plain.channel("B"), z_up.channel("displacement.Z"));
  EXPECT_NE(file_content(folder("y") / "ocean.0003.ply"), file_content(folder("z") / "ocean.0003.ply"));
  EXPECT_EQ(description("y")["texels"]["row_axis"], "+z");
  EXPECT_EQ(description("z")["texels"]["row_axis"], "-y");
}

// Fails if the waves of ocean.json, its texels or its axes are not those of the maps: the listed waves are
// what --include-gerstner adds. Gate: float sums, as in GerstnerCommand.BakeIncludesWhatItLists.
TEST_F(BakeLayout, DescriptionEvaluatesToTheMaps) {
  for (const std::string axes : {"y-up", "z-up"}) {
    bake("listed " + axes, {"--layout", "rgb", "--axes", axes});
    bake("included " + axes, {"--layout", "rgb", "--axes", axes, "--include-gerstner"});
    const json sea = description("listed " + axes), whole = description("included " + axes);
    const bool is_z_up = axes == "z-up";
    EXPECT_EQ(sea["gerstner"]["in_maps"], false);
    EXPECT_THAT(sea["left_out"].dump(), HasSubstr("gerstner"));
    EXPECT_EQ(whole["left_out"].size(), 0u);
    EXPECT_FALSE(whole["cascades"][0]["tileable"].get<bool>());
    EXPECT_NEAR(whole["maps_hs_m"].get<double>(), whole["hs_m"].get<double>(),
                0.02 * whole["hs_m"].get<double>());
    EXPECT_LT(sea["maps_hs_m"].get<double>(), 0.9 * sea["hs_m"].get<double>());
    ASSERT_EQ(sea["gerstner"]["waves"].size(), 4u);
    const ExrContent listed = image("listed " + axes, "ocean.c0_displacement");
    const ExrContent included = image("included " + axes, "ocean.c0_displacement");
    const double texel_m = sea["cascades"][0]["texel_m"],
                 time_s = 3.0 / sea["frames_per_second"].get<double>();
    for (std::size_t i = 0; i < columns_of_map * columns_of_map; ++i) {
      const double x = texel_m * static_cast<double>(i % columns_of_map);
      const double second = (is_z_up ? -1.0 : 1.0) * texel_m * static_cast<double>(i / columns_of_map);
      double dx = 0.0, d_second = 0.0, up = 0.0;
      for (const json& wave : sea["gerstner"]["waves"]) {
        const double a = wave["amplitude_m"], kx = wave["kx_radpm"];
        const double k_second = wave[is_z_up ? "ky_radpm" : "kz_radpm"], k = std::hypot(kx, k_second);
        const double p = kx * x + k_second * second - wave["omega_radps"].get<double>() * time_s +
                         wave["phase_rad"].get<double>();
        const double q = sea["gerstner"]["choppiness"];
        up += a * std::cos(p);
        dx -= q * a * kx / k * std::sin(p);
        d_second -= q * a * k_second / k * std::sin(p);
      }
      const auto expect_added = [&](const char* channel, double expected) {
        ASSERT_NEAR(included.channel(channel)[i] - listed.channel(channel)[i], expected, 1e-5) << channel;
      };
      expect_added("R", dx);
      expect_added(is_z_up ? "G" : "B", d_second);
      expect_added(is_z_up ? "B" : "G", up);
    }
  }
}

// Fails if a bake of plain files does not resume, takes a frame for finished that lacks one of its files, or
// goes on in a folder of another layout or other axes; or if --force leaves files of the old layout.
TEST_F(BakeLayout, PlainFilesResume) {
  bake("out", {"--layout", "rgb"});
  const auto before = folder_content(folder("out"));
  EXPECT_THAT(bake("out", {"--layout", "rgb"}).output, HasSubstr("0 frames written, 1 there already"));
  std::filesystem::remove(folder("out") / "ocean.c1_normal.0003.exr");
  EXPECT_THAT(bake("out", {"--layout", "rgb"}).output, HasSubstr("1 frame written, 0 there already"));
  EXPECT_TRUE(folder_content(folder("out")) == before);
  for (const std::vector<std::string>& other :
       std::vector<std::vector<std::string>>{{}, {"--layout", "rgb", "--axes", "z-up"}, {"--combined"}}) {
    EXPECT_EQ(try_bake("out", other).exit_code, 2);
  }
  EXPECT_TRUE(folder_content(folder("out")) == before);
  bake("out", {"--force"});
  EXPECT_THAT(names("out"), UnorderedElementsAre("ocean.json", "ocean.c0.0003.exr", "ocean.c1.0003.exr"));
}

// Fails if ocean.json is not made again where it is missing, or does not tell of which bake it is: one of
// this bake lets it resume, any other file of that name is kept without --force.
TEST_F(BakeLayout, DescriptionBelongsToItsBake) {
  const auto file = folder("out") / "ocean.json";
  bake("out", {});
  const std::string own = file_content(file);
  std::filesystem::remove(file);
  EXPECT_THAT(bake("out", {}).output, HasSubstr("0 frames written"));
  EXPECT_EQ(file_content(file), own);
  for (const char* frame : {"ocean.c0.0003.exr", "ocean.c1.0003.exr"}) {
    std::filesystem::remove(folder("out") / frame);
  }
  EXPECT_EQ(try_bake("out", {"--seed", "4"}).exit_code, 2);
  EXPECT_THAT(bake("out", {}).output, HasSubstr("1 frame written"));
  std::ofstream(file) << "{\"mine\": 1}";
  EXPECT_THAT(try_bake("out", {}).errors, HasSubstr("ocean.json: expected a file of this bake"));
  EXPECT_EQ(file_content(file), "{\"mine\": 1}");
  bake("out", {"--force"});
  EXPECT_EQ(file_content(file), own);
}

// Fails if the error that --half states is not the largest one in the files, or is above its bound.
TEST_F(BakeLayout, HalfStatesItsError) {
  bake("full", {});
  const ProgramResult result = bake("half", {"--half", "--json", "--quiet"});
  const json errors = json::parse(result.output, nullptr, false)["half_errors"];
  EXPECT_EQ(errors.size(), 6u);
  double largest_error = 0.0, largest = 0.0;
  for (const std::string cascade : {"ocean.c0", "ocean.c1"}) {
    const ExrContent full = image("full", cascade), half = image("half", cascade);
    for (const char* channel : {"displacement.X", "displacement.Y", "displacement.Z"}) {
      for (std::size_t i = 0; i < columns_of_map * columns_of_map; ++i) {
        const double value = full.channel(channel)[i];
        largest_error = std::max(largest_error, std::abs(value - half.channel(channel)[i]));
        largest = std::max(largest, std::abs(value));
      }
    }
  }
  EXPECT_GT(largest_error, 0.0);
  EXPECT_EQ(errors["displacement"]["largest_error"].get<double>(), largest_error);
  EXPECT_EQ(errors["displacement"]["bound"].get<double>(), largest / 2048.0);
  for (const json& error : errors) {
    EXPECT_LE(error["largest_error"].get<double>(), error["bound"].get<double>());
  }
  std::filesystem::remove(folder("half") / "ocean.json");
  EXPECT_THAT(bake("half", {"--half", "--force"}).output,
              testing::Not(HasSubstr("16-bit")));  // all were there
}

// Fails if energy that the maps do not have goes unsaid, or is said where they have it.
TEST_F(BakeLayout, WarnsOfEnergyBesideTheMaps) {
  EXPECT_THAT(bake("out", {}).errors,
              testing::ContainsRegex("the maps leave out the 4 Gerstner waves, [0-9]+ % of"));
  EXPECT_THAT(bake("included", {"--include-gerstner"}).errors, testing::Not(HasSubstr("leave out")));
}

// Fails if a map that has no plain form is left out without a word.
TEST_F(BakeLayout, RefusesPlainSlopes) {
  const ProgramResult result = try_bake("out", {"--layout", "rgb", "--channels", "foam,slope"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstr("--channels"));
  EXPECT_FALSE(std::filesystem::exists(folder("out")));
}

}  // namespace
}  // namespace offing::test
