// Gerstner waves on the device against their definition in double precision, for both kernel shapes.
//
// Bound on the error of a field, a share of the sum of its waves' largest values: 2^-33 turns of phase at the
// first sample and as much a step of column and row, 2 pi 2^-33 (1 + 300 + 200) = 3.7e-7 (1000 columns:
// 7.3e-7); 1e-7 of each polynomial and 5e-8 of its argument, for two factors 3e-7; rounding of amplitudes and
// products, 1.2e-7; and sums of 16 terms, 16 u = 1e-6 at most. Together 2e-6. Measured 2.3e-7. Gate 1e-6: two
// lost bits of phase fail.
#include "host/ocean/surface/gerstner_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "tests/ocl/expect_error.h"
#include "tests/ocl/scoped_environment.h"

namespace offing::ocean {
namespace {

using std::numbers::pi;

constexpr double gate = 1e-6;
constexpr SampleGrid usual_grid{.origin_x_m = -37.3,
                                .origin_z_m = 11.9,
                                .spacing_x_m = 0.43,
                                .spacing_z_m = 0.71,
                                .columns = 300,
                                .rows = 200};

using Field = std::vector<double>;

// All fields as GerstnerFields has them.
struct Reference {
  Field displacement_x, displacement_y, displacement_z, slope_x, slope_z, gradient_xx, gradient_xz,
      gradient_zz;
};

double smooth_step(double x) {
  return x <= 0.0 ? 0.0 : x >= 1.0 ? 1.0 : x * x * (3.0 - 2.0 * x);
}

// A frequency as the clock holds it (host/ocean/surface/wave_clock.h): whole cycles a loop, or multiples of
// 2^-27 Hz.
double clock_omega_radps(double omega_radps, std::optional<double> loop_period_s) {
  const double step_radps = 2.0 * pi * (loop_period_s ? 1.0 / *loop_period_s : 0x1p-27);
  const double cycles = std::round(omega_radps / step_radps);
  return step_radps * (loop_period_s ? std::max(1.0, cycles) : cycles);
}

// The sum of the waves at each label, by the text of host/ocean/surface/gerstner_waves.h.
Reference reference(const GerstnerSea& sea, double horizontal_scale, const SampleGrid& grid, double time_s) {
  Reference fields;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const double x = grid.origin_x_m + column * grid.spacing_x_m;
      const double z = grid.origin_z_m + row * grid.spacing_z_m;
      double dx = 0, h = 0, dz = 0, sx = 0, sz = 0, xx = 0, xz = 0, zz = 0;
      for (const GerstnerWave& wave : sea.waves) {
        const double k = wave.wavenumber_radpm;
        const double ux = std::cos(wave.direction_rad), uz = std::sin(wave.direction_rad);
        const double samples =
            2.0 * pi / k / std::max(std::abs(ux * grid.spacing_x_m), std::abs(uz * grid.spacing_z_m));
        const double a = wave.amplitude_m * smooth_step((samples - 2.0) / 2.0), qa = horizontal_scale * a;
        const double omega_radps = clock_omega_radps(wave.omega_radps, sea.loop_period_s);
        const double phase = k * (ux * x + uz * z) - omega_radps * time_s + wave.phase_rad;
        const double cosine = std::cos(phase), sine = std::sin(phase);
        h += a * cosine;
        dx -= qa * ux * sine;
        dz -= qa * uz * sine;
        sx -= a * k * ux * sine;
        sz -= a * k * uz * sine;
        xx -= qa * k * ux * ux * cosine;
        xz -= qa * k * ux * uz * cosine;
        zz -= qa * k * uz * uz * cosine;
      }
      fields.displacement_x.push_back(dx);
      fields.displacement_y.push_back(h);
      fields.displacement_z.push_back(dz);
      fields.slope_x.push_back(sx);
      fields.slope_z.push_back(sz);
      fields.gradient_xx.push_back(xx);
      fields.gradient_xz.push_back(xz);
      fields.gradient_zz.push_back(zz);
    }
  }
  return fields;
}

// Largest difference.
double worst_of(const std::vector<float>& found, const Field& expected) {
  double worst = found.size() == expected.size() ? 0.0 : std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < std::min(found.size(), expected.size()); ++i) {
    const double difference = std::abs(found[i] - expected[i]);
    worst = difference <= worst ? worst : difference;  // NaN counts
  }
  return worst;
}

