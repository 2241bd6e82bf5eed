#include "host/cli/ocean/frame_maker.h"

#include <algorithm>
#include <cmath>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "host/base/host_memory.h"
#include "host/ocean/surface/foam.h"

namespace offing::cli {
namespace {

void add(std::vector<float>& values, const std::vector<float>& more) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] += more[i];
  }
}

// Beside those that devices make and threads write.
constexpr std::size_t waiting_frames = 1;

bool shows_foam(const BakeSettings& settings) {
  return settings.has(ChannelGroup::foam) || settings.preview == PreviewUse::pictures;
}

/// Of the sea that frames show: that of the cascades alone, unless the waves beside them are included.
ocean::OceanParameters baked_parameters(const scene::Sea& sea, GerstnerUse use) {
  ocean::OceanParameters parameters = sea.parameters;
  if (use != GerstnerUse::included) parameters.gerstner_waves = {};
  return parameters;
}

/// t_z x t_x of the tangents along x and z of the displaced surface. It points down where the surface folds.
NormalFields normals_of(const ocean::SurfaceFields& surface) {
  const std::size_t count = surface.slope_x.size();
  NormalFields normals{std::vector<float>(count), std::vector<float>(count), std::vector<float>(count)};
  for (std::size_t i = 0; i < count; ++i) {
    const float xx = 1.0f + surface.gradient_xx[i], zz = 1.0f + surface.gradient_zz[i];
    const float xz = surface.gradient_xz[i], slope_x = surface.slope_x[i], slope_z = surface.slope_z[i];
    const float x = slope_z * xz - zz * slope_x, y = xx * zz - xz * xz, z = xz * slope_x - slope_z * xx;
    const float length = std::sqrt(x * x + y * y + z * z);
    const bool is_none = length == 0.0f;  // the surface is a line or a point there
    normals.x[i] = is_none ? 0.0f : x / length;
    normals.y[i] = is_none ? 1.0f : y / length;
    normals.z[i] = is_none ? 0.0f : z / length;
  }
  return normals;
}

bool shares_host_memory(const ocl::DeviceInfo& device) {
  return device.type == ocl::DeviceType::cpu || device.has_host_unified_memory;
}

}  // namespace

GerstnerLayer::GerstnerLayer(const ocl::Device& device, const ocean::OceanParameters& sea)
    : surface_(device) {
  const double spacing_m = sea.cascades.front().patch_length_m / sea.size;
  labels_ = {.spacing_x_m = spacing_m, .spacing_z_m = spacing_m, .columns = sea.size, .rows = sea.size};
}

BakedFrame::CascadeFields GerstnerLayer::with_waves(const BakedFrame::CascadeFields& spectral,
                                                    ocean::Ocean& sea, double time_s,
                                                    double velocity_depth_m) {
  BakedFrame::CascadeFields fields = spectral;
  const ocean::GerstnerSea& gerstner_waves = sea.parameters().gerstner_waves;
  surface_.at(gerstner_waves, labels_, time_s);
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
  ocean::ComposedFields composed = sea.read_composed(labels_);
  surface.jacobian = std::move(composed.jacobian);
  surface.jacobian_min_eigenvalue = std::move(composed.jacobian_min_eigenvalue);
  if (!fields.foam.empty()) {
    fields.foam = sea.read_composed_foam(labels_);
  }
  if (!fields.velocity.x.empty()) {
    add_velocity(fields.velocity, {gerstner_waves, time_s}, velocity_depth_m);
  }
  return fields;
}

void GerstnerLayer::add_velocity(ocean::VelocityFields& velocity, const ocean::GerstnerInstant& waves,
                                 double depth_m) const {
  for (std::size_t i = 0; i < velocity.x.size(); ++i) {
    const auto columns = static_cast<std::size_t>(labels_.columns);
    const ocean::ParticleVelocity more =
        waves.velocity(static_cast<double>(i % columns) * labels_.spacing_x_m,
                       static_cast<double>(i / columns) * labels_.spacing_z_m, depth_m);
    velocity.x[i] += static_cast<float>(more.x_mps);
    velocity.y[i] += static_cast<float>(more.y_mps);
    velocity.z[i] += static_cast<float>(more.z_mps);
  }
}

