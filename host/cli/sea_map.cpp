#include "host/cli/sea_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "host/base/error.h"
#include "host/cli/foam_texture.h"
#include "host/cli/parallel_rows.h"
#include "host/cli/vector3.h"

namespace offing::cli {
namespace {

constexpr Vec3 to_light{-0.5f, 0.707f, -0.5f};
constexpr std::array<Vec3, 5> elevation_colours{{{0.004f, 0.012f, 0.06f},
                                                 {0.01f, 0.06f, 0.20f},
                                                 {0.03f, 0.22f, 0.36f},
                                                 {0.20f, 0.50f, 0.50f},
                                                 {0.50f, 0.74f, 0.62f}}};
constexpr float shown_deviations = 2.5f;

Vec3 elevation_colour(float deviations) {
  const float place = std::clamp((deviations / shown_deviations + 1.0f) * 2.0f, 0.0f, 3.999f);
  const std::size_t index = static_cast<std::size_t>(place);
  return mix(elevation_colours[index], elevation_colours[index + 1], place - static_cast<float>(index));
}

/// Label of the water that stands over x, z: the fixed point of label = place - displacement(label), which
/// the iteration approaches wherever the surface does not fold.
std::array<double, 2> label_at(const PreviewSurface& surface, double x_m, double z_m, float footprint_m) {
  std::array<double, 2> label{x_m, z_m};
  for (int i = 0; i < 6; ++i) {
    const auto [dx, dy, dz] = surface.displacement(label[0], label[1], footprint_m);
    label = {0.5 * (label[0] + x_m - dx),
             0.5 * (label[1] + z_m - dz)};  // damped: steep crests would oscillate
  }
  return label;
}

Vec3 colour_at(const PreviewSurface& surface, double x_m, double z_m, float footprint_m, float deviation_m) {
  const auto [label_x, label_z] = label_at(surface, x_m, z_m, footprint_m);
  const SurfaceSample sample = surface.sample(label_x, label_z, footprint_m);
  const float lambert = std::max(0.0f, dot(normalized({-sample.slope_x, 1.0f, -sample.slope_z}), to_light));
  const float flat = to_light.y;
  const Vec3 water = (lambert / flat) * elevation_colour(sample.displacement_y / deviation_m);
  return mix(water, {0.95f, 0.95f, 0.95f}, foam_opacity(label_x, label_z, sample.foam, footprint_m));
}

}  // namespace

RgbImage render_sea_map(const PreviewSurface& surface, const MapView& view) {
  if (view.width < 16 || view.height < 16 || view.width > 8192 || view.height > 8192 ||
      !(view.width_m > 0.0) || !std::isfinite(view.width_m) || !std::isfinite(view.center_x_m) ||
      !std::isfinite(view.center_z_m)) {
    throw Error(ErrorKind::bad_input, "map: size or place is out of range",
                "choose 16 to 8192 pixels a side and a finite width above 0 m");
  }
  const double pixel_m = view.width_m / view.width;
  const float deviation_m = std::max(surface.elevation_deviation_m(), 1e-6f);
  RgbImage image{view.width, view.height,
                 std::vector<std::uint8_t>(std::size_t{3} * view.width * view.height)};
  parallel_rows(view.height, [&](int row) {
    for (int column = 0; column < view.width; ++column) {
      const double x_m = view.center_x_m + (column + 0.5 - 0.5 * view.width) * pixel_m;
      const double z_m = view.center_z_m + (row + 0.5 - 0.5 * view.height) * pixel_m;
      const Vec3 colour = colour_at(surface, x_m, z_m, static_cast<float>(pixel_m), deviation_m);
      std::uint8_t* const pixel =
          &image.rgb[std::size_t{3} * (static_cast<std::size_t>(row) * view.width + column)];
      pixel[0] = srgb_from_linear(colour.x);
      pixel[1] = srgb_from_linear(colour.y);
      pixel[2] = srgb_from_linear(colour.z);
    }
  });
  return image;
}

}  // namespace offing::cli
