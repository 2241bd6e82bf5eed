#include "host/cli/pictures/preview_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace offing::cli {
namespace {

constexpr Vec3 zenith{0.04f, 0.14f, 0.42f};
constexpr Vec3 horizon{0.52f, 0.72f, 0.95f};
constexpr Vec3 glow{1.0f, 0.80f, 0.55f};            ///< of the air around the sun
constexpr Vec3 deep_water{0.006f, 0.034f, 0.052f};  ///< upwelling radiance of clear ocean under this sky
constexpr Vec3 thin_water{0.014f, 0.13f, 0.115f};   ///< light that has crossed a crest
constexpr float foam_albedo = 0.8f;

/// Normal-incidence reflectance of sea water, ((1.333 - 1) / (1.333 + 1))^2.
constexpr float reflectance_at_normal = 0.02037f;
/// Crest height at which half of the light that can cross a crest does.
constexpr float thin_crest_m = 4.0f;
/// Distance at which air takes 1 - 1/e of the contrast: a clear day at sea.
constexpr float air_length_m = 11000.0f;
/// Brighter facets than this would leave single white pixels behind.
constexpr float largest_radiance = 12.0f;

float schlick(float cosine) {
  const float rest = std::clamp(1.0f - cosine, 0.0f, 1.0f);
  return reflectance_at_normal + (1.0f - reflectance_at_normal) * rest * rest * rest * rest * rest;
}

float to_power_of_two(float value, int doublings) {
  for (int i = 0; i < doublings; ++i) value *= value;
  return value;
}

}  // namespace

PreviewLight::PreviewLight(double sun_azimuth_rad, double sun_elevation_rad, double ripple_variance)
    : ripple_variance_(static_cast<float>(ripple_variance)),
      to_sun_{static_cast<float>(std::cos(sun_azimuth_rad) * std::cos(sun_elevation_rad)),
              static_cast<float>(std::sin(sun_elevation_rad)),
              static_cast<float>(std::sin(sun_azimuth_rad) * std::cos(sun_elevation_rad))} {
  // A low sun is dimmer and redder: optical depth of blue over that of red as Rayleigh scattering has it,
  // about 4.
  const float air_mass = 1.0f / (std::max(to_sun_.y, 0.0f) + 0.05f);
  sun_irradiance_ =
      4.0f * Vec3{std::exp(-0.04f * air_mass), std::exp(-0.08f * air_mass), std::exp(-0.16f * air_mass)};
}

Vec3 PreviewLight::sky(Vec3 direction) const {
  const float height = std::max(direction.y, 0.0f);
  const Vec3 clear = mix(zenith, horizon, std::exp(-3.5f * height));
  const float toward_sun = std::max(dot(direction, to_sun_), 0.0f);
  const float wide = to_power_of_two(toward_sun, 3), narrow = to_power_of_two(toward_sun, 7);
  return clear + (0.22f * wide * std::exp(-2.0f * height) + 0.8f * narrow) * glow;
}

Vec3 PreviewLight::sun_disc(Vec3 direction) const {
  const float edge = std::cos(0.00465f * 1.5f);  // the sun's radius, a little widened by glare
  return dot(direction, to_sun_) > edge ? largest_radiance * sun_irradiance_ : Vec3{};
}

/// Mean radiance that visible facets mirror: their slopes along the line of sight are normal around the mean
/// slope, summed by three-point Gauss-Hermite quadrature, each weighed by the area it shows.
Vec3 PreviewLight::reflected(const SurfaceSample& surface, Vec3 to_eye, float& reflectance,
                             float& visible_area) const {
  const float level = std::sqrt(to_eye.x * to_eye.x + to_eye.z * to_eye.z) + 1e-6f;
  const float along_x = to_eye.x / level, along_z = to_eye.z / level;
  const float variance = along_x * along_x * surface.variance_xx +
                         2.0f * along_x * along_z * surface.variance_xz +
                         along_z * along_z * surface.variance_zz + ripple_variance_;
  const float node = std::sqrt(3.0f * variance);
  constexpr std::array<std::array<float, 2>, 3> rule{
      {{-1.0f, 1.0f / 6.0f}, {0.0f, 2.0f / 3.0f}, {1.0f, 1.0f / 6.0f}}};
  Vec3 sum;
  reflectance = 0.0f;
  visible_area = 1e-4f;
  for (const auto& [place, weight] : rule) {
    const Vec3 facet{-surface.slope_x - place * node * along_x, 1.0f,
                     -surface.slope_z - place * node * along_z};
    const float area = weight * dot(facet, to_eye);
    if (area <= 0.0f) continue;
    const Vec3 normal = normalized(facet);
    const float cosine = dot(normal, to_eye);
    Vec3 mirrored = 2.0f * cosine * normal - to_eye;
    mirrored.y =
        std::abs(mirrored.y);  // a ray that goes down meets another wave, which mirrors the sky in turn
    const float share = area * schlick(cosine);
    sum += share * sky(mirrored);
    reflectance += share;
    visible_area += area;
  }
  reflectance /= visible_area;
  return (1.0f / visible_area) * sum;
}

