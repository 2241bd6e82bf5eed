#include "host/cli/pictures/preview_surface.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <utility>

#include "host/base/error.h"
#include "host/ocean/trochoid_surface.h"

namespace offing::cli {
namespace {

constexpr int largest_level_size = 1024;  // 64 B a texel: 64 MiB

/// Below this Jacobian the surface folds and its slope is no longer a number; breaking water is drawn as
/// steep as here.
constexpr float least_jacobian = 0.2f;

void check(const PreviewCascade& cascade) {
  const ocean::SurfaceFields* surface = cascade.surface;
  const bool has_size =
      surface != nullptr && surface->size >= 2 && std::has_single_bit(static_cast<unsigned>(surface->size));
  const std::size_t values = has_size ? static_cast<std::size_t>(surface->size) * surface->size : 0;
  const auto fits = [&](const std::vector<float>& field) { return field.size() == values; };
  if (!has_size || !(cascade.patch_length_m > 0.0) || !fits(surface->displacement_x) ||
      !fits(surface->displacement_y) || !fits(surface->displacement_z) || !fits(surface->slope_x) ||
      !fits(surface->slope_z) || !fits(surface->gradient_xx) || !fits(surface->gradient_xz) ||
      !fits(surface->gradient_zz) || (!cascade.foam.empty() && cascade.foam.size() != values)) {
    throw Error(ErrorKind::bad_input, "preview: a cascade's fields do not match its size",
                "pass what Ocean::read_surface() and read_foam() return");
  }
}

/// E max(0, a - J) for J normal with this mean and deviation.
float expected_excess(float a, float mean, float deviation) {
  const float z = (a - mean) / deviation;
  const float density = std::exp(-0.5f * z * z) / std::sqrt(2.0f * std::numbers::pi_v<float>);
  const float distribution = 0.5f * std::erfc(-z / std::numbers::sqrt2_v<float>);
  return (a - mean) * distribution + deviation * density;
}

}  // namespace

PreviewSurface::PreviewSurface(std::span<const PreviewCascade> cascades, const ocean::FoamParameters& foam,
                               const ocean::TrochoidInstant& trochoids)
    : trochoids_(trochoids), foam_(foam) {
  if (cascades.empty())
    throw Error(ErrorKind::bad_input, "preview: no cascade to draw", "pass at least one cascade");
  double variance_m2 = 0.0;
  for (const PreviewCascade& cascade : cascades) {
    check(cascade);
    const ocean::SurfaceFields& surface = *cascade.surface;
    Pyramid pyramid{cascade.patch_length_m / surface.size, {finest_level(cascade)}};
    while (pyramid.levels.back().size > 1) pyramid.levels.push_back(coarser_level(pyramid.levels.back()));
    pyramids_.push_back(std::move(pyramid));
    float shift_m = 0.0f;
    double square_m2 = 0.0;
    for (std::size_t i = 0; i < surface.displacement_y.size(); ++i) {
      shift_m = std::max(shift_m, std::hypot(surface.displacement_x[i], surface.displacement_z[i]));
      square_m2 += double{surface.displacement_y[i]} * surface.displacement_y[i];
    }
    largest_shift_m_ += shift_m;
    variance_m2 += square_m2 / static_cast<double>(surface.displacement_y.size());
  }
  for (const ocean::TrochoidInstant::Wave& wave : trochoids_.waves()) {
    largest_shift_m_ += static_cast<float>(trochoids_.horizontal_scale() * wave.amplitude_m);
    variance_m2 += 0.5 * wave.amplitude_m * wave.amplitude_m;
  }
  elevation_deviation_m_ = static_cast<float>(std::sqrt(variance_m2));
}

/// A texel over count x count samples.
PreviewSurface::Texel PreviewSurface::mean_of(const PreviewCascade& cascade, int first_column, int first_row,
                                              int count) {
  const ocean::SurfaceFields& surface = *cascade.surface;
  Texel mean{};
  float xx = 0.0f, xz = 0.0f, zz = 0.0f, trace_trace = 0.0f;
  for (int row = first_row; row < first_row + count; ++row) {
    for (int column = first_column; column < first_column + count; ++column) {
      const std::size_t i = static_cast<std::size_t>(row) * surface.size + column;
      const Texel one{surface.displacement_x[i], surface.displacement_y[i], surface.displacement_z[i],
                      surface.slope_x[i],        surface.slope_z[i],        surface.gradient_xx[i],
                      surface.gradient_xz[i],    surface.gradient_zz[i]};
      for (int q = dx; q <= gzz; ++q) mean[q] += one[q];
      if (!cascade.foam.empty()) mean[foam_mean] += cascade.foam[i];
      xx += one[sx] * one[sx];
      xz += one[sx] * one[sz];
      zz += one[sz] * one[sz];
      trace_trace += (one[gxx] + one[gzz]) * (one[gxx] + one[gzz]);
    }
  }
  const float share = 1.0f / static_cast<float>(count * count);
  for (float& value : mean) value *= share;
  if (count > 1) {  // one sample hides nothing, whatever rounding says
    const float trace = mean[gxx] + mean[gzz];
    mean[var_xx] = std::max(share * xx - mean[sx] * mean[sx], 0.0f);
    mean[var_xz] = share * xz - mean[sx] * mean[sz];
    mean[var_zz] = std::max(share * zz - mean[sz] * mean[sz], 0.0f);
    mean[var_trace] = std::max(share * trace_trace - trace * trace, 0.0f);
  }
  return mean;
}

PreviewSurface::Level PreviewSurface::finest_level(const PreviewCascade& cascade) {
  const int scale = std::max(1, cascade.surface->size / largest_level_size);
  Level level{cascade.surface->size / scale, scale, {}};
  level.texels.reserve(static_cast<std::size_t>(level.size) * level.size);
  for (int row = 0; row < level.size; ++row) {
    for (int column = 0; column < level.size; ++column) {
      level.texels.push_back(mean_of(cascade, column * scale, row * scale, scale));
    }
  }
  return level;
}

PreviewSurface::Level PreviewSurface::coarser_level(const Level& fine) {
  Level coarse{fine.size / 2, 2 * fine.scale, {}};
  coarse.texels.resize(static_cast<std::size_t>(coarse.size) * coarse.size);
  for (int row = 0; row < coarse.size; ++row) {
    for (int column = 0; column < coarse.size; ++column) {
      const Texel* const above = &fine.texels[std::size_t{2} * row * fine.size + std::size_t{2} * column];
      const std::array<const Texel*, 4> parts{above, above + 1, above + fine.size, above + fine.size + 1};
      Texel& mean = coarse.texels[static_cast<std::size_t>(row) * coarse.size + column];
      for (int q = 0; q < quantities; ++q) {
        mean[q] = 0.25f * ((*parts[0])[q] + (*parts[1])[q] + (*parts[2])[q] + (*parts[3])[q]);
      }
      // Covariance of the whole = mean covariance of the parts + covariance of their means.
      for (const Texel* const part : parts) {
        const float off_x = (*part)[sx] - mean[sx], off_z = (*part)[sz] - mean[sz];
        const float off_trace = (*part)[gxx] + (*part)[gzz] - mean[gxx] - mean[gzz];
        mean[var_xx] += 0.25f * off_x * off_x;
        mean[var_xz] += 0.25f * off_x * off_z;
        mean[var_zz] += 0.25f * off_z * off_z;
        mean[var_trace] += 0.25f * off_trace * off_trace;
      }
    }
  }
  return coarse;
}

/// Adds the first `quantity_count` quantities, interpolated at this place (in texels from the first texel's
/// centre).
template <int quantity_count>
void PreviewSurface::add_level(const Level& level, double column, double row, float weight, Texel& sums) {
  const double first_column = std::floor(column), first_row = std::floor(row);
  const float right = static_cast<float>(column - first_column), down = static_cast<float>(row - first_row);
  const std::int64_t mask = level.size - 1;  // sizes are powers of two
  const std::size_t c0 = static_cast<std::size_t>(static_cast<std::int64_t>(first_column) & mask);
  const std::size_t c1 = (c0 + 1) & static_cast<std::size_t>(mask);
  const std::size_t r0 = static_cast<std::size_t>(static_cast<std::int64_t>(first_row) & mask) * level.size;
  const std::size_t r1 = (r0 + level.size) & (level.texels.size() - 1);
  const std::array<const Texel*, 4> corners{&level.texels[r0 + c0], &level.texels[r0 + c1],
                                            &level.texels[r1 + c0], &level.texels[r1 + c1]};
  const std::array<float, 4> weights{weight * (1 - down) * (1 - right), weight * (1 - down) * right,
                                     weight * down * (1 - right), weight * down * right};
  for (int corner = 0; corner < 4; ++corner) {
    for (int q = 0; q < quantity_count; ++q) sums[q] += weights[corner] * (*corners[corner])[q];
  }
}

/// A wave shows as far as the footprint holds it, as on a grid of that spacing; the rest of it is roughness.
void PreviewSurface::add_trochoids(double x_m, double z_m, float footprint_m, Texel& sums) const {
  for (const ocean::TrochoidInstant::Wave& wave : trochoids_.waves()) {
    const auto k = static_cast<float>(std::hypot(wave.kx_radpm, wave.kz_radpm));
    const auto kx = static_cast<float>(wave.kx_radpm), kz = static_cast<float>(wave.kz_radpm);
    const float per_k = static_cast<float>(trochoids_.horizontal_scale()) / k;
    const double two_pi = 2.0 * std::numbers::pi;
    const auto shown = static_cast<float>(ocean::shown_share(two_pi / k / std::max(footprint_m, 1e-6f)));
    const auto phase = static_cast<float>(
        std::remainder(wave.kx_radpm * x_m + wave.kz_radpm * z_m + wave.phase_rad, two_pi));
    const auto a = static_cast<float>(wave.amplitude_m);
    const float up = shown * a * std::cos(phase), slope = -shown * a * std::sin(phase);
    const float hidden = 0.5f * a * a * (1.0f - shown * shown);
    sums[dx] += per_k * kx * slope;
    sums[dy] += up;
    sums[dz] += per_k * kz * slope;
    sums[sx] += kx * slope;
    sums[sz] += kz * slope;
    sums[gxx] -= per_k * kx * kx * up;
    sums[gxz] -= per_k * kx * kz * up;
    sums[gzz] -= per_k * kz * kz * up;
    sums[var_xx] += hidden * kx * kx;
    sums[var_xz] += hidden * kx * kz;
    sums[var_zz] += hidden * kz * kz;
    sums[var_trace] += hidden * (per_k * k * k) * (per_k * k * k);
  }
}

template <int quantity_count>
PreviewSurface::Texel PreviewSurface::filtered(double x_m, double z_m, float footprint_m) const {
  Texel sums{};
  for (const Pyramid& pyramid : pyramids_) {
    const std::vector<Level>& levels = pyramid.levels;
    const double finest_m = pyramid.sample_m * levels.front().scale;
    const float depth = std::clamp(std::log2(footprint_m / static_cast<float>(finest_m)), 0.0f,
                                   static_cast<float>(levels.size() - 1));
    const std::size_t fine = std::min(static_cast<std::size_t>(depth), levels.size() - 1);
    const float blend = depth - static_cast<float>(fine);
    for (const std::size_t index : {fine, fine + 1}) {
      const float weight = index == fine ? 1.0f - blend : blend;
      if (weight <= 0.0f) continue;
      // A texel covers `scale` samples, the first of which lies at the texel's edge plus half a sample.
      const double per_texel = 1.0 / levels[index].scale;
      add_level<quantity_count>(levels[index], (x_m / pyramid.sample_m + 0.5) * per_texel - 0.5,
                                (z_m / pyramid.sample_m + 0.5) * per_texel - 0.5, weight, sums);
    }
  }
  add_trochoids(x_m, z_m, footprint_m, sums);
  return sums;
}

std::array<float, 3> PreviewSurface::displacement(double x_m, double z_m, float footprint_m) const {
  const Texel sums = filtered<dz + 1>(x_m, z_m, footprint_m);
  return {sums[dx], sums[dy], sums[dz]};
}

SurfaceSample PreviewSurface::sample(double x_m, double z_m, float footprint_m) const {
  const Texel sums = filtered<quantities>(x_m, z_m, footprint_m);
  SurfaceSample sample;
  sample.displacement_x = sums[dx];
  sample.displacement_y = sums[dy];
  sample.displacement_z = sums[dz];
  // Slope of the displaced surface: F^-T times the slope at labels, F = I + gradient, symmetric.
  const float fxx = 1.0f + sums[gxx], fxz = sums[gxz], fzz = 1.0f + sums[gzz];
  const float jacobian = fxx * fzz - fxz * fxz;
  const float divisor = std::max(jacobian, least_jacobian);
  sample.slope_x = (fzz * sums[sx] - fxz * sums[sz]) / divisor;
  sample.slope_z = (fxx * sums[sz] - fxz * sums[sx]) / divisor;
  sample.variance_xx = sums[var_xx];
  sample.variance_xz = sums[var_xz];
  sample.variance_zz = sums[var_zz];
  // Coverage that waves within the footprint are expected to have: J varies as the trace of the gradient
  // does.
  const float deviation = std::sqrt(sums[var_trace]) + 1e-3f;
  const float onset = static_cast<float>(foam_.onset_jacobian), width = static_cast<float>(foam_.width);
  const float fresh =
      (expected_excess(onset, jacobian, deviation) - expected_excess(onset - width, jacobian, deviation)) /
      width;
  sample.foam = std::clamp(std::max(fresh, sums[foam_mean]), 0.0f, 1.0f);
  return sample;
}

}  // namespace offing::cli
