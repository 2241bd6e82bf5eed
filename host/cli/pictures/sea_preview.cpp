#include "host/cli/pictures/sea_preview.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/parallel_rows.h"
#include "host/cli/pictures/foam_texture.h"
#include "host/cli/pictures/preview_light.h"
#include "host/cli/pictures/preview_raster.h"

namespace offing::cli {
namespace {

/// Side of a mesh cell on the screen, pixels: outlines are this exact, shading is done for every sample.
constexpr double mesh_cell_px = 2.0;
/// Slope of a wave's face that the spacing of mesh rows allows for.
constexpr double mesh_face_slope = 0.3;
/// Where the mesh ends: the horizon of an eye at 70 m, and by then air has taken the contrast.
constexpr double far_m = 30000.0;

double radians(double degrees) {
  return degrees * std::numbers::pi / 180.0;
}

void require(bool holds, const char* what, const char* hint) {
  if (!holds) throw Error(ErrorKind::bad_input, fmt::format("preview: {}", what), hint);
}

void check(const PreviewView& view) {
  require(view.width >= 16 && view.height >= 16 && view.width <= 8192 && view.height <= 8192,
          "the picture's size is out of range", "choose 16 to 8192 pixels a side");
  require(view.samples >= 1 && view.samples <= 4, "samples are out of range", "choose 1 to 4");
  require(view.camera_height_m > 0.0 && view.camera_height_m <= 10000.0,
          "the camera's height is out of range", "choose a height above 0 and up to 10000 m");
  require(view.pitch_deg >= -60.0 && view.pitch_deg <= 30.0, "the pitch is out of range",
          "choose -60 to 30 degrees");
  require(view.fov_deg >= 10.0 && view.fov_deg <= 120.0, "the field of view is out of range",
          "choose 10 to 120 degrees");
  require(view.sun_elevation_deg >= 1.0 && view.sun_elevation_deg <= 90.0,
          "the sun's elevation is out of range", "choose 1 to 90 degrees");
  require(view.ripple_variance >= 0.0005 && view.ripple_variance <= 1.0,
          "the ripples' slope variance is out of range",
          "choose 0.0005, where the sun is still wider than a pixel, to 1");
  require(std::isfinite(view.yaw_rad) && std::isfinite(view.sun_azimuth_rad) && std::isfinite(view.eye_x_m) &&
              std::isfinite(view.eye_z_m),
          "a direction or place is not finite", "give finite numbers");
}

/// A pinhole camera whose screen is counted in samples.
class Camera {
 public:
  explicit Camera(const PreviewView& view)
      : height_m_(static_cast<float>(view.camera_height_m)),
        width_(view.width * view.samples),
        height_(view.height * view.samples),
        sample_rad_(static_cast<float>(2.0 * std::tan(0.5 * radians(view.fov_deg)) / width_)) {
    const double yaw = view.yaw_rad, pitch = radians(view.pitch_deg);
    forward_ = {static_cast<float>(std::cos(yaw) * std::cos(pitch)), static_cast<float>(std::sin(pitch)),
                static_cast<float>(std::sin(yaw) * std::cos(pitch))};
    right_ = {static_cast<float>(-std::sin(yaw)), 0.0f, static_cast<float>(std::cos(yaw))};
    up_ = cross(right_, forward_);
  }

  int width() const { return width_; }
  int height() const { return height_; }
  /// Size of a sample, m per m of distance along the optical axis.
  float sample_rad() const { return sample_rad_; }

  /// Toward a point of the screen; 1 along the optical axis.
  Vec3 ray(float x, float y) const {
    return forward_ + (sample_rad_ * (x - 0.5f * static_cast<float>(width_))) * right_ -
           (sample_rad_ * (y - 0.5f * static_cast<float>(height_))) * up_;
  }

  /// Screen place of a point given from the foot of the eye.
  ScreenVertex project(Vec3 point) const {
    const Vec3 offset{point.x, point.y - height_m_, point.z};
    const float distance = dot(offset, forward_);
    if (distance < 0.05f) return {};
    const float scale = 1.0f / (distance * sample_rad_);
    return {0.5f * static_cast<float>(width_) + scale * dot(offset, right_),
            0.5f * static_cast<float>(height_) - scale * dot(offset, up_), 1.0f / distance, 0.0f, 0.0f};
  }

