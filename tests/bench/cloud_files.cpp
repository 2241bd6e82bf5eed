// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>

#include <fmt/format.h>

#include "host/clouds/shape/cloud_density.h"
#include "host/io/vdb/vdb_volume.h"
#include "tests/bench/benches.h"
#include "tests/bench/measure.h"

namespace offing::bench {
namespace {

using clouds::CloudParameters;

constexpr int cells = 512, ball_count = 3000;

/// Balls of 10 to 40 m all over a cube of so many metres, frayed by five octaves of noise: nearly all of it
/// has density.
CloudParameters crowd() {
  CloudParameters parameters;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int i = 0; i < ball_count; ++i) {
    const double radius_m = 10.0 + 30.0 * uniform(random);
    const auto place_m = [&] { return radius_m + (cells - 1.0 - 2.0 * radius_m) * uniform(random); };
    const double x_m = place_m(), y_m = place_m(), z_m = place_m();
    parameters.balls.push_back({{x_m, y_m, z_m}, radius_m, 1.0});
  }
  parameters.turbulence.wavelength_m = 100.0;
  return parameters;
}

/// Forgets how much memory this process had at most; where the system does not let it, that stays counted.
void forget_peak() {
  std::ofstream("/proc/self/clear_refs") << 5;
}

/// "1.2 GB", or what is not known.
std::string peak_memory() {
  std::ifstream status("/proc/self/status");
  double kilobytes = 0.0;
  for (std::string line; std::getline(status, line);) {
    if (std::sscanf(line.c_str(), "VmHWM: %lf", &kilobytes) == 1)
      return fmt::format("{:.2f} GB", kilobytes / 1e6);
  }
  return "memory not told";
}

}  // namespace

void bench_cloud_files(const ocl::Device& device, const Sinks& sinks) {
  const CloudParameters parameters = crowd();
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "offing-bench-clouds.vdb";
  clouds::field_volume(device, parameters, 64.0, 0.0);  // compiles
  std::vector<double> times_ms, density_ms;
  double file_bytes = 0.0;
  forget_peak();
  for (int run = 0; run < 3; ++run) {
    VdbCloud cloud;
    density_ms.push_back(once_ms([&] { cloud.volume = clouds::field_volume(device, parameters, 1.0, 0.0); }));
    times_ms.push_back(density_ms.back() + once_ms([&] { write_vdb(file, cloud); }));
    file_bytes = static_cast<double>(std::filesystem::file_size(file));
    std::filesystem::remove(file);  // else the next run pays for freeing it
  }
  sinks.row({.name = "clouds_vdb_512",
             .size = ball_count,
             .ours_ms = median(times_ms),
             .peer = fmt::format("none; {:.2f} s, of which density {:.2f} s; {} at most; file {:.2f} GB",
                                 1e-3 * median(times_ms), 1e-3 * median(density_ms), peak_memory(),
                                 1e-9 * file_bytes),
             .spread = relative_spread(times_ms)});
}

}  // namespace offing::bench
