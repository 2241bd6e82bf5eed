#include "host/clouds/light/resolved_clouds.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "host/clouds/light/lump_noise.h"
#include "host/ocl/program.h"

namespace offing::clouds {
namespace {

// Edges of cubes of a cloud's box (CLOUD_MARCH_EDGES), px, between which marching takes over from billboards.
constexpr double billboards_px = 1.5, marched_px = 2.5;
constexpr std::size_t most_volumes = CLOUD_MARCH_VOLUMES;

// Between the particles and the sides of a volume: half a cell, and what balls of the least radius stand out.
constexpr double margin_cells = 0.5 + CLOUD_MARCH_LEAST_RADIUS;

// Edge of a texel of noise, in mean radii of particles.
constexpr float lump_radii = 0.06f;
// How strong they are in clouds of soft textures, whose shapes are smoother than those of heaps.
constexpr float soft_lumps = 0.4f;

/// Noise as the kernel reads it (CLOUD_LUMP_LEAST).
std::vector<std::uint32_t> lump_squares(const std::vector<float>& noise) {
  constexpr std::size_t edge = CLOUD_LUMP_TEXELS;
  const auto byte_at = [&](std::size_t x, std::size_t y, std::size_t z) {
    const float value = noise[(z * edge + y % edge) * edge + x % edge];
    return static_cast<std::uint32_t>(
        std::clamp(std::lround((value - CLOUD_LUMP_LEAST) / CLOUD_LUMP_STEP), 0L, 255L));
  };
  std::vector<std::uint32_t> squares;
  for (std::size_t z = 0; z < edge; ++z)
    for (std::size_t y = 0; y < edge; ++y)
      for (std::size_t x = 0; x < edge; ++x)
        squares.push_back(byte_at(x, y, z) | byte_at(x + 1, y, z) << 8 | byte_at(x, y + 1, z) << 16 |
                          byte_at(x + 1, y + 1, z) << 24);
  return squares;
}

int rounded_up(double cells, int step) {
  return step * std::max(1, static_cast<int>(std::ceil(cells / step)));
}

/// With axes of `like`, around what bounds hold; a cell lies beyond on each side, so that all fades to
/// nothing.
CloudMarchVolume volume_of(const CloudMarchBounds& bounds, const CloudMarchVolume& like, int cloud) {
  const glm::dvec3 low_m(bounds.low_x, bounds.low_y, bounds.low_z),
      high_m(bounds.high_x, bounds.high_y, bounds.high_z);
  const glm::dvec3 box_m = high_m - low_m;
  CloudMarchVolume volume = like;
  volume.cloud = cloud;
  volume.lump_m = lump_radii * bounds.radius_m;
  if (bounds.texture >= CLOUD_TEXTURES) volume.lumps *= soft_lumps;
  volume.anchor_x = bounds.anchor_x, volume.anchor_y = bounds.anchor_y, volume.anchor_z = bounds.anchor_z;
  for (double cell_m = std::cbrt(box_m.x * box_m.y * box_m.z / CLOUD_MARCH_CELLS);; cell_m *= 1.02) {
    volume.cell_m = static_cast<float>(cell_m);
    volume.low_x = static_cast<float>(low_m.x - margin_cells * cell_m);
    volume.low_y = static_cast<float>(low_m.y - margin_cells * cell_m);
    volume.low_z = static_cast<float>(low_m.z - margin_cells * cell_m);
    volume.size_x = rounded_up(box_m.x / cell_m + 2.0 * margin_cells, CLOUD_MARCH_ROW);
    volume.size_y = rounded_up(box_m.y / cell_m + 2.0 * margin_cells, CLOUD_MARCH_BLOCK);
    volume.size_z = rounded_up(box_m.z / cell_m + 2.0 * margin_cells, CLOUD_MARCH_BLOCK);
    if (std::int64_t{volume.size_x} * volume.size_y * volume.size_z <= CLOUD_MARCH_CELLS) return volume;
  }
}

/// Unit; any across it where the first sun is dark.
CloudMarchVolume axes_toward(const glm::dvec3& sun) {
  const glm::dvec3 right =
      glm::normalize(glm::cross(std::abs(sun.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0), sun));
  const glm::vec3 x(right), y(glm::cross(sun, right)), z(sun);
  CloudMarchVolume axes{};
  axes.right_x = x.x, axes.right_y = x.y, axes.right_z = x.z;
  axes.up_x = y.x, axes.up_y = y.y, axes.up_z = y.z;
  axes.sun_x = z.x, axes.sun_y = z.y, axes.sun_z = z.z;
  return axes;
}

/// Of a place in the axes of the particles.
glm::dvec3 along(const CloudMarchVolume& axes, const glm::dvec3& place) {
  return {glm::dot(glm::dvec3(axes.right_x, axes.right_y, axes.right_z), place),
          glm::dot(glm::dvec3(axes.up_x, axes.up_y, axes.up_z), place),
          glm::dot(glm::dvec3(axes.sun_x, axes.sun_y, axes.sun_z), place)};
}

struct Wanted {
  int cloud;
  double edge_px;
};

ocl::Kernel march_kernel(const ocl::Device& device, const char* source, const char* kernel,
                         const ocl::KernelTuning& tuning, int channels = 1) {
  ocl::Defines defines;
  defines.set("GROUP_SIZE", static_cast<long long>(tuning.group))
      .set("LANES", tuning.lanes)
      .set("CHANNELS", channels);
  return ocl::Program::build(device, source, defines).kernel(kernel);
}

double smooth(double low, double high, double value) {
  const double t = std::clamp((value - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}  // namespace

ResolvedClouds::ResolvedClouds(const ocl::Device& device, double lumps)
    : device_(device),
      lumps_(lumps),
      density_tuning_(ocl::tuning_for(device.info(), "light_density")),
      cell_tuning_(ocl::tuning_for(device.info(), "light_cells")),
      group_tuning_(ocl::tuning_for(device.info(), "light_groups")),
      picture_tuning_(ocl::tuning_for(device.info(), "billboard_composite")),
      bounds_kernel_(march_kernel(device, "clouds/march/march_bounds.cl", "march_bounds", group_tuning_)),
      density_kernel_(
          march_kernel(device, "clouds/march/march_density.cl", "march_density", density_tuning_)),
      blocks_kernel_(march_kernel(device, "clouds/march/march_blocks.cl", "march_blocks", density_tuning_)),
      descent_kernel_(
          march_kernel(device, "clouds/march/march_descent.cl", "march_descent", density_tuning_)),
      beam_kernel_(march_kernel(device, "clouds/march/march_beam.cl", "march_beam", group_tuning_)),
      pairs_kernel_(march_kernel(device, "clouds/march/march_pairs.cl", "march_pairs", cell_tuning_)) {}

ResolvedClouds::Kernels& ResolvedClouds::kernels() {
  const int channels = light_->fields().channels;
  std::optional<Kernels>& kernels = kernels_[channels == 1 ? 0 : 1];
  if (!kernels) {
    kernels = {
        march_kernel(device_, "clouds/march/march_source.cl", "march_source", cell_tuning_, channels),
        march_kernel(device_, "clouds/march/cloud_march.cl", "cloud_march", picture_tuning_, channels)};
  }
  return *kernels;
}

void ResolvedClouds::set(const ocl::Buffer<CloudParticle>& particles, const ParticleLight& light) {
  particles_ = &particles;
  light_ = &light;
  const LightFields fields = light.fields();
  axes_ = axes_toward(fields.first_sun);
  axes_.lumps = static_cast<float>(lumps_);
  if (bounds_buffer_.size() < fields.clouds)
    bounds_buffer_ = ocl::Buffer<CloudMarchBounds>(device_, fields.clouds, "bounds of marched clouds");
  bounds_kernel_.launch({{fields.clouds * group_tuning_.group}, {group_tuning_.group}}, particles,
                        fields.grids, axes_, bounds_buffer_);
  bounds_ = bounds_buffer_.read();
  bounds_.resize(fields.clouds);
  if (phases_.size() < fields.phases.size())
    phases_ = ocl::Buffer<std::uint32_t>(device_, fields.phases.size(), "phases of marched clouds");
  pair(fields.phases, fields.phases.size(), 0, phases_);
  std::ranges::fill(slots_, std::nullopt);
}

void ResolvedClouds::reserve(std::size_t slots) {
  const auto suns = static_cast<std::size_t>(light_->fields().suns),
             values = light_->fields().channels == 1 ? std::size_t{3} : std::size_t{6};
  bool is_new = false;
  const auto fit = [&](auto& buffer, std::size_t size, const char* name) {
    if (size <= buffer.size()) return;
    buffer = std::decay_t<decltype(buffer)>(device_, size, name);
    is_new = true;
  };
  fit(density_, CLOUD_MARCH_CELLS, "density of a marched cloud");
  fit(depths_, std::max<std::size_t>(suns, 1) * CLOUD_MARCH_CELLS, "sunlight in a marched cloud");
  fit(cells_, slots * (1 + suns) * CLOUD_MARCH_CELLS, "marched clouds' cells");
  fit(blocks_, slots * CLOUD_MARCH_BLOCKS, "blocks of marched clouds");
  fit(volumes_buffer_, slots, "marched clouds");
  const std::size_t source_cells = slots * values * light_grid_cells(light_->fields().cells);
  if (sources_.size() < source_cells)
    sources_ = ocl::Buffer<std::uint32_t>(device_, source_cells, "light of marched clouds");
  if (noise_.size() == 0)
    noise_ = ocl::Buffer<std::uint32_t>(device_, lump_squares(lump_noise()), "lumps of clouds");
  slots_.resize(std::max(slots_.size(), slots));
  if (!is_new) return;
  std::ranges::fill(slots_, std::nullopt);
  volumes_held_.clear();
}

void ResolvedClouds::resolve(const Camera& camera, const glm::dvec3& origin_m) {
  volumes_.clear();
  origin_m_ = origin_m;
  const glm::dvec3 eye_m = camera.eye_m - origin_m;
  const double px_a_tangent = 0.5 * camera.height_px / half_extent(camera).y;
  std::vector<Wanted> wanted;
  const glm::dvec3 eye_in_volume_m = along(axes_, eye_m);
  for (std::size_t cloud = 0; cloud < bounds_.size(); ++cloud) {
    const CloudMarchBounds& bounds = bounds_[cloud];
    if (bounds.first == bounds.end) continue;
    const glm::dvec3 low_m(bounds.low_x, bounds.low_y, bounds.low_z),
        high_m(bounds.high_x, bounds.high_y, bounds.high_z);
    const double nearest_m = glm::distance(eye_in_volume_m, glm::clamp(eye_in_volume_m, low_m, high_m));
    const double edge_px = px_a_tangent * bounds.edge_m / std::max<double>(nearest_m, bounds.edge_m);
    if (edge_px > billboards_px) wanted.push_back({static_cast<int>(cloud), edge_px});
  }
  std::sort(wanted.begin(), wanted.end(),
            [](const Wanted& a, const Wanted& b) { return a.edge_px > b.edge_px; });
  // Of more clouds than there are volumes, the smallest fade as others grow beyond them.
  const double least_px =
      wanted.size() > most_volumes ? std::max(billboards_px, wanted[most_volumes].edge_px) : billboards_px;
  wanted.resize(std::min(wanted.size(), most_volumes));
  std::vector<float> shares(bounds_.size(), 1.0f);
  if (!wanted.empty()) reserve(std::min(bounds_.size(), most_volumes));
  const auto is_free = [&](const std::optional<int>& slot) {
    return !slot || std::ranges::find(wanted, *slot, &Wanted::cloud) == wanted.end();
  };
  for (const Wanted& one : wanted) {
    CloudMarchVolume volume = volume_of(bounds_[static_cast<std::size_t>(one.cloud)], axes_, one.cloud);
    volume.share = static_cast<float>(smooth(least_px, least_px * marched_px / billboards_px, one.edge_px));
    auto slot = std::ranges::find(slots_, one.cloud);
    const bool is_made = slot != slots_.end();
    if (!is_made) slot = std::ranges::find_if(slots_, is_free);
    volume.slot = static_cast<int>(slot - slots_.begin());
    if (!is_made) {
      make(volume);
      *slot = one.cloud;
    }
    shares[static_cast<std::size_t>(one.cloud)] = 1.0f - volume.share;
    volumes_.push_back(volume);
  }
  // Pictures depend on the order a little where volumes overlap.
  std::ranges::sort(volumes_, {}, &CloudMarchVolume::cloud);
  // A write waits for the device.
  const bool are_held =
      volumes_.size() == volumes_held_.size() &&
      std::memcmp(volumes_.data(), volumes_held_.data(), volumes_.size() * sizeof(CloudMarchVolume)) == 0;
  if (!volumes_.empty() && !are_held) {
    volumes_buffer_.write(volumes_);
    volumes_held_ = volumes_;
  }
  if (shares_held_ == shares) return;
  if (shares_.size() < shares.size())
    shares_ = ocl::Buffer<float>(device_, shares.size(), "shares of clouds");
  shares_.write(shares);
  shares_held_ = std::move(shares);
}

std::vector<int> ResolvedClouds::marched() const {
  std::vector<int> clouds;
  for (const CloudMarchVolume& volume : volumes_) clouds.push_back(volume.cloud);
  return clouds;
}

void ResolvedClouds::make(int cloud) {
  const CloudMarchBounds& bounds = bounds_[static_cast<std::size_t>(cloud)];
  if (bounds.first == bounds.end) return;
  reserve(std::min(bounds_.size(), most_volumes));
  const auto slot = std::ranges::find_if(slots_, [](const auto& held) { return !held; });
  if (slot == slots_.end()) return;
  CloudMarchVolume volume = volume_of(bounds, axes_, cloud);
  volume.slot = static_cast<int>(slot - slots_.begin());
  make(volume);
  *slot = cloud;
}

void ResolvedClouds::make(const CloudMarchVolume& volume) {
  const LightFields light = light_->fields();
  const CloudMarchBounds& bounds = bounds_[static_cast<std::size_t>(volume.cloud)];
  const auto planes = static_cast<std::size_t>(volume.size_z);
  density_kernel_.launch({{planes}}, *particles_, bounds.first, bounds.end, volume, density_);
  blocks_kernel_.launch({{planes / CLOUD_MARCH_BLOCK}}, *particles_, bounds.first, bounds.end, volume,
                        blocks_);
  const std::size_t cells =
      planes * static_cast<std::size_t>(volume.size_y) * static_cast<std::size_t>(volume.size_x);
  const auto suns = static_cast<std::size_t>(light.suns), slot = static_cast<std::size_t>(volume.slot);
  const std::size_t first = slot * (1 + suns) * CLOUD_MARCH_CELLS;
  pair(density_, cells, first, cells_);
  if (suns == 0) return;
  const auto clouds = static_cast<int>(light.clouds);
  descent_kernel_.launch({{static_cast<std::size_t>(volume.size_y)}}, volume, density_, light.grids,
                         light.looks, light.lights, light.entries, clouds, light.suns, light.channels,
                         depths_);
  if (suns > 1)
    beam_kernel_.launch(
        {{static_cast<std::size_t>(light.suns - 1) * group_tuning_.group}, {group_tuning_.group}}, volume,
        density_, light.grids, light.looks, light.lights, light.entries, clouds, light.channels, depths_);
  pair(depths_, suns * CLOUD_MARCH_CELLS, first + CLOUD_MARCH_CELLS, cells_);
}

void ResolvedClouds::pair(const ocl::Buffer<float>& values, std::size_t count, std::size_t first,
                          ocl::Buffer<std::uint32_t>& pairs) {
  pairs_kernel_.launch(ocl::launch_shape(cell_tuning_, count), values, static_cast<int>(count),
                       static_cast<int>(first), pairs);
}

void ResolvedClouds::march(const ocl::LaunchShape& shape, CloudImageParams params, const glm::dvec3& eye_m,
                           const ocl::Buffer<float>& scene_depth, ocl::Buffer<std::array<float, 4>>& image,
                           ocl::Buffer<float>& distance_m) {
  const LightFields light = light_->fields();
  const glm::vec3 eye(eye_m - origin_m_);
  params.eye_x_m = eye.x, params.eye_y_m = eye.y, params.eye_z_m = eye.z;
  kernels().source.launch(ocl::launch_shape(cell_tuning_, light_grid_cells(light.cells), volumes_.size()),
                          volumes_buffer_, light.grids, light.absorption, light.glow, light.drift, eye.x,
                          eye.y, eye.z, sources_);
  kernels().march.launch(shape, volumes_buffer_, static_cast<int>(volumes_.size()), cells_, blocks_, sources_,
                         light.grids, light.looks, light.lights, phases_, noise_, scene_depth, params, image,
                         distance_m);
}

}  // namespace offing::clouds