/// Mirror images of the sun (Cox & Munk 1954): density of the slope that mirrors it, over the visible area.
Vec3 PreviewLight::glitter(const SurfaceSample& surface, Vec3 to_eye, float visible_area) const {
  const Vec3 half = normalized(to_eye + to_sun_);
  if (half.y <= 0.05f) return {};
  const float off_x = -half.x / half.y - surface.slope_x, off_z = -half.z / half.y - surface.slope_z;
  const float xx = surface.variance_xx + ripple_variance_, zz = surface.variance_zz + ripple_variance_;
  const float xz = surface.variance_xz;
  const float determinant = std::max(xx * zz - xz * xz, 1e-8f);
  const float exponent =
      0.5f * (zz * off_x * off_x - 2.0f * xz * off_x * off_z + xx * off_z * off_z) / determinant;
  const float density = std::exp(-exponent) / (2.0f * std::numbers::pi_v<float> * std::sqrt(determinant));
  const float strength = schlick(dot(half, to_eye)) * density /
                         (4.0f * half.y * half.y * half.y * half.y * std::max(visible_area, 0.05f));
  return strength * sun_irradiance_;
}

Vec3 PreviewLight::sea(const SurfaceSample& surface, Vec3 to_eye, float foam_opacity) const {
  float reflectance = 0.0f, visible_area = 0.0f;
  Vec3 water = reflected(surface, to_eye, reflectance, visible_area);
  water += glitter(surface, to_eye, visible_area);

  // Sun behind a crest shines through it toward the eye, the more the higher and steeper the crest is.
  const Vec3 normal = normalized({-surface.slope_x, 1.0f, -surface.slope_z});
  const float height_m = std::max(surface.displacement_y, 0.0f);
  const float against_sun = std::max(0.0f, -(to_eye.x * to_sun_.x + to_eye.z * to_sun_.z));
  const float facing = std::max(0.0f, dot(normal, to_eye));
  const float through = height_m * height_m / (height_m * height_m + thin_crest_m * thin_crest_m) *
                        (0.25f + 0.75f * against_sun * against_sun) * facing;
  water += (1.0f - reflectance) * (deep_water + through * (sun_irradiance_ * thin_water));

  const float lambert = std::max(0.0f, dot(normal, to_sun_)) / std::numbers::pi_v<float>;
  const Vec3 foam = foam_albedo * (lambert * sun_irradiance_ + 0.9f * mix(zenith, horizon, 0.6f));
  const Vec3 radiance = mix(water, foam, foam_opacity);
  return {std::min(radiance.x, largest_radiance), std::min(radiance.y, largest_radiance),
          std::min(radiance.z, largest_radiance)};
}

Vec3 PreviewLight::through_air(Vec3 radiance, Vec3 direction, float distance_m) const {
  const Vec3 level = normalized({direction.x, 0.0f, direction.z});
  return mix(sky(level), radiance, std::exp(-distance_m / air_length_m));
}

Vec3 tone_mapped(Vec3 radiance) {
  const auto curve = [](float x) {
    x *= 0.6f;  // exposure: the horizon sky lands at about 0.8 of display white
    return std::clamp(x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f), 0.0f, 1.0f);
  };
  return {curve(radiance.x), curve(radiance.y), curve(radiance.z)};
}

}  // namespace offing::cli
