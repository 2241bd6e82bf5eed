#include "host/cli/ocean/frame_maker.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "host/base/host_memory.h"
#include "host/ocean/surface/foam.h"

namespace offing::cli {
namespace {

// Beside the one that each device makes: one waits and one is written.
constexpr std::size_t frames_behind = 2;

bool shows_foam(const BakeSettings& settings) {
  return settings.has(ChannelGroup::foam) || settings.preview == PreviewUse::pictures;
}

bool shares_host_memory(const ocl::DeviceInfo& device) {
  return device.type == ocl::DeviceType::cpu || device.has_host_unified_memory;
}

}  // namespace

std::size_t frame_bytes(const BakeSettings& settings, int size, std::size_t cascades) {
  const std::size_t texels = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  const std::size_t surface = 10, foam = shows_foam(settings) ? 1 : 0,
                    velocity = settings.has(ChannelGroup::velocity) ? 3 : 0;
  const std::size_t with_gerstner = settings.gerstner == GerstnerUse::included ? 1 : 0;
  const std::size_t mesh = settings.mesh == MeshFormat::none ? 0 : 6;
  return texels * sizeof(float) * ((cascades + with_gerstner) * (surface + foam + velocity) + mesh);
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
    bytes_a_texel +=
        sizeof(float) + sizeof(std::uint16_t) * static_cast<std::size_t>(instants.past_count() + 1);
  }
  return bytes_a_texel * texels;
}

void require_host_room(const BakeSettings& settings, const scene::Sea& sea,
                       std::span<const ocl::DeviceInfo> devices) {
  const std::size_t cascades = sea.parameters.cascades.size();
  const int size = sea.parameters.size;
  const std::size_t frames =
      std::min<std::size_t>(devices.size() + frames_behind,
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

FrameMaker::FrameMaker(const ocl::Device& device, const scene::Sea& sea, const BakeSettings& settings)
    : settings_(settings), ocean_(device, sea.spectrum, sea.parameters) {
  if (settings.gerstner == GerstnerUse::included && sea.has_gerstner_waves()) {
    gerstner_.emplace(device, sea);
  }
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
  if (settings_.mesh != MeshFormat::none) {
    baked.mesh = make_mesh();
  }
  return baked;
}

GridMesh FrameMaker::make_mesh() {
  const int n = ocean_.parameters().size;
  const double spacing_m = ocean_.parameters().cascades.front().patch_length_m / n;
  const ocean::ComposedFields sea = ocean_.read_composed(
      {.spacing_x_m = spacing_m, .spacing_z_m = spacing_m, .columns = n, .rows = n},
      {.gerstner_waves = gerstner_ ? gerstner_->gerstner_waves() : ocean::GerstnerSea{}});
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
