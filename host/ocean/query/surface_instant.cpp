#include "host/ocean/query/surface_instant.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "kernels/shared/deformation.h"

namespace offing::ocean {
namespace {

using Texel = std::array<double, 4>;

Texel texel_of(const std::vector<float>& map, std::size_t place) {
  return {map[4 * place], map[4 * place + 1], map[4 * place + 2], map[4 * place + 3]};
}

/// Bilinear between the four texels around a label, and its derivatives.
class Cell {
 public:
  Cell(double patch_length_m, int size, const WaterPoint& label) : texels_per_m_(size / patch_length_m) {
    const auto wrapped = [&](double position_m, std::size_t& first, std::size_t& second) {
      const double turns = position_m / patch_length_m;
      const double texels = (turns - std::floor(turns)) * size;
      const auto n = static_cast<std::size_t>(size);
      first = static_cast<std::size_t>(texels) % n;
      second = (first + 1) % n;
      return texels - std::floor(texels);
    };
    std::size_t left = 0, right = 0, near = 0, far = 0;
    u_ = wrapped(label.x_m, left, right);
    v_ = wrapped(label.z_m, near, far);
    const auto n = static_cast<std::size_t>(size);
    places_ = {near * n + left, near * n + right, far * n + left, far * n + right};
  }

  Texel value(const std::vector<float>& map) const {
    return sum(map, {(1.0 - u_) * (1.0 - v_), u_ * (1.0 - v_), (1.0 - u_) * v_, u_ * v_});
  }
  Texel along_x(const std::vector<float>& map) const {
    return sum(map, {-(1.0 - v_) * texels_per_m_, (1.0 - v_) * texels_per_m_, -v_ * texels_per_m_,
                     v_ * texels_per_m_});
  }
  Texel along_z(const std::vector<float>& map) const {
    return sum(map, {-(1.0 - u_) * texels_per_m_, -u_ * texels_per_m_, (1.0 - u_) * texels_per_m_,
                     u_ * texels_per_m_});
  }

 private:
  Texel sum(const std::vector<float>& map, const std::array<double, 4>& weights) const {
    Texel total{};
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const Texel texel = texel_of(map, places_[corner]);
      for (std::size_t field = 0; field < 4; ++field) total[field] += weights[corner] * texel[field];
    }
    return total;
  }

  double texels_per_m_;
  double u_ = 0.0, v_ = 0.0;
  std::array<std::size_t, 4> places_{};
};

}  // namespace

SurfaceInstant::SurfaceInstant(std::vector<Maps> cascades, int size, const GerstnerSea& gerstner_waves,
                               double time_s, const WaterQuery& query, const Dispersion& dispersion,
                               std::vector<WakeMaps::Instant> wakes, std::optional<ShoalsInstant> shoals,
                               double error_rms_m)
    : cascades_(std::move(cascades)),
      size_(size),
      gerstner_waves_(gerstner_waves, time_s, query.min_wavelength_m),
      wakes_(std::move(wakes)),
      shoals_(std::move(shoals)),
      query_(query),
      weight_papm_(query.density_kgpm3 * dispersion.gravity_mps2),
      error_rms_m_(error_rms_m) {
  require_valid_query(query, dispersion.depth_m);
  if (!shoals_) return;
  for (const GerstnerInstant::Wave& wave : gerstner_waves_.waves()) {
    const double k_radpm = std::hypot(wave.kx_radpm, wave.kz_radpm);
    bands_.push_back(static_cast<std::size_t>(shoals_->table.bands().gerstner_band(k_radpm)));
  }
}

SurfaceInstant::Shares SurfaceInstant::shares_at(const WaterPoint& label) const {
  Shares shares{.cascades = {1.0, 1.0, 1.0, 1.0}, .gerstner_waves = {}};
  if (!shoals_) return shares;
  const std::array<double, SHOAL_BANDS> there = shoals_->at(label.x_m, label.z_m);
  std::copy_n(there.begin(), shares.cascades.size(), shares.cascades.begin());
  for (const std::size_t band : bands_) shares.gerstner_waves.push_back(there[SHOAL_FIRST_GERSTNER + band]);
  return shares;
}

SurfaceInstant::Sums SurfaceInstant::sums_at(const WaterPoint& label) const {
  const Shares shares = shares_at(label);
  Sums sums{.values = gerstner_waves_.at(label.x_m, label.z_m, shares.gerstner_waves)};
  GerstnerValues& values = sums.values;
  sums.x_by_x = values.gradient_xx;
  sums.z_by_x = sums.x_by_z = values.gradient_xz;
  sums.z_by_z = values.gradient_zz;
  for (std::size_t i = 0; i < cascades_.size(); ++i) {
    const Maps& maps = cascades_[i];
    const double share = shares.cascades[i];
    const Cell cell(maps.patch_length_m, size_, label);
    const Texel moved = cell.value(maps.displacement), shape = cell.value(maps.gradient);
    const Texel along_x = cell.along_x(maps.displacement), along_z = cell.along_z(maps.displacement);
    values.displacement_x_m += share * moved[0];
    values.displacement_y_m += share * moved[1];
    values.displacement_z_m += share * moved[2];
    values.gradient_xz += share * moved[3];
    values.slope_x += share * shape[0];
    values.slope_z += share * shape[1];
    values.gradient_xx += share * shape[2];
    values.gradient_zz += share * shape[3];
    sums.x_by_x += share * along_x[0];
    sums.z_by_x += share * along_x[2];
    sums.x_by_z += share * along_z[0];
    sums.z_by_z += share * along_z[2];
  }
  for (const WakeMaps::Instant& wake : wakes_) {
    const auto [height_m, slope_x, slope_z, rise_mps] = wake.at(label.x_m, label.z_m);
    values.displacement_y_m += height_m;
    values.slope_x += slope_x;
    values.slope_z += slope_z;
  }
  return sums;
}