class GerstnerSurfaceTest : public testing::TestWithParam<const char*> {
 protected:
  GerstnerSurfaceTest() : shape_("OFFING_SHAPE", GetParam()), surface_(ocl::Device::open()) {}

  // Sixteen waves of 8 ... 90 m in all directions, steeper together than 1.
  static GerstnerSea sixteen_waves(double choppiness) {
    GerstnerSea sea{.choppiness = choppiness};
    for (int i = 0; i < 16; ++i) {
      const double k = 2.0 * pi / (8.0 + 5.5 * i);
      sea.waves.push_back({.amplitude_m = 0.1 + 0.03 * i,
                           .wavenumber_radpm = k,
                           .direction_rad = 0.7 * i,
                           .omega_radps = std::sqrt(9.81 * k),
                           .phase_rad = 1.3 * i});
    }
    return sea;
  }

  GerstnerFields fields_at(const GerstnerSea& sea, const SampleGrid& grid, double time_s) {
    surface_.at(sea, grid, time_s);
    return surface_.read();
  }

  // Every field within `tolerance` of the sum of its waves' largest values.
  void expect_waves(const GerstnerSea& sea, double scale, const SampleGrid& grid, double time_s,
                    double tolerance = gate) {
    const GerstnerFields found = fields_at(sea, grid, time_s);
    EXPECT_EQ(found.columns, grid.columns);
    EXPECT_EQ(found.rows, grid.rows);
    const Reference expected = reference(sea, scale, grid, time_s);
    double heights = 0.0, slopes = 0.0;
    for (const GerstnerWave& wave : sea.waves) {
      heights += wave.amplitude_m;
      slopes += wave.amplitude_m * wave.wavenumber_radpm;
    }
    const auto expect = [&](const char* name, const std::vector<float>& field, const Field& values,
                            double size) {
      const double worst = worst_of(field, values) / size;
      EXPECT_LE(worst, tolerance) << name << " at " << time_s << " s";
      worst_ = std::max(worst_, worst);
    };
    expect("dx", found.displacement_x, expected.displacement_x, heights);
    expect("h", found.displacement_y, expected.displacement_y, heights);
    expect("dz", found.displacement_z, expected.displacement_z, heights);
    expect("dh/dx", found.slope_x, expected.slope_x, slopes);
    expect("dh/dz", found.slope_z, expected.slope_z, slopes);
    expect("d dx/dx", found.gradient_xx, expected.gradient_xx, slopes);
    expect("d dx/dz", found.gradient_xz, expected.gradient_xz, slopes);
    expect("d dz/dz", found.gradient_zz, expected.gradient_zz, slopes);
  }

  ~GerstnerSurfaceTest() override { RecordProperty("worst", std::to_string(worst_ * 1e9) + "e-9"); }

  test::ScopedEnvironment shape_;
  GerstnerSurface surface_;
  double worst_ = 0.0;
};

// Fails if a sign, factor or index of a field is wrong, or the clock of the waves: 1e7 s is four months,
// where a phase in single precision would be off by whole turns.
TEST_P(GerstnerSurfaceTest, IsTheSumOfItsWaves) {
  const GerstnerSea sea = sixteen_waves(0.3);
  ASSERT_FALSE(horizontal_scale(sea).is_limited);
  for (const double time_s : {0.0, -3.3, 12345.678, 1e7}) expect_waves(sea, 0.3, usual_grid, time_s);
}

// Fails if rows that are no whole number of vectors, shorter than one, or longer than a run of steps are
// wrong, or grids that run backward.
TEST_P(GerstnerSurfaceTest, FitsAnyGrid) {
  const GerstnerSea sea = sixteen_waves(0.3);
  for (const int columns : {1, 2, 15, 16, 17, 33, 256, 257, 1000}) {
    SampleGrid grid = usual_grid;
    grid.columns = columns;
    grid.rows = 3;
    expect_waves(sea, 0.3, grid, 7.0);
  }
  SampleGrid backward = usual_grid;
  backward.spacing_x_m = -0.43;
  backward.spacing_z_m = -0.71;
  expect_waves(sea, 0.3, backward, 7.0);
}