std::size_t writer_count() {
  // Some, because each waits for the disk in turn. Compression has threads of its own (write_exr()).
  constexpr unsigned most = 4;
  return std::clamp(std::thread::hardware_concurrency(), 1u, most);
}

std::size_t frame_bytes(const BakeSettings& settings, int size, std::size_t cascades) {
  const std::size_t texels = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  const std::size_t surface = 10, foam = shows_foam(settings) ? 1 : 0,
                    velocity = settings.has(ChannelGroup::velocity) ? 3 : 0;
  const std::size_t with_gerstner = settings.gerstner == GerstnerUse::included ? 1 : 0;
  const std::size_t normal = settings.has(ChannelGroup::normal) ? 3 : 0;
  const std::size_t mesh = settings.mesh == MeshFormat::none ? 0 : 6;
  std::size_t wake_texels = 0;
  for (const int cells : settings.wake_cells)
    wake_texels += static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells);
  const std::size_t wake = 5;
  return wake_texels * wake * sizeof(float) +
         texels * sizeof(float) *
             ((cascades + with_gerstner) * (surface + foam + velocity) + cascades * normal + mesh);
}

std::size_t sea_bytes(const BakeSettings& settings, const scene::Sea& sea) {
  const auto texels = static_cast<std::size_t>(sea.parameters.size) *
                      static_cast<std::size_t>(sea.parameters.size) * sea.parameters.cascades.size();
  // In bytes a texel. WaveModes keeps amplitudes and frequencies of half the modes, and all variances;
  // ModeTransform five and, of velocities, four fields between its passes.
  constexpr std::size_t modes = 8 + 2 + 4, between_passes = 20, maps = 32, velocity = 16 + 16;
  std::size_t bytes_a_texel = modes + between_passes + maps;
  if (settings.has(ChannelGroup::velocity)) bytes_a_texel += velocity;
  if (shows_foam(settings)) {
    const ocean::FoamInstants instants(sea.parameters.foam, sea.parameters.loop_period_s);
    // Foam now and at an instant, amplitudes of the waves that foam, and coverages.
    bytes_a_texel +=
        2 * sizeof(float) + 8 + sizeof(std::uint16_t) * static_cast<std::size_t>(instants.past_count() + 2);
  }
  return bytes_a_texel * texels;
}

void require_host_room(const BakeSettings& settings, const scene::Sea& sea,
                       std::span<const ocl::DeviceInfo> devices) {
  const std::size_t cascades = sea.parameters.cascades.size();
  const int size = sea.parameters.size;
  const std::size_t frames =
      std::min<std::size_t>(devices.size() + waiting_frames + writer_count(),
                            static_cast<std::size_t>(settings.frames.last - settings.frames.first + 1));
  const auto seas =
      static_cast<std::size_t>(std::count_if(devices.begin(), devices.end(), shares_host_memory));
  require_host_memory(
      static_cast<double>(frames) * static_cast<double>(frame_bytes(settings, size, cascades)) +
          static_cast<double>(seas) * static_cast<double>(sea_bytes(settings, sea)),
      fmt::format(
          "{}: {} frames at once of {} cascades of {} x {} samples, and the seas of {} devices that use "
          "the machine's memory,",
          settings.folder.string(), frames, cascades, size, size, seas),
      "use a smaller --size, fewer --cascades, or one device with --device");
}

FrameMaker::FrameMaker(const ocl::Device& device, const scene::Sea& sea, const BakeSettings& settings,
                       const scene::Scene& scene)
    : settings_(settings), ocean_(device, sea.spectrum, baked_parameters(sea, settings.gerstner)) {
  if (settings.gerstner == GerstnerUse::included && sea.has_gerstner_waves()) {
    gerstner_.emplace(device, sea.parameters);
  }
  next_wake_frame_ = settings.frames.first;
  if (!settings.wake_cells.empty()) wakes_ = WakeHistory::of(device, scene, sea);
}