/// The steps of ocean/surface_query.cl.
WaterPoint SurfaceInstant::label_under(const WaterPoint& point) const {
  WaterPoint label = point;
  const bool has_gerstner_waves = !gerstner_waves_.waves().empty();
  if (has_gerstner_waves) {
    const GerstnerValues values = gerstner_waves_.at(point.x_m, point.z_m, shares_at(point).gerstner_waves);
    label = {.x_m = point.x_m - values.displacement_x_m, .z_m = point.z_m - values.displacement_z_m};
  }
  for (int step = has_gerstner_waves ? 1 : 0; step < SURFACE_QUERY_MOST_STEPS; ++step) {
    const Sums sums = sums_at(label);
    const double off_x_m = label.x_m + sums.values.displacement_x_m - point.x_m;
    const double off_z_m = label.z_m + sums.values.displacement_z_m - point.z_m;
    if (std::hypot(off_x_m, off_z_m) <= query_.tolerance_m) break;
    const double xx = 1.0 + sums.x_by_x, zz = 1.0 + sums.z_by_z;
    const double determinant = std::max<double>(xx * zz - sums.x_by_z * sums.z_by_x, LEAST_DETERMINANT);
    const bool is_plain = step == 0;
    label.x_m -= is_plain ? off_x_m : (zz * off_x_m - sums.x_by_z * off_z_m) / determinant;
    label.z_m -= is_plain ? off_z_m : (xx * off_z_m - sums.z_by_x * off_x_m) / determinant;
  }
  return label;
}

WaterSample SurfaceInstant::at(const WaterPoint& point) const {
  device_point(point);  // throws for those that are too far
  const WaterPoint label = label_under(point);
  const GerstnerValues sea = at_label(label);
  const double xx = 1.0 + sea.gradient_xx, xz = sea.gradient_xz, zz = 1.0 + sea.gradient_zz;
  const double jacobian = xx * zz - xz * xz;
  const double determinant = std::copysign(std::max<double>(std::abs(jacobian), LEAST_DETERMINANT), jacobian);
  WaterSample sample{};
  sample.height_m = static_cast<float>(sea.displacement_y_m);
  sample.slope_x = static_cast<float>((zz * sea.slope_x - xz * sea.slope_z) / determinant);
  sample.slope_z = static_cast<float>((xx * sea.slope_z - xz * sea.slope_x) / determinant);
  sample.residual_m = static_cast<float>(
      std::hypot(label.x_m + sea.displacement_x_m - point.x_m, label.z_m + sea.displacement_z_m - point.z_m));
  sample.error_rms_m = static_cast<float>(error_rms_m_);
  if (query_.fields == WaterQuery::Fields::surface) return sample;
  const Shares shares = shares_at(label);
  ParticleVelocity velocity =
      gerstner_waves_.velocity(label.x_m, label.z_m, query_.depth_m, shares.gerstner_waves);
  double head_m =
      gerstner_waves_.pressure_head_m(label.x_m, label.z_m, query_.depth_m, shares.gerstner_waves);
  for (std::size_t i = 0; i < cascades_.size(); ++i) {
    const Maps& maps = cascades_[i];
    const Texel flow = Cell(maps.patch_length_m, size_, label).value(maps.flow);
    velocity.x_mps += shares.cascades[i] * flow[0];
    velocity.y_mps += shares.cascades[i] * flow[1];
    velocity.z_mps += shares.cascades[i] * flow[2];
    head_m += shares.cascades[i] * flow[3];
  }
  for (const WakeMaps::Instant& wake : wakes_) {
    const std::array<double, 4> there = wake.at(label.x_m, label.z_m);
    const double left = std::exp(-wake.layer.decay_radpm * query_.depth_m);
    velocity.y_mps += left * there[3];
    head_m += left * there[0];
  }
  sample.velocity_x_mps = static_cast<float>(velocity.x_mps);
  sample.velocity_y_mps = static_cast<float>(velocity.y_mps);
  sample.velocity_z_mps = static_cast<float>(velocity.z_mps);
  sample.pressure_pa = static_cast<float>(weight_papm_ * (query_.depth_m + head_m - sea.displacement_y_m));
  return sample;
}

}  // namespace offing::ocean
