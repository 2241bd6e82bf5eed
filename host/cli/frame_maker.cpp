#include "host/cli/frame_maker.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "host/ocl/host_memory.h"

namespace offing::cli {
namespace {

// One is made, one waits and one is written.
constexpr std::size_t frames_at_once = 3;

void require_room(const BakeSettings& settings, int size, std::size_t cascades) {
  const std::size_t frames = std::min<std::size_t>(
      frames_at_once, static_cast<std::size_t>(settings.frames.last - settings.frames.first + 1));
  ocl::require_host_memory(static_cast<double>(frames * frame_bytes(settings, size, cascades)),
                           fmt::format("{}: {} frames at once, of {} cascades of {} x {} samples,",
                                       settings.folder.string(), frames, cascades, size, size),
                           "use a smaller --size or fewer --cascades");
}

}  // namespace

std::size_t frame_bytes(const BakeSettings& settings, int size, std::size_t cascades) {
  const std::size_t texels = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  const bool shows_foam = settings.has(ChannelGroup::foam) || settings.preview == PreviewUse::pictures;
  const std::size_t surface = 10, foam = shows_foam ? 1 : 0,
                    velocity = settings.has(ChannelGroup::velocity) ? 3 : 0;
  const std::size_t with_gerstner = settings.gerstner == GerstnerUse::included ? 1 : 0;
  const std::size_t mesh = settings.mesh == MeshFormat::none ? 0 : 6;
  return texels * sizeof(float) * ((cascades + with_gerstner) * (surface + foam + velocity) + mesh);
}

FrameMaker::FrameMaker(const ocl::Device& device, const scene::Sea& sea, const BakeSettings& settings)
    : settings_(settings), ocean_(device, sea.spectrum, sea.parameters) {
  if (settings.gerstner == GerstnerUse::included && sea.has_trochoids()) {
    gerstner_.emplace(device, sea);
  }
  require_room(settings, sea.parameters.size, sea.parameters.cascades.size());
}

BakedFrame FrameMaker::make(int frame) {
  BakedFrame baked;
  baked.number = frame;
  baked.time_s = settings_.time_s(frame);
  ocean_.at(baked.time_s);
  const bool shows_foam = settings_.has(ChannelGroup::foam) || settings_.preview == PreviewUse::pictures;
  for (std::size_t i = 0; i < ocean_.parameters().cascades.size(); ++i) {
    const int cascade = static_cast<int>(i);
    BakedFrame::CascadeFields& fields = baked.cascades.emplace_back();
    fields.surface = ocean_.read_surface(cascade);
    if (shows_foam) {
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
  const ocean::ComposedFields sea =
      ocean_.read_composed({.spacing_x_m = spacing_m, .spacing_z_m = spacing_m, .columns = n, .rows = n},
                           {.trochoids = gerstner_ ? gerstner_->trochoids() : ocean::TrochoidSea{}});
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
