// The angles of wakes: Kelvin's of water waves, Mach's of waves of one speed.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "host/ocean/wakes/wake_window.h"

namespace offing::ocean {
namespace {

using std::numbers::pi;

struct Place {
  double behind_m, aside_m;
};

// A small hull, a bell down to 1/e within an eighth of `wavelength_m`, straight ahead along +x for `time_s`,
// a quarter of the window before its middle; it grows while it covers its first two wavelengths.
struct Course {
  double speed_mps, wavelength_m, time_s;
};

WakeState wake_of(WakeWindow& window, const Course& course) {
  const double ahead_m = 0.34 * window.parameters().length_m;
  const WakeWindow::ForcingAt forcing_at = [&](double time_s) {
    const double x_m = course.speed_mps * time_s;
    const double grown = std::min(1.0, x_m / (2.0 * course.wavelength_m));
    return WakeForcing{.centre = {x_m - ahead_m, 0.0},
                       .hulls = {{.shape = WakeHull::Shape::gaussian,
                                  .x_m = x_m,
                                  .length_m = course.wavelength_m / 8.0,
                                  .beam_m = course.wavelength_m / 8.0,
                                  .draught_m = 0.1 * grown * grown * (3.0 - 2.0 * grown)}}};
  };
  window.reset(0.0, forcing_at(0.0).centre);
  window.advance_to(course.time_s, forcing_at);
  return window.read_state();
}

// Convolution of rows, then of columns, with a bell of this standard deviation.
std::vector<double> smoothed(const std::vector<float>& field, int n, double deviation_cells) {
  const int reach = static_cast<int>(4.0 * deviation_cells);
  std::vector<double> weights, rows(field.size()), result(field.size());
  for (int i = -reach; i <= reach; ++i) {
    weights.push_back(std::exp(-0.5 * i * i / (deviation_cells * deviation_cells)));
  }
  const auto at = [&](int row, int column) {
    return static_cast<std::size_t>(((row + n) % n) * n + (column + n) % n);
  };
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) {
      for (int i = -reach; i <= reach; ++i) {
        rows[at(row, column)] += weights[static_cast<std::size_t>(i + reach)] * field[at(row, column + i)];
      }
    }
  }
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) {
      for (int i = -reach; i <= reach; ++i) {
        result[at(row, column)] += weights[static_cast<std::size_t>(i + reach)] * rows[at(row + i, column)];
      }
    }
  }
  return result;
}

// The outermost maximum of a profile that is at least half of its highest.
double outermost_peak(const std::vector<double>& profile) {
  const double most = *std::max_element(profile.begin(), profile.end());
  for (std::size_t i = profile.size() - 2; i > 0; --i) {
    const double a = profile[i - 1], b = profile[i], c = profile[i + 1];
    if (b >= a && b >= c && b > 0.5 * most) {
      return static_cast<double>(i) + (a == c ? 0.0 : 0.5 * (a - c) / (a - 2.0 * b + c));
    }
  }
  return 0.0;
}

// The angle of the line through the outermost peaks on either side, between two distances behind the hull.
double fitted_angle_deg(const std::vector<double>& envelope, const WakeWindow& window, double hull_m,
                        double from_m, double to_m) {
  const int n = window.parameters().cells;
  const double cell_m = window.parameters().cell_m();
  std::vector<Place> places;
  for (double behind_m = from_m; behind_m <= to_m; behind_m += cell_m) {
    const int column =
        static_cast<int>(std::lround((hull_m - behind_m) / cell_m)) - window.grid().first_column;
    for (const int side : {-1, 1}) {
      std::vector<double> profile;
      for (int j = 0; j < 3 * n / 8; ++j) {
        const int row = side * j - window.grid().first_row;
        profile.push_back(envelope[static_cast<std::size_t>(row * n + column)]);
      }
      places.push_back({behind_m, outermost_peak(profile) * cell_m});
    }
  }
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const Place& place : places) {
    x += place.behind_m, y += place.aside_m;
    xx += place.behind_m * place.behind_m, xy += place.behind_m * place.aside_m;
  }
  const auto count = static_cast<double>(places.size());
  return std::atan((xy * count - x * y) / (xx * count - x * x)) * 180.0 / pi;
}

// Fails if the wake is not that of water: its cusps lie on a line at asin(1/3) = 19.47 degrees (Kelvin 1887).
// The wavelengths are 16 and 22 cells. The envelope is that of the waves that meet at the
// cusp, of two thirds of the wavelength: those much shorter, which fill the inside, are smoothed away by a
// bell of a tenth of it.
TEST(KelvinWakeTest, CuspsStandAtKelvinsAngle) {
  const ocl::Device device = ocl::Device::open();
  for (const double wavelength_m : {16.0, 22.0}) {
    const double speed_mps = std::sqrt(9.81 * wavelength_m / (2.0 * pi));
    WakeWindow window(device, {.cells = 256, .length_m = 256.0, .step_s = 0.08});
    // Cusp waves fall behind at two thirds of the speed at least.
    const double time_s = std::floor(14.0 * wavelength_m / speed_mps / 0.08) * 0.08;
    const WakeState state =
        wake_of(window, {.speed_mps = speed_mps, .wavelength_m = wavelength_m, .time_s = time_s});
    const std::vector<double> height = smoothed(state.height_m, 256, 0.1 * wavelength_m);
    const std::vector<double> second = smoothed(state.second_m, 256, 0.1 * wavelength_m);
    std::vector<double> envelope;
    for (std::size_t i = 0; i < height.size(); ++i) envelope.push_back(std::hypot(height[i], second[i]));
    const double angle_deg =
        fitted_angle_deg(envelope, window, speed_mps * time_s, 3.0 * wavelength_m, 8.0 * wavelength_m);
    RecordProperty("degrees_at_" + std::to_string(wavelength_m), std::to_string(angle_deg));
    EXPECT_NEAR(angle_deg, 19.47, 1.5) << wavelength_m;
  }
}

// Fails if waves of `verlet` have another speed than the one asked for: their front behind a hull at speed V
// is at asin(c / V).
TEST(KelvinWakeTest, WavesOfOneSpeedStandAtMachsAngle) {
  const ocl::Device device = ocl::Device::open();
  for (const double mach : {1.5, 2.0, 3.0}) {
    const double speed_mps = 5.0 * mach, wavelength_m = 32.0;
    WakeWindow window(
        device,
        {.method = WakeMethod::verlet, .cells = 256, .length_m = 256.0, .step_s = 0.1, .speed_mps = 5.0});
    const double time_s = std::floor(240.0 / speed_mps / 0.1) * 0.1;
    const WakeState state =
        wake_of(window, {.speed_mps = speed_mps, .wavelength_m = wavelength_m, .time_s = time_s});
    std::vector<double> envelope;
    for (const float height_m : state.height_m) envelope.push_back(std::abs(height_m));
    const double angle_deg = fitted_angle_deg(envelope, window, speed_mps * time_s, 30.0, 90.0);
    RecordProperty("degrees_at_" + std::to_string(mach), std::to_string(angle_deg));
    EXPECT_NEAR(angle_deg, std::asin(1.0 / mach) * 180.0 / pi, 2.0) << mach;
  }
}

}  // namespace
}  // namespace offing::ocean
