// A sea with Gerstner waves on the command line: what bakes list and include, and what the certificate says.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
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

constexpr int size = 32;
constexpr double spacing_m = 250.0 / size;

struct Wave {
  double amplitude_m, kx_radpm, kz_radpm, phase_rad;
  double k_radpm() const { return std::hypot(kx_radpm, kz_radpm); }
  double phase_at(std::size_t texel) const {
    return kx_radpm * spacing_m * static_cast<double>(texel % size) +
           kz_radpm * spacing_m * static_cast<double>(texel / size) + phase_rad;
  }
};

template <class Value>
Value attribute(const ExrContent& image, const std::string& name) {
  for (const auto& [key, value] : image.attributes)
    if (key == name) return std::get<Value>(value);
  ADD_FAILURE() << "no attribute " << name;
  return {};
}

// The list as a user's script takes it apart.
std::vector<Wave> listed_waves(const ExrContent& image) {
  EXPECT_EQ(attribute<std::string>(image, "gerstner_columns"), "A_m kx_radpm kz_radpm phase_rad");
  std::string text = attribute<std::string>(image, "gerstner");
  for (char& character : text)
    if (character == ';') character = ' ';
  std::istringstream numbers(text);
  std::vector<Wave> waves;
  for (Wave wave{}; numbers >> wave.amplitude_m >> wave.kx_radpm >> wave.kz_radpm >> wave.phase_rad;)
    waves.push_back(wave);
  return waves;
}