/// A wake without bodies depends on when it was first asked for, and leaps begin it anew: it goes through all
/// frames from the first, so that every share of them and every resumed bake finds the same.
std::vector<BakedFrame::Wake> FrameMaker::make_wakes(int frame) {
  std::vector<BakedFrame::Wake> wakes;
  if (frame < next_wake_frame_) next_wake_frame_ = settings_.frames.first;
  while (next_wake_frame_ <= frame) wakes_->at(settings_.time_s(next_wake_frame_++));
  for (ocean::WakeFields& window : wakes_->maps()->read_fields()) {
    BakedFrame::Wake& wake = wakes.emplace_back();
    wake.origin_x_m = window.origin_x_m;
    wake.origin_z_m = window.origin_z_m;
    wake.cell_m = window.cell_m;
    wake.fields.surface.displacement_y = std::move(window.height_m);
    wake.fields.surface.slope_x = std::move(window.slope_x);
    wake.fields.surface.slope_z = std::move(window.slope_z);
    wake.fields.velocity.y = std::move(window.rise_mps);
    wake.fields.foam = std::move(window.foam);
  }
  return wakes;
}

BakedFrame FrameMaker::make(int frame) {
  BakedFrame baked;
  baked.number = frame;
  baked.time_s = settings_.time_s(frame);
  ocean_.at(baked.time_s);
  for (std::size_t i = 0; i < ocean_.parameters().cascades.size(); ++i) {
    const int cascade = static_cast<int>(i);
    BakedFrame::CascadeFields& fields = baked.cascades.emplace_back();
    fields.surface = ocean_.read_surface(cascade);
    if (shows_foam(settings_)) {
      fields.foam = ocean_.read_foam(cascade);
    }
    if (settings_.has(ChannelGroup::velocity)) {
      fields.velocity = ocean_.read_velocity(cascade, settings_.velocity_depth_m);
    }
  }
  if (gerstner_) {
    baked.first_with_gerstner =
        gerstner_->with_waves(baked.cascades.front(), ocean_, baked.time_s, settings_.velocity_depth_m);
  }
  for (std::size_t i = 0; settings_.has(ChannelGroup::normal) && i < baked.cascades.size(); ++i) {
    baked.written(i).normal = normals_of(baked.written(i).surface);
  }
  if (wakes_) baked.wakes = make_wakes(frame);
  if (settings_.mesh != MeshFormat::none) {
    baked.mesh = make_mesh();
  }
  return baked;
}

GridMesh FrameMaker::make_mesh() {
  const int n = ocean_.parameters().size;
  const double spacing_m = ocean_.parameters().cascades.front().patch_length_m / n;
  const ocean::ComposedFields sea =
      ocean_.read_composed({.spacing_x_m = spacing_m, .spacing_z_m = spacing_m, .columns = n, .rows = n});
  GridMesh mesh;
  mesh.columns = n;
  mesh.rows = n;
  const std::size_t count = static_cast<std::size_t>(n) * n;
  mesh.positions_xyz.reserve(3 * count);
  mesh.normals_xyz.reserve(3 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const double x_m = spacing_m * static_cast<double>(i % n);
    const double z_m = spacing_m * static_cast<double>(i / n);
    mesh.positions_xyz.push_back(static_cast<float>(x_m + sea.displacement_x[i]));
    mesh.positions_xyz.push_back(sea.displacement_y[i]);
    mesh.positions_xyz.push_back(static_cast<float>(z_m + sea.displacement_z[i]));
    // The normal of a height field of these slopes: (-sx, 1, -sz), normalised.
    const float length = std::hypot(sea.slope_x[i], 1.0f, sea.slope_z[i]);
    mesh.normals_xyz.push_back(-sea.slope_x[i] / length);
    mesh.normals_xyz.push_back(1.0f / length);
    mesh.normals_xyz.push_back(-sea.slope_z[i] / length);
  }
  return mesh;
}

}  // namespace offing::cli