// Fails if an edit is lost or an older sea shows through: waves, choppiness, grid and time change in turn, as
// an editor changes them, on one surface; each is compared with its own sum.
TEST_P(GerstnerSurfaceTest, ShowsEveryEdit) {
  GerstnerSea sea = sixteen_waves(0.3);
  SampleGrid grid = usual_grid;
  grid.columns = grid.rows = 20;
  expect_waves(sea, 0.3, grid, 1.0);
  sea.waves[3].amplitude_m = 0.9;
  expect_waves(sea, 0.3, grid, 1.0);
  sea.waves[3].phase_rad += 1.0;
  expect_waves(sea, 0.3, grid, 1.0);
  sea.choppiness = 0.1;
  expect_waves(sea, 0.1, grid, 2.0);
  grid.origin_x_m += 10.0;
  expect_waves(sea, 0.1, grid, 2.0);
  sea.waves.push_back(make_swell({.amplitude_m = 0.4, .wavelength_m = 60.0}, {}));
  expect_waves(sea, 0.1, grid, 2.0);
  sea.waves.resize(5);
  expect_waves(sea, 0.1, grid, 2.0);
  sea.waves.clear();
  const GerstnerFields flat = fields_at(sea, grid, 2.0);
  for (const float height : flat.displacement_y) ASSERT_EQ(height, 0.0f);
}

// Fails if a steep sea folds, or if its waves are lowered to keep it from folding: heights are those asked
// for, the sideways displacement is scaled by 1 / sum of k A, and no label's smaller eigenvalue of F is below
// 0.
TEST_P(GerstnerSurfaceTest, SteepSeasKeepTheirHeightAndDoNotFold) {
  GerstnerSea sea = sixteen_waves(1.0);
  for (GerstnerWave& wave : sea.waves) wave.amplitude_m *= 4.0;
  const HorizontalScale q = horizontal_scale(sea);
  ASSERT_TRUE(q.is_limited);
  ASSERT_GT(q.steepness, 2.0);
  expect_waves(sea, 1.0 / q.steepness, usual_grid, 5.0);
  const GerstnerFields fields = fields_at(sea, usual_grid, 5.0);
  for (std::size_t i = 0; i < fields.slope_x.size(); ++i) {
    const double xx = 1.0 + fields.gradient_xx[i], zz = 1.0 + fields.gradient_zz[i];
    ASSERT_GE(0.5 * (xx + zz) - std::hypot(0.5 * (xx - zz), fields.gradient_xz[i]), -gate);
  }
}

// Fails if waves too short for the grid alias, or pop: at 2 samples a wavelength and fewer nothing is left,
// from 4 all, in between ever more; the finer axis alone does not hold a wave that runs along the other.
TEST_P(GerstnerSurfaceTest, WavesFadeWhereTheGridIsCoarse) {
  EXPECT_EQ(shown_share(2.0), 0.0);
  EXPECT_EQ(shown_share(3.0), 0.5);
  EXPECT_EQ(shown_share(4.0), 1.0);
  for (const double direction_rad : {0.0, 0.5 * pi, 0.6, pi, -2.0}) {
    double before = 0.0;
    for (const double samples : {1.9, 2.2, 2.7, 3.3, 3.9, 4.1, 9.0}) {
      const GerstnerSea sea{
          .waves = {{.amplitude_m = 1.0, .wavenumber_radpm = 0.5, .direction_rad = direction_rad}}};
      const double steepest = std::max(std::abs(std::cos(direction_rad)), std::abs(std::sin(direction_rad)));
      const double spacing_m = 2.0 * pi / 0.5 / steepest / samples;
      const SampleGrid grid{.spacing_x_m = spacing_m, .spacing_z_m = spacing_m, .columns = 40, .rows = 40};
      expect_waves(sea, 1.0, grid, 0.0);
      const std::vector<float> heights = fields_at(sea, grid, 0.0).displacement_y;
      const double shown = *std::max_element(heights.begin(), heights.end());
      EXPECT_GE(shown, before - gate);
      if (samples < 2.0) {
        EXPECT_EQ(shown, 0.0);
      }
      if (samples > 4.0) {
        EXPECT_NEAR(shown, 1.0, gate);
      }
      before = shown;
    }
  }
}

