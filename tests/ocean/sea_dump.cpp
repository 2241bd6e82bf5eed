// sea_dump SIZE FILE: a sea of two cascades through every kernel of the ocean and the transform, on the
// device that the environment names. FILE: the displacement in Hs (dx, h, dz) of each cascade, then all other
// results in units of their own size, as floats.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>

#include "host/base/error.h"
#include "host/fft/fft2d.h"
#include "host/ocean/spectrum/spectrum_parameters.h"
#include "host/ocean/surface/cascades.h"
#include "host/ocean/surface/ocean.h"
#include "tests/ocean/surface/field_statistics.h"

namespace {

using namespace offing;

class Dump {
 public:
  explicit Dump(const char* path) : file_(path, std::ios::binary) {}
  /// Appends values / scale.
  void add(std::vector<float> values, double scale) {
    for (float& value : values) value = static_cast<float>(value / scale);
    file_.write(reinterpret_cast<const char*>(values.data()),
                static_cast<std::streamsize>(values.size() * sizeof(float)));
  }
  /// Appends values over their root mean square.
  void add_relative(const std::vector<float>& values) { add(values, std::sqrt(ocean::mean_square(values))); }

 private:
  std::ofstream file_;
};

// 40 points fill the last vector of the device in part.
void dump_samples(ocean::Ocean& sea, Dump& dump) {
  std::vector<ocean::WaterPoint> points;
  for (int i = 0; i < 40; ++i) points.push_back({7.3 * i - 1e5, 13.1 * i});
  for (const ocean::WaterQuery& query : {ocean::WaterQuery{.depth_m = 0.5, .tolerance_m = 1e-5},
                                         {.min_wavelength_m = 12.0, .tolerance_m = 1e-5}}) {
    std::vector<float> heights, slopes, velocities, pressures;
    for (const ocean::WaterSample& sample : sea.sample(points, query)) {
      heights.push_back(sample.height_m);
      slopes.push_back(sample.slope_x);
      velocities.push_back(sample.velocity_y_mps);
      pressures.push_back(1e4f + sample.pressure_pa);  // 0 at the surface, but for rounding
    }
    for (const auto& field : {heights, slopes, velocities, pressures}) dump.add_relative(field);
  }
}

std::vector<ocean::GerstnerWave> two_swells() {
  return {ocean::make_swell({.wavelength_m = 70.0, .direction_rad = 0.4}, {}),
          ocean::make_swell({.wavelength_m = 31.0, .direction_rad = 2.0}, {})};
}

void dump_surface(ocean::Ocean& sea, double hs_m, Dump& dump) {
  for (const int cascade : {0, 1}) {
    const ocean::SurfaceFields surface = sea.read_surface(cascade);
    for (const auto& field : {surface.displacement_x, surface.displacement_y, surface.displacement_z})
      dump.add(field, hs_m);
  }
  for (const int cascade : {0, 1}) {
    const ocean::SurfaceFields surface = sea.read_surface(cascade);
    for (const auto& field : {surface.slope_x, surface.slope_z, surface.gradient_xx, surface.gradient_xz,
                              surface.gradient_zz, surface.jacobian, surface.jacobian_min_eigenvalue})
      dump.add_relative(field);
    const ocean::VelocityFields velocity = sea.read_velocity(cascade, 0.3);
    for (const auto& field : {velocity.x, velocity.y, velocity.z}) dump.add_relative(field);
    dump.add(sea.read_foam(cascade), 1.0);
  }
  const ocean::SampleGrid grid{.origin_x_m = -3.0, .spacing_x_m = 0.7, .columns = 20, .rows = 10};
  const ocean::GerstnerSea gerstner_waves{
      .waves = two_swells(), .raindrops = {{.time_s = 12.0, .amplitude_m = 0.2, .wavelength_m = 5.0}}};
  for (const ocean::GerstnerSea& waves : {ocean::GerstnerSea{}, gerstner_waves}) {
    sea.set_gerstner_waves(waves);
    const ocean::ComposedFields composed = sea.read_composed(grid);
    for (const auto& field : {composed.displacement_y, composed.slope_x, composed.jacobian})
      dump.add_relative(field);
    dump_samples(sea, dump);
  }
}

void dump_transforms(const ocl::Device& device, int size, Dump& dump) {
  for (const fft::Direction direction : {fft::Direction::forward, fft::Direction::inverse}) {
    fft::Fft2d transform(device, size, 2, direction);
    std::vector<float> values(transform.float_count());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i * 7919 % 101) - 50.0f;
    ocl::Buffer<float> buffer(device, values, "values");
    transform.transform(buffer, buffer);
    dump.add_relative(buffer.read());
  }
}

