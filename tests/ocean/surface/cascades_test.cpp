#include "host/ocean/surface/cascades.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "tests/ocean/example_seas.h"
#include "tests/ocl/expect_error.h"

namespace offing::ocean {
namespace {

using std::numbers::pi;

// Bands that overlap count waves twice, gaps lose them: the first must begin at the split, each other exactly
// where the last ends.
void expect_bands_meet(const std::vector<Cascade>& cascades, int size, const std::string& name,
                       double split_radpm = 0.0) {
  ASSERT_FALSE(cascades.empty()) << name;
  EXPECT_EQ(cascades.front().k_min_radpm, split_radpm) << name;
  for (std::size_t i = 0; i < cascades.size(); ++i) {
    EXPECT_GT(cascades[i].k_max_radpm, cascades[i].k_min_radpm) << name;
    EXPECT_LE(cascades[i].k_max_radpm, resolved_wavenumber_radpm(cascades[i].patch_length_m, size)) << name;
    if (i > 0) {
      EXPECT_EQ(cascades[i].k_min_radpm, cascades[i - 1].k_max_radpm) << name;
      EXPECT_LT(cascades[i].patch_length_m, cascades[i - 1].patch_length_m) << name;
    }
  }
}

TEST(Cascades, FromPatchesSortsAndJoins) {
  const double lengths_m[] = {37.0, 1000.0, 190.0};
  const std::vector<Cascade> cascades = cascades_from_patches(lengths_m, 256);
  ASSERT_EQ(cascades.size(), 3u);
  EXPECT_EQ(cascades[0].patch_length_m, 1000.0);
  EXPECT_EQ(cascades[2].patch_length_m, 37.0);
  EXPECT_DOUBLE_EQ(cascades[0].k_max_radpm, 127.0 * 2.0 * pi / 1000.0);
  EXPECT_DOUBLE_EQ(cascades[2].k_max_radpm, 127.0 * 2.0 * pi / 37.0);
  expect_bands_meet(cascades, 256, "from patches");
}

// Fails if waves that Gerstner waves carry are drawn again, or if patches are chosen for those waves: they
// would resolve too few of the others. Below twice the peak's wavenumber lies about half of a sea's energy.
TEST(Cascades, BeginAtTheSplit) {
  const double lengths_m[] = {37.0, 190.0};
  expect_bands_meet(cascades_from_patches(lengths_m, 256, 0.11), 256, "from patches", 0.11);
  for (const ExampleSea& sea : example_seas()) {
    const double split_radpm = 2.0 * sea.spectrum.dispersion.wavenumber_radpm(sea.spectrum.omega_peak_radps);
    // Narrow swells have nothing beyond it.
    if (sea.spectrum.dispersion.omega_radps(split_radpm) > sea.spectrum.omega_max_radps) continue;
    const std::vector<Cascade> cascades = choose_cascades(sea.spectrum, 256, 3, split_radpm);
    expect_bands_meet(cascades, 256, sea.name, split_radpm);
    EXPECT_GE(cascades.front().patch_length_m, 15.8 * 2.0 * pi / split_radpm) << sea.name;
    EXPECT_GT(integrate_sea_state(sea.spectrum, split_radpm, cascades.back().k_max_radpm).m0_m2,
              0.998 * integrate_sea_state(sea.spectrum, split_radpm).m0_m2)
        << sea.name;
  }
}

// Fails if a split that leaves a patch or a sea without waves gives a sea without them.
TEST(Cascades, RejectsSplitsBeyondTheWaves) {
  const double lengths_m[] = {37.0, 1000.0};
  test::expect_error(ErrorKind::bad_input, "resolves waves shorter than the 6.283 m of the split",
                     [&] { cascades_from_patches(lengths_m, 256, 1.0); });
  for (const double split_radpm : {-1.0, std::numeric_limits<double>::quiet_NaN()}) {
    test::expect_error(ErrorKind::bad_input, "split_radpm",
                       [&] { cascades_from_patches(lengths_m, 256, split_radpm); });
    test::expect_error(ErrorKind::bad_input, "split_radpm",
                       [&] { choose_cascades(example_seas().front().spectrum, 256, 3, split_radpm); });
  }
  const SeaSpectrum measured = example_seas().back().spectrum;
  test::expect_error(ErrorKind::bad_input, "the wavenumbers of the spectrum",
                     [&] { choose_cascades(measured, 256, 3, 2.0); });
}

TEST(Cascades, RejectsWhatCannotBeBuilt) {
  const auto expect_rejected = [](std::vector<double> lengths_m, int size, const std::string& what) {
    try {
      cascades_from_patches(lengths_m, size);
      ADD_FAILURE() << what << " was accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
      EXPECT_FALSE(error.hint().empty());
    }
  };
  expect_rejected({}, 256, "1 to 4 patches");
  expect_rejected({1.0, 2.0, 3.0, 4.0, 5.0}, 256, "1 to 4 patches");
  expect_rejected({100.0, 100.0}, 256, "different lengths");
  expect_rejected({-1.0}, 256, "patch_length_m");
  expect_rejected({std::numeric_limits<double>::quiet_NaN(), 5.0}, 256, "patch_length_m");
  expect_rejected({100.0}, 255, "power of two");
  expect_rejected({100.0}, 8, "power of two");
  expect_rejected({100.0}, 8192, "power of two");
  expect_rejected({100.0}, -256, "power of two");
  const SeaSpectrum spectrum = example_seas().front().spectrum;
  EXPECT_THROW(choose_cascades(spectrum, 100), Error);
  EXPECT_THROW(choose_cascades(spectrum, 256, 0), Error);
  EXPECT_THROW(choose_cascades(spectrum, 256, 5), Error);
}

double share_in_band(const SeaSpectrum& spectrum, const std::vector<Cascade>& cascades) {
  const double first_mode_radpm = 2.0 * pi / cascades.front().patch_length_m;
  return integrate_sea_state(spectrum, first_mode_radpm, cascades.back().k_max_radpm).m0_m2 /
         integrate_sea_state(spectrum).m0_m2;
}

// From the first mode of the longest patch to the end of the last band. 99.5 % from 64 samples on; fewer
// cannot hold both ends of every sea (the spiky record spans a factor 88 in wavenumber, 16 samples with three
// cascades 38).
TEST(Cascades, ChosenBandsHoldTheSea) {
  for (const ExampleSea& sea : example_seas()) {
    for (int size = 16; size <= 4096; size *= 2) {
      const std::vector<Cascade> cascades = choose_cascades(sea.spectrum, size);
      const std::string name = sea.name + " at " + std::to_string(size);
      EXPECT_LE(cascades.size(), 3u);
      expect_bands_meet(cascades, size, name);
      const double least = size >= 256 ? 0.998 : size >= 64 ? 0.995 : size == 32 ? 0.98 : 0.8;
      EXPECT_GT(share_in_band(sea.spectrum, cascades), least) << name;
    }
  }
}

// From 256 samples on the longest patch need not shrink: about 20 wavelengths of the peak, a fifth less at
// most.
TEST(Cascades, LongestPatchHoldsManyWaves) {
  for (const ExampleSea& sea : example_seas()) {
    const Cascade longest = choose_cascades(sea.spectrum, 512).front();
    const double peak_m = 2.0 * pi / sea.spectrum.dispersion.wavenumber_radpm(sea.spectrum.omega_peak_radps);
    EXPECT_GE(longest.patch_length_m, 15.8 * peak_m) << sea.name;
  }
}

// The mixed record peaks at 0.06 Hz or 0.2 Hz; its swell, 433 m long, must fit several times either way.
TEST(Cascades, LongSwellBelowAWindSeaFits) {
  for (const ExampleSea& sea : example_seas()) {
    if (sea.name.starts_with("measured")) {
      EXPECT_GE(choose_cascades(sea.spectrum, 256).front().patch_length_m, 8.0 * 433.0) << sea.name;
    }
  }
}

// Measured seas end at 0.5 Hz: with samples to spare one patch carries all.
TEST(Cascades, StopsWhenTheSeaEnds) {
  for (const ExampleSea& sea : example_seas()) {
    if (sea.name.starts_with("measured")) {
      EXPECT_EQ(choose_cascades(sea.spectrum, 4096).size(), 1u) << sea.name;
    }
  }
  EXPECT_EQ(choose_cascades(example_seas().front().spectrum, 64, 1).size(), 1u);
}

// Tiles of two patches line up after p tiles of one and q of the other when q times the ratio of lengths is
// the whole number p: for q up to 8 it stays at least 0.03 away, so that after 8 tiles the phase has still
// slipped by 3 %.
TEST(Cascades, TilesDoNotLineUp) {
  for (const ExampleSea& sea : example_seas()) {
    for (int size = 16; size <= 2048; size *= 2) {
      const std::vector<Cascade> cascades = choose_cascades(sea.spectrum, size, 4);
      for (std::size_t i = 0; i < cascades.size(); ++i) {
        for (std::size_t j = i + 1; j < cascades.size(); ++j) {
          for (int multiple = 1; multiple <= 8; ++multiple) {
            const double ratio = multiple * cascades[i].patch_length_m / cascades[j].patch_length_m;
            EXPECT_GT(std::abs(ratio - std::round(ratio)), 0.03)
                << sea.name << ": " << cascades[i].patch_length_m << " m and " << cascades[j].patch_length_m
                << " m";
          }
        }
      }
    }
  }
}

TEST(Cascades, LengthsHaveThreeDigits) {
  for (const ExampleSea& sea : example_seas()) {
    for (const Cascade& cascade : choose_cascades(sea.spectrum, 256)) {
      const double unit = std::pow(10.0, std::floor(std::log10(cascade.patch_length_m)) - 2.0);
      const double digits = cascade.patch_length_m / unit;
      EXPECT_NEAR(digits, std::round(digits), 1e-6) << sea.name;
    }
  }
}

}  // namespace
}  // namespace offing::ocean
