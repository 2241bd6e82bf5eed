// Shows the C++ class Ocean: samples a sea at many places and times, compares what it finds with the sea's
// spectrum, and writes a height map.
//
// Build: see README.md beside this file. Use: sea_state [SCENE.toml [MAP.exr]]
#include <cmath>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

#include "host/base/error.h"
#include "host/io/exr_image.h"
#include "host/ocean/spectrum/sea_spectrum.h"
#include "host/ocean/surface/ocean.h"
#include "host/ocl/device.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/prepare/sea.h"

namespace {

namespace ocean = offing::ocean;
namespace scene = offing::scene;

constexpr const char* wind_sea = "version = 1\n[wind]\nspeed_mps = 10\n[ocean]\nsize = 256\n";

/// Wave probes, 8 x 8, 137 m apart along x and 83 m along z.
std::vector<ocean::WaterPoint> probes() {
  std::vector<ocean::WaterPoint> points;
  for (int row = 0; row < 8; ++row) {
    for (int column = 0; column < 8; ++column) points.push_back({137.0 * column, 83.0 * row});
  }
  return points;
}

struct Record {
  double hs_m = 0.0;           ///< 4 sqrt(variance)
  double mean_period_s = 0.0;  ///< between upward crossings of sea level
};

/// What the probes measure in five minutes, four times a second.
Record record(ocean::Ocean& sea) {
  constexpr int instants = 1200;
  constexpr double step_s = 0.25;
  const std::vector<ocean::WaterPoint> points = probes();
  const ocean::WaterQuery query{.fields = ocean::WaterQuery::Fields::surface};
  std::vector<ocean::WaterSample> before, now(points.size());
  double sum_of_squares = 0.0;
  int crossings = 0;
  for (int instant = 0; instant < instants; ++instant) {
    sea.at(step_s * instant);
    sea.sample(points, now, query);
    for (std::size_t i = 0; i < points.size(); ++i) {
      sum_of_squares += static_cast<double>(now[i].height_m) * now[i].height_m;
      if (instant > 0 && before[i].height_m < 0.0f && now[i].height_m >= 0.0f) ++crossings;
    }
    before = now;
  }
  const auto count = static_cast<double>(points.size());
  return {4.0 * std::sqrt(sum_of_squares / (count * instants)),
          crossings == 0 ? 0.0 : count * (instants - 1) * step_s / crossings};
}

/// Heights of 512 m x 512 m at 1 m, one EXR channel, rows along z.
void write_map(const std::string& file, ocean::Ocean& sea) {
  const ocean::SampleGrid grid{.columns = 512, .rows = 512};
  const ocean::ComposedFields fields = sea.read_composed(grid);
  const offing::ExrImage image{.width = grid.columns,
                               .height = grid.rows,
                               .channels = {{"height", fields.displacement_y}},
                               .attributes = {{"spacing_m", grid.spacing_x_m}}};
  offing::write_exr(file, image, offing::PixelType::float_32, offing::ExrCompression::zip);
  std::printf("map: %s\n", file.c_str());
}

}  // namespace

int main(int argc, char** argv) try {
  const std::span<char*> arguments(argv, static_cast<std::size_t>(argc));
  const scene::Sea prepared = scene::prepare_sea(
      arguments.size() > 1 ? scene::load_scene(arguments[1]) : scene::parse_scene(wind_sea, "wind_sea", ""));
  const offing::ocl::Device device = offing::ocl::Device::open();
  ocean::Ocean sea(device, prepared.spectrum, prepared.parameters);

  const ocean::SeaState asked = ocean::integrate_sea_state(prepared.spectrum);
  const Record found = record(sea);
  std::printf("device: %s\n", device.info().name.c_str());
  std::printf("spectrum: Hs %.2f m, Tm02 %.2f s\n", asked.hs_m, asked.tm02_s);
  std::printf("probes: Hs %.2f m, mean period %.2f s\n", found.hs_m, found.mean_period_s);
  if (arguments.size() > 2) write_map(arguments[2], sea);
  return 0;
} catch (const offing::Error& error) {
  std::fprintf(stderr, "error: %s\nhint: %s\n", error.what(), error.hint().c_str());
  return offing::exit_code(error.kind());
}