// Hulls and rain on a window that scrolls, by both methods, then as a layer of the sea.
void dump_wakes(const ocl::Device& device, int size, ocean::Ocean& sea, Dump& dump) {
  std::vector<ocean::WakeWindow> windows;
  for (const ocean::WakeMethod method : {ocean::WakeMethod::dispersive, ocean::WakeMethod::verlet}) {
    ocean::WakeWindow& window =
        windows.emplace_back(device, ocean::WakeParameters{.method = method,
                                                           .cells = size,
                                                           .length_m = 20.0,
                                                           .step_s = 0.05,
                                                           .rain = {.drops_per_m2s = 0.1}});
    window.reset(0.0, {});
    window.advance_to(0.4, [](double time_s) {
      return ocean::WakeForcing{.centre = {4.0 * time_s, -2.0 * time_s},
                                .hulls = {{.x_m = 2.0, .heading_rad = 0.5, .length_m = 8.0}}};
    });
    const ocean::WakeState state = window.read_state();
    for (const auto& field : {state.height_m, state.second_m}) dump.add_relative(field);
    const ocean::WakeFields fields = window.read(0.42);
    for (const auto& field : {fields.height_m, fields.slope_x, fields.slope_z, fields.rise_mps})
      dump.add_relative(field);
  }
  auto maps = std::make_shared<ocean::WakeMaps>(device);
  maps->at(windows, 0.42);
  sea.set_wakes(maps);
  const ocean::ComposedFields composed = sea.read_composed({.origin_x_m = -12.0,
                                                            .origin_z_m = -6.0,
                                                            .spacing_x_m = 1.3,
                                                            .spacing_z_m = 0.9,
                                                            .columns = 20,
                                                            .rows = 10});
  dump.add_relative(composed.displacement_y);
  std::vector<float> heights;
  for (int i = 0; i < 40; ++i) {
    const std::vector<ocean::WaterPoint> point{{0.5 * i - 10.0, 0.3 * i - 6.0}};
    heights.push_back(sea.sample(point, {.tolerance_m = 1e-5}).front().height_m);
  }
  dump.add_relative(heights);
}

// A beach with land, shallows and deep water: 12 x 9 posts, none of them where a query looks.
void dump_shoals(const ocl::Device& device, const ocean::SeaSpectrum& spectrum, ocean::Ocean& sea,
                 Dump& dump) {
  auto depths = std::make_shared<ocean::DepthMap>();
  depths->columns = 12, depths->rows = 9;
  depths->origin_x_m = -1e5 - 31.0, depths->origin_z_m = 5.0;
  depths->spacing_x_m = 21.0, depths->spacing_z_m = 50.0;
  for (int i = 0; i < 12 * 9; ++i)
    depths->depths_m.push_back(static_cast<float>(-1.0 + 0.8 * (i % 12) + 0.1 * i / 12));
  sea.set_gerstner_waves({.waves = two_swells()});
  std::vector<ocean::ShoalingBand> cascades;
  for (int i = 0; i < 2; ++i) {
    const ocean::OceanParameters& parameters = sea.parameters();
    cascades.push_back(ocean::band_of_modes(sea.mode_variance(i), parameters.size,
                                            parameters.cascades[static_cast<std::size_t>(i)].patch_length_m));
  }
  const ocean::ShoalTable table(spectrum.dispersion, ocean::shoaling_bands(cascades, two_swells()));
  sea.set_shoals(std::make_shared<const ocean::Shoals>(device, depths, table));
  dump_samples(sea, dump);
}

void dump_all(int size, const char* path) {
  const ocl::Device device = ocl::Device::open();
  std::printf("%s, %s\n", device.info().name.c_str(), device.info().platform.c_str());
  ocean::SpectrumParameters parameters;
  parameters.dispersion.depth_m = 10.0;
  const ocean::SeaSpectrum spectrum = ocean::make_sea_spectrum(parameters);
  ocean::Ocean sea(device, spectrum,
                   {.size = size,
                    .cascades = ocean::cascades_from_patches(std::vector{110.0, 17.0}, size),
                    .foam = {.onset_jacobian = 1.0, .decay_s = 0.5, .step_s = 0.5}});
  sea.at(12.3);
  Dump dump(path);
  dump_surface(sea, ocean::integrate_sea_state(spectrum).hs_m, dump);
  dump_transforms(device, size, dump);
  dump_shoals(device, spectrum, sea, dump);
  sea.set_shoals(nullptr);
  sea.set_gerstner_waves({});
  dump_wakes(device, size, sea, dump);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: sea_dump SIZE FILE\n", stderr);
    return EXIT_FAILURE;
  }
  try {
    dump_all(std::atoi(argv[1]), argv[2]);
  } catch (const offing::Error& error) {
    std::fprintf(stderr, "error: %s\nhint: %s\n", error.what(), error.hint().c_str());
    return offing::exit_code(error.kind());
  }
}