// Fails if vertices jitter far from the origin: on a 5 mm grid 100 km away, labels in single precision would
// be 8 mm apart, and the shortest wave's phase off by 6e-3.
TEST_P(GerstnerSurfaceTest, FarAwayIsAsSmoothAsNearBy) {
  const GerstnerSea sea = sixteen_waves(0.3);
  const SampleGrid grid{.origin_x_m = 1e5 + 0.123,
                        .origin_z_m = -1e5 - 0.77,
                        .spacing_x_m = 0.005,
                        .spacing_z_m = 0.005,
                        .columns = 300,
                        .rows = 40};
  expect_waves(sea, 0.3, grid, 54.3);
  const GerstnerFields fields = fields_at(sea, grid, 54.3);
  // Second differences of a smooth surface are (0.005 m k)^2 of its height, 2e-5 m at most; the rest is
  // jitter.
  for (std::size_t i = 2; i < 300; ++i) {
    const std::vector<float>& h = fields.displacement_y;
    ASSERT_LT(std::abs(h[i] - 2.0 * h[i - 1] + h[i - 2]), 5e-5);
  }
}

// Fails if the first frame of the next turn differs in a bit from that of this one, or if waves are moved
// further than to the nearest whole number of cycles.
TEST_P(GerstnerSurfaceTest, LoopRepeatsBitForBit) {
  GerstnerSea sea = sixteen_waves(0.3);
  sea.waves.push_back(make_swell({.amplitude_m = 0.3, .wavelength_m = 3000.0}, {}));  // period 44 s
  SampleGrid grid = usual_grid;
  grid.columns = grid.rows = 40;
  for (const double period_s : {8.0, 3.3, 125.0 / 24.0}) {
    sea.loop_period_s = period_s;
    for (const double time_s : {0.0, 1.0 / 24.0, 2.5, 77.0 / 24.0}) {
      const GerstnerFields first = fields_at(sea, grid, time_s);
      const double heights = 0.1 * 17 + 0.03 * 120 + 0.3;
      // Instants are a loop's 2^-28 apart: 2 pi 30 cycles 2^-29 = 4e-7.
      EXPECT_LT(worst_of(first.displacement_y, reference(sea, 0.3, grid, time_s).displacement_y) / heights,
                gate + 4e-7);
      for (const double turns : {1.0, 2.0, 7.0, -3.0}) {
        const GerstnerFields later = fields_at(sea, grid, time_s + turns * period_s);
        EXPECT_EQ(later.displacement_x, first.displacement_x);
        EXPECT_EQ(later.displacement_y, first.displacement_y);
        EXPECT_EQ(later.displacement_z, first.displacement_z);
        EXPECT_EQ(later.slope_x, first.slope_x);
        EXPECT_EQ(later.gradient_zz, first.gradient_zz);
      }
    }
  }
}

TEST_P(GerstnerSurfaceTest, RejectsWhatItCannotDraw) {
  const GerstnerSea sea = sixteen_waves(1.0);
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  const auto expect_rejected = [&](const SampleGrid& grid, double time_s, const std::string& name) {
    test::expect_error(ErrorKind::bad_input, name, [&] { surface_.at(sea, grid, time_s); });
  };
  expect_rejected({.columns = 0, .rows = 4}, 0.0, "sample grid columns");
  expect_rejected({.columns = 4, .rows = 20000}, 0.0, "sample grid rows");
  expect_rejected({.origin_x_m = not_a_number, .columns = 4, .rows = 4}, 0.0, "sample grid origin_m");
  expect_rejected({.spacing_z_m = not_a_number, .columns = 4, .rows = 4}, 0.0, "sample grid spacing_m");
  expect_rejected(usual_grid, not_a_number, "time_s");
  expect_rejected(usual_grid, 1e9, "time_s");
  GerstnerSea bad = sea;
  bad.waves[2].amplitude_m = not_a_number;
  test::expect_error(ErrorKind::bad_input, "gerstner.amplitude_m",
                     [&] { surface_.at(bad, usual_grid, 0.0); });
  // And it still draws what it can.
  expect_waves(sixteen_waves(0.3), 0.3, {.columns = 8, .rows = 8}, 1.0);
}

std::string shape_name(const testing::TestParamInfo<const char*>& info) {
  return info.param;
}

INSTANTIATE_TEST_SUITE_P(Shapes, GerstnerSurfaceTest, testing::Values("simd", "workgroup"), shape_name);

}  // namespace
}  // namespace offing::ocean