class GerstnerCommand : public testing::Test {
 protected:
  // Eight waves longer than 45 m, that is 5.8 texels of the patch.
  static std::vector<std::string> sea(const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {
        "--size",           "32", "--patch-m", "250,31", "--gerstner-count", "8", "--gerstner-split-m", "45",
        "--wind-speed-mps", "13", "--seed",    "3"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  std::filesystem::path folder(const char* name) const { return root_.path() / name; }
  ProgramResult bake(const char* name, const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = {"ocean", "bake", "-o", folder(name).string(), "--fps", "4"};
    const std::vector<std::string> of_sea = sea(more);
    arguments.insert(arguments.end(), of_sea.begin(), of_sea.end());
    return run_offing(arguments);
  }
  ExrContent image(const char* name, const char* file) const { return read_exr(folder(name) / file); }
  static json stats(const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"ocean", "stats", "--json", "--quiet"};
    const std::vector<std::string> of_sea = sea(more);
    arguments.insert(arguments.end(), of_sea.begin(), of_sea.end());
    const ProgramResult result = run_offing(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return json::parse(result.output, nullptr, false);
  }

 private:
  TemporaryFolder root_;
};

// Fails if the waves that tiles leave out are not told, or other waves than the sea's: they have its energy
// below the split and stand still in none of the frames.
TEST_F(GerstnerCommand, BakeListsTheWavesInTheHeader) {
  ASSERT_EQ(bake("out", {"--frames", "0:1"}).exit_code, 0);
  const std::vector<Wave> first = listed_waves(image("out", "ocean.c0.0000.exr"));
  const std::vector<Wave> second = listed_waves(image("out", "ocean.c1.0001.exr"));
  ASSERT_EQ(first.size(), 8u);
  ASSERT_EQ(second.size(), 8u);
  double energy_m2 = 0.0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    energy_m2 += 0.5 * first[i].amplitude_m * first[i].amplitude_m;
    EXPECT_LT(first[i].k_radpm(), 2.0 * M_PI / 45.0);
    EXPECT_EQ(first[i].kx_radpm, second[i].kx_radpm);
    // A quarter of a second later, at the frequency of deep water within the clock's 7.5e-9 Hz.
    const double turned_rad = first[i].phase_rad - second[i].phase_rad;
    const double expected_rad = 0.25 * std::sqrt(9.81 * first[i].k_radpm());
    EXPECT_NEAR(std::remainder(turned_rad - expected_rad, 2.0 * M_PI), 0.0, 1e-7);
  }
  EXPECT_NEAR(energy_m2, stats({"--seeds", "1"})["gerstner"]["spectrum_m0_m2"].get<double>(), 1e-9);
  EXPECT_EQ(attribute<int>(image("out", "ocean.c0.0000.exr"), "tileable"), 1);
}

// Fails if included waves are not the ones that the header lists, in place, size or sign; if another cascade
// has them too; or if Jacobian and foam are still the tile's own. Heights are sums of floats: gate 1e-5 m.
TEST_F(GerstnerCommand, BakeIncludesWhatItLists) {
  const std::vector<std::string> frame = {"--frames", "3:3", "--velocity", "--foam-onset", "0.95"};
  std::vector<std::string> included_frame = frame;
  included_frame.emplace_back("--include-gerstner");
  ASSERT_EQ(bake("listed", frame).exit_code, 0);
  ASSERT_EQ(bake("included", included_frame).exit_code, 0);
  const ExrContent listed = image("listed", "ocean.c0.0003.exr");
  const ExrContent included = image("included", "ocean.c0.0003.exr");
  EXPECT_EQ(attribute<int>(included, "tileable"), 0);
  EXPECT_EQ(attribute<int>(image("included", "ocean.c1.0003.exr"), "tileable"), 1);
  EXPECT_EQ(image("included", "ocean.c1.0003.exr").channel("displacement.Y"),
            image("listed", "ocean.c1.0003.exr").channel("displacement.Y"));
  const std::vector<Wave> waves = listed_waves(included);
  const double q = attribute<double>(included, "gerstner_choppiness");
  EXPECT_EQ(q, 1.0);
  for (std::size_t i = 0; i < size * size; ++i) {
    double dx = 0, h = 0, dz = 0, sx = 0, xx = 0, xz = 0, zz = 0, rise_mps = 0;
    for (const Wave& wave : waves) {
      const double a = wave.amplitude_m, k = wave.k_radpm(), phase = wave.phase_at(i);
      const double kx = wave.kx_radpm, kz = wave.kz_radpm;
      h += a * std::cos(phase);
      dx -= q * a * kx / k * std::sin(phase);
      dz -= q * a * kz / k * std::sin(phase);
      sx -= a * kx * std::sin(phase);
      xx -= q * a * kx * kx / k * std::cos(phase);
      xz -= q * a * kx * kz / k * std::cos(phase);
      zz -= q * a * kz * kz / k * std::cos(phase);
      rise_mps += a * std::sqrt(9.81 * k) * std::sin(phase);
    }
    const auto expect_added = [&](const char* channel, double expected) {
      ASSERT_NEAR(included.channel(channel)[i] - listed.channel(channel)[i], expected, 1e-5) << channel;
    };
    expect_added("displacement.X", dx);
    expect_added("displacement.Y", h);
    expect_added("displacement.Z", dz);
    expect_added("slope.X", sx);
    expect_added("gradient.XX", xx);
    expect_added("gradient.XZ", xz);
    expect_added("gradient.ZZ", zz);
    expect_added("velocity.Y", rise_mps);
  }
}

// Fails if the Jacobian of the included waves is not that of the whole sea, its own gradients' in the file;
// or if foam is not gathered by these waves: where it does not reach 1, it is the tile's own times a e^(s p),
// with p the compression by the waves, a and s the same everywhere. Gates: 1e-5, rounding, and 1e-3 of a foam
// above 0.01.
TEST_F(GerstnerCommand, IncludedFoamIsThatOfTheWholeSea) {
  const auto bake_one = [&](const char* name, const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"ocean",
                                          "bake",
                                          "-o",
                                          folder(name).string(),
                                          "--fps",
                                          "4",
                                          "--size",
                                          "32",
                                          "--patch-m",
                                          "250",
                                          "--gerstner-count",
                                          "8",
                                          "--gerstner-split-m",
                                          "45",
                                          "--foam-onset",
                                          "0.95",
                                          "--frames",
                                          "2:2"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(run_offing(arguments).exit_code, 0);
    return image(name, "ocean.c0.0002.exr");
  };
  const ExrContent listed = bake_one("listed", {}), included = bake_one("included", {"--include-gerstner"});
  std::vector<std::pair<double, double>> gathered;  // p, ln of the ratio
  for (std::size_t i = 0; i < size * size; ++i) {
    const double xx = 1.0 + included.channel("gradient.XX")[i], xz = included.channel("gradient.XZ")[i];
    const double zz = 1.0 + included.channel("gradient.ZZ")[i], jacobian = xx * zz - xz * xz;
    ASSERT_NEAR(included.channel("jacobian")[i], jacobian, 1e-5);
    ASSERT_NEAR(included.channel("jacobian_min_eigenvalue")[i],
                0.5 * (xx + zz) - std::hypot(0.5 * (xx - zz), xz), 1e-5);
    const double tile = listed.channel("foam")[i], foam = included.channel("foam")[i];
    ASSERT_EQ(foam == 0.0, tile == 0.0);
    if (tile < 0.01 || foam >= 1.0) continue;
    const double compression =
        2.0 + listed.channel("gradient.XX")[i] + listed.channel("gradient.ZZ")[i] - xx - zz;
    gathered.emplace_back(compression, std::log(foam / tile));
  }
  ASSERT_GT(gathered.size(), size * size / 20);
  const auto [least, most] = std::ranges::minmax(gathered);
  const double slope = (most.second - least.second) / (most.first - least.first);
  EXPECT_GT(slope, 1.0);
  for (const auto& [compression, ratio] : gathered) {
    ASSERT_NEAR(ratio, least.second + slope * (compression - least.first), 1e-3);
  }
  EXPECT_NE(attribute<std::string>(listed, "scene_hash"), attribute<std::string>(included, "scene_hash"));
}

// Fails if the mesh leaves out waves that its picture of the sea has, or has them where they are not asked
// for.
TEST_F(GerstnerCommand, MeshHasTheIncludedWaves) {
  ASSERT_EQ(bake("listed", {"--frames", "0:0", "--mesh", "ply"}).exit_code, 0);
  ASSERT_EQ(bake("included", {"--frames", "0:0", "--mesh", "ply", "--include-gerstner"}).exit_code, 0);
  EXPECT_NE(file_content(folder("listed") / "ocean.0000.ply"),
            file_content(folder("included") / "ocean.0000.ply"));
}

// Fails if choppiness is limited, or an option does nothing, without a word.
TEST_F(GerstnerCommand, TellsWhatItDoesNotDo) {
  EXPECT_THAT(bake("steep", {"--frames", "0:0", "--choppiness", "5"}).errors,
              HasSubstr("the Gerstner waves have a choppiness of "));
  EXPECT_THAT(bake("none", {"--frames", "0:0", "--gerstner-count", "0", "--include-gerstner"}).errors,
              HasSubstr("--include-gerstner: not used: there are no Gerstner waves"));
  EXPECT_THAT(bake("split", {"--frames", "0:0", "--gerstner-count", "0"}).errors,
              HasSubstr("--gerstner-split-m: not used: there are no Gerstner waves"));
  EXPECT_EQ(bake("all", {"--frames", "0:0", "--gerstner-split-m", "3"}).exit_code, 2);
}

// Fails if the certificate leaves out the Gerstner waves, counts them twice, or measures the cascades alone.
// Energies add up to m0 within 0.3 %; k A of the listed waves is what max_ka has above that of the cascades,
// whose mss is that of all less the waves' own.
TEST_F(GerstnerCommand, CertificateHasTheWaves) {
  const json certificate = stats({"--seeds", "1"});
  double total_m2 = certificate["gerstner"]["spectrum_m0_m2"].get<double>();
  EXPECT_GT(total_m2, 0.3 * certificate["m0_m2"].get<double>());
  total_m2 += certificate["out_of_band_m2"].get<double>();
  for (const json& cascade : certificate["cascades"]) total_m2 += cascade["expected_m0_m2"].get<double>();
  EXPECT_NEAR(total_m2 / certificate["m0_m2"].get<double>(), 1.0, 0.003);

  ASSERT_EQ(bake("out", {"--frames", "0:0"}).exit_code, 0);
  double steepness = 0.0, mss = 0.0;
  for (const Wave& wave : listed_waves(image("out", "ocean.c0.0000.exr"))) {
    steepness += wave.amplitude_m * wave.k_radpm();
    mss += 0.5 * std::pow(wave.amplitude_m * wave.k_radpm(), 2.0);
  }
  const double cascade_mss = certificate["measured"]["mss"].get<double>() - mss;
  EXPECT_NEAR(certificate["measured"]["max_ka"].get<double>(), steepness + 3.0 * std::sqrt(cascade_mss),
              1e-6);

  const json many = stats({"--seeds", "8"});
  EXPECT_NEAR(many["measured"]["hs_m"].get<double>(), many["resolved"]["hs_m"].get<double>(),
              4.0 * many["standard_error"]["hs_m"].get<double>());
  EXPECT_NEAR(many["measured"]["tm02_s"].get<double>(), many["resolved"]["tm02_s"].get<double>(),
              5.0 * many["standard_error"]["tm02_s"].get<double>());
  // Eight equal waves of random phase: kurtosis 3 - 1.5 / 8 times the square of their share of the energy.
  EXPECT_LT(many["measured"]["kurtosis"].get<double>(), 3.0);
  EXPECT_GT(many["measured"]["kurtosis"].get<double>(), 2.75);
}

// Fails if the swells and raindrops of a scene stay out of the header, the frames that include them, or the
// certificate. The swell is alone but for cascades of 1e-3 m, so that the frame is A cos(k x), 2 pi / k = 50
// m, and where the drop fell at that time its height above it; 177 m off, 0.6 mm are left of it. Gate: that
// and the cascades.
TEST_F(GerstnerCommand, SceneAddsSwellsAndRaindrops) {
  std::filesystem::create_directories(folder("scene"));
  const std::filesystem::path scene = folder("scene") / "swell.toml";
  std::ofstream(scene) << "version = 1\n[ocean]\nspectrum = \"swell\"\nswell_hs_m = 0.001\nsize = 32\n"
                          "[[ocean.cascade]]\npatch_m = 250\n"
                          "[[ocean.swell]]\namplitude_m = 0.8\nwavelength_m = 50\n"
                          "[[ocean.raindrop]]\nx_m = 125\nz_m = 125\namplitude_m = 0.03\nwavelength_m = 50\n";
  const auto bake_scene = [&](const char* name, const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"ocean", "bake", scene.string(), "--frames",           "0:0",
                                          "--fps", "4",    "-o",           folder(name).string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_offing(arguments);
  };
  const ProgramResult listed = bake_scene("listed", {});
  ASSERT_EQ(listed.exit_code, 0) << listed.errors;
  EXPECT_THAT(listed.errors, HasSubstr("the frames leave out the raindrops of the scene"));
  const std::vector<Wave> waves = listed_waves(image("listed", "ocean.c0.0000.exr"));
  ASSERT_EQ(waves.size(), 1u);
  EXPECT_EQ(waves[0].amplitude_m, 0.8);

  ASSERT_EQ(bake_scene("included", {"--include-gerstner"}).exit_code, 0);
  const ExrContent frame = image("included", "ocean.c0.0000.exr");
  const std::size_t middle = size / 2 * size + size / 2;  // 125 m, 125 m
  const auto& height_m = frame.channel("displacement.Y");
  EXPECT_NEAR(height_m[0], 0.8, 1.5e-3);
  EXPECT_NEAR(height_m[middle], 0.8 * std::cos(2.0 * M_PI * 125.0 / 50.0) + 0.03, 1.5e-3);

  const ProgramResult stats = run_offing({"ocean", "stats", scene.string(), "--seeds", "1", "--json"});
  ASSERT_EQ(stats.exit_code, 0) << stats.errors;
  const json certificate = json::parse(stats.output, nullptr, false);
  EXPECT_EQ(certificate["swells"]["count"], 1);
  EXPECT_NEAR(certificate["swells"]["m0_m2"].get<double>(), 0.32, 1e-12);
  EXPECT_NEAR(certificate["measured"]["hs_m"].get<double>(), 4.0 * std::sqrt(0.32), 1e-3);
  EXPECT_NEAR(certificate["resolved"]["hs_m"].get<double>(), 4.0 * std::sqrt(0.32), 1e-3);
  EXPECT_NEAR(certificate["asked"]["hs_m"].get<double>(), 0.001, 1e-5);
}

}  // namespace
}  // namespace offing::test
