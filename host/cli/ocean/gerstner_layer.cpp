#include "host/cli/ocean/gerstner_layer.h"

#include <algorithm>
#include <set>

#include "host/ocean/query/gerstner_instant.h"

namespace offing::cli {

namespace {

void add(std::vector<float>& values, const std::vector<float>& more) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] += more[i];
  }
}

}  // namespace

GerstnerLayer::GerstnerLayer(const ocl::Device& device, const scene::Sea& sea)
    : gerstner_waves_(scene::gerstner_waves_of(sea, sea.parameters.seed)),
      foam_(sea.parameters.foam),
      instants_(sea.parameters.foam, sea.parameters.loop_period_s),
      surface_(device) {
  const double spacing_m = sea.parameters.cascades.front().patch_length_m / sea.parameters.size;
  labels_ = {.spacing_x_m = spacing_m,
             .spacing_z_m = spacing_m,
             .columns = sea.parameters.size,
             .rows = sea.parameters.size};
}

BakedFrame::CascadeFields GerstnerLayer::with_waves(const BakedFrame::CascadeFields& spectral,
                                                    ocean::Ocean& sea, double time_s,
                                                    double velocity_depth_m) {
  BakedFrame::CascadeFields fields = spectral;
  surface_.at(gerstner_waves_, labels_, time_s);
  const ocean::GerstnerFields waves = surface_.read();
  ocean::SurfaceFields& surface = fields.surface;
  add(surface.displacement_x, waves.displacement_x);
  add(surface.displacement_y, waves.displacement_y);
  add(surface.displacement_z, waves.displacement_z);
  add(surface.slope_x, waves.slope_x);
  add(surface.slope_z, waves.slope_z);
  add(surface.gradient_xx, waves.gradient_xx);
  add(surface.gradient_xz, waves.gradient_xz);
  add(surface.gradient_zz, waves.gradient_zz);
  ocean::ComposedFields composed = sea.read_composed(labels_, {.gerstner_waves = gerstner_waves_});
  surface.jacobian = std::move(composed.jacobian);
  surface.jacobian_min_eigenvalue = std::move(composed.jacobian_min_eigenvalue);
  if (!fields.foam.empty()) {
    fields.foam = foam_at(sea, time_s);
    sea.at(time_s);
  }
  if (!fields.velocity.x.empty()) {
    add_velocity(fields.velocity, time_s, velocity_depth_m);
  }
  return fields;
}

/// As ocean::Foam, of the composed surface.
std::vector<float> GerstnerLayer::foam_at(ocean::Ocean& sea, double time_s) {
  const std::int64_t now = instants_.at_or_before(time_s);
  std::set<std::int64_t> needed;
  for (std::int64_t j = 0; j <= instants_.past_count(); ++j) {
    needed.insert(instants_.key_of(now - j));
  }
  std::erase_if(coverages_, [&](const auto& entry) { return !needed.contains(entry.first); });
  std::vector<float> foam(static_cast<std::size_t>(labels_.columns) * labels_.rows, 0.0f);
  for (std::int64_t j = 0; j <= instants_.past_count(); ++j) {
    const auto weight = static_cast<float>(instants_.weight(j));
    const std::vector<float>& coverage = coverage_at(sea, now - j);
    for (std::size_t i = 0; i < foam.size(); ++i) {
      foam[i] = std::max(foam[i], weight * coverage[i]);
    }
  }
  return foam;
}

const std::vector<float>& GerstnerLayer::coverage_at(ocean::Ocean& sea, std::int64_t instant) {
  const std::int64_t key = instants_.key_of(instant);
  const auto found = coverages_.find(key);
  if (found != coverages_.end()) {
    return found->second;
  }
  sea.at(static_cast<double>(key) * instants_.step_s());
  std::vector<float> coverage = sea.read_composed(labels_, {.gerstner_waves = gerstner_waves_}).jacobian;
  for (float& value : coverage) {
    value = static_cast<float>(std::clamp((foam_.onset_jacobian - value) / foam_.width, 0.0, 1.0));
  }
  return coverages_.emplace(key, std::move(coverage)).first->second;
}

void GerstnerLayer::add_velocity(ocean::VelocityFields& velocity, double time_s, double depth_m) const {
  const ocean::GerstnerInstant instant(gerstner_waves_, time_s);
  for (std::size_t i = 0; i < velocity.x.size(); ++i) {
    const auto columns = static_cast<std::size_t>(labels_.columns);
    const ocean::ParticleVelocity more =
        instant.velocity(static_cast<double>(i % columns) * labels_.spacing_x_m,
                         static_cast<double>(i / columns) * labels_.spacing_z_m, depth_m);
    velocity.x[i] += static_cast<float>(more.x_mps);
    velocity.y[i] += static_cast<float>(more.y_mps);
    velocity.z[i] += static_cast<float>(more.z_mps);
  }
}

}  // namespace offing::cli