 private:
  Vec3 forward_, right_, up_;
  float height_m_;
  int width_, height_;
  float sample_rad_;
};

/// The mesh: lines across the view at growing distances, so that cells have about the same size on the
/// screen.
struct MeshRow {
  double distance_m;    ///< along the ground
  double half_width_m;  ///< to either side
  double depth_m;       ///< to the next row
};

std::vector<MeshRow> mesh_rows(const PreviewView& view, const PreviewSurface& surface) {
  const double tangent = std::tan(0.5 * radians(view.fov_deg));
  const double cell_rad = mesh_cell_px * 2.0 * tangent / view.width;
  const double shift_m = surface.largest_shift_m();
  const double crest_m = std::max(4.0 * surface.elevation_deviation_m(), 0.1);
  // The nearest water in view is a crest on the lowest ray.
  const double lowest_rad =
      std::min(std::atan(tangent * view.height / view.width) - radians(view.pitch_deg), radians(85.0));
  const double nearest_m =
      lowest_rad <= 0.0 ? 1.0
                        : std::max(0.0, view.camera_height_m - crest_m) / std::tan(lowest_rad) - shift_m;
  std::vector<MeshRow> rows;
  for (double distance_m = nearest_m; distance_m < far_m;) {
    const double slant_m = std::hypot(distance_m, std::max(view.camera_height_m - crest_m, 1.0));
    const double grazing = std::max(view.camera_height_m / slant_m, mesh_face_slope);
    const double depth_m = std::max(cell_rad * slant_m / std::min(grazing, 1.0), 1e-3);
    // The optical axis may point down: what is at this ground distance is at most `slant` along it.
    rows.push_back({distance_m, 1.1 * tangent * slant_m + shift_m + depth_m, depth_m});
    distance_m += depth_m;
  }
  return rows;
}

std::vector<RasterSample> visible_surface(const PreviewSurface& surface, const PreviewView& view,
                                          const Camera& camera, const CancelToken& cancel) {
  const std::vector<MeshRow> rows = mesh_rows(view, surface);
  const int columns = static_cast<int>(1.1 * view.width / mesh_cell_px) + 2;
  const double cos_yaw = std::cos(view.yaw_rad), sin_yaw = std::sin(view.yaw_rad);
  std::vector<ScreenVertex> vertices(rows.size() * columns);
  parallel_rows(static_cast<int>(rows.size()), [&](int row) {
    cancel.throw_if_cancelled();
    const MeshRow& line = rows[row];
    const double cell_m = 2.0 * line.half_width_m / (columns - 1);
    const float footprint_m = static_cast<float>(std::sqrt(cell_m * line.depth_m));
    for (int column = 0; column < columns; ++column) {
      const double across_m = column * cell_m - line.half_width_m;
      const double x = line.distance_m * cos_yaw - across_m * sin_yaw;
      const double z = line.distance_m * sin_yaw + across_m * cos_yaw;
      const auto [dx, dy, dz] = surface.displacement(view.eye_x_m + x, view.eye_z_m + z, footprint_m);
      const float label_x = static_cast<float>(x), label_z = static_cast<float>(z);
      ScreenVertex vertex = camera.project({label_x + dx, dy, label_z + dz});
      vertex.label_x = label_x;
      vertex.label_z = label_z;
      vertices[static_cast<std::size_t>(row) * columns + column] = vertex;
    }
  });
  return rasterise(vertices, columns, static_cast<int>(rows.size()), camera.width(), camera.height());
}

Vec3 radiance_of(const RasterSample& sample, Vec3 ray, const PreviewSurface& surface, const PreviewView& view,
                 const Camera& camera, const PreviewLight& light) {
  const float stretch = std::sqrt(dot(ray, ray));
  const Vec3 direction = (1.0f / stretch) * ray;
  if (sample.nearness <= 0.0f) {
    return light.through_air(light.sky(direction) + light.sun_disc(direction), direction, 0.0f);
  }
  const float distance_m = stretch / sample.nearness;
  // A sample covers a long strip of flat water; its geometric mean side keeps waves that the strip's width
  // shows.
  const float steepness = std::clamp(-direction.y, 0.04f, 1.0f);
  const float footprint_m = camera.sample_rad() * distance_m / std::sqrt(steepness);
  const double x_m = view.eye_x_m + sample.label_x, z_m = view.eye_z_m + sample.label_z;
  const SurfaceSample water = surface.sample(x_m, z_m, footprint_m);
  const float opacity = foam_opacity(x_m, z_m, water.foam, footprint_m);
  return light.through_air(light.sea(water, -1.0f * direction, opacity), direction, distance_m);
}

}  // namespace

RgbImage render_sea_preview(const PreviewSurface& surface, const PreviewView& view,
                            const CancelToken& cancel) {
  check(view);
  const Camera camera(view);
  const PreviewLight light(view.sun_azimuth_rad, radians(view.sun_elevation_deg), view.ripple_variance);
  const std::vector<RasterSample> samples = visible_surface(surface, view, camera, cancel);
  RgbImage image{view.width, view.height,
                 std::vector<std::uint8_t>(std::size_t{3} * view.width * view.height)};
  parallel_rows(view.height, [&](int row) {
    cancel.throw_if_cancelled();
    for (int column = 0; column < view.width; ++column) {
      Vec3 sum;
      for (int i = 0; i < view.samples * view.samples; ++i) {
        const int x = column * view.samples + i % view.samples, y = row * view.samples + i / view.samples;
        const RasterSample& sample = samples[static_cast<std::size_t>(y) * camera.width() + x];
        const Vec3 ray = camera.ray(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
        sum += radiance_of(sample, ray, surface, view, camera, light);
      }
      const Vec3 display = tone_mapped((1.0f / static_cast<float>(view.samples * view.samples)) * sum);
      std::uint8_t* const pixel =
          &image.rgb[std::size_t{3} * (static_cast<std::size_t>(row) * view.width + column)];
      pixel[0] = srgb_from_linear(display.x);
      pixel[1] = srgb_from_linear(display.y);
      pixel[2] = srgb_from_linear(display.z);
    }
  });
  return image;
}

}  // namespace offing::cli
