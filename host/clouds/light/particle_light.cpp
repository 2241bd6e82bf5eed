#include "host/clouds/light/particle_light.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "host/base/error.h"
#include "host/clouds/light/phase_function.h"
#include "host/clouds/light/phase_table.h"

namespace offing::clouds {
namespace {

// EMPTY_DEPTH 1.7, the depths between which sweeps give way to
// diffusion (THIN_DEPTH 1.5, THICK_DEPTH 5) and where a dense particle shows from (FRONT_RADII 1.3,
// FRONT_DEPTH 3) were fitted to the reference over the genera and the shapes of scenes
// (tests/clouds/light_accuracy_test.cpp), and to slabs (particle_light_test.cpp).

// A heap has so many cells; a flat cloud up to the other number (kernels/clouds/light_bounds.cl).
struct CellCounts {
  int of_heap, of_flat;
};
CellCounts wanted_cells(LightCells cells, std::size_t clouds) {
  constexpr int of_heap = billboard_heap_cells, of_flat = light_grid_cells(LightCells::of_billboards);
  if (cells == LightCells::of_billboards) return {of_heap, of_flat};
  const auto finer =
      static_cast<int>(std::bit_floor(std::min(marched_sky_cells / clouds, light_grid_cells(cells))));
  return {std::max(of_heap, finer), std::max(of_flat, finer)};
}

// Of the light that is carried along directions (kernels/clouds/diffusion.clh).
constexpr std::size_t directions = 8, floats4_of_moments = 4;
// Sweeps along the directions, each with diffusion after it.
constexpr int sweeps = 2;
// Clouds whose light is worked out together: what only that takes is kept for so many.
constexpr std::size_t most_at_once = 16;
constexpr std::size_t entry_texels = CLOUD_ENTRY_SIZE * CLOUD_ENTRY_SIZE;
constexpr std::size_t recurrence_texels = CLOUD_HARRIS_SIZE * CLOUD_HARRIS_SIZE;

ocl::Kernel built(const ocl::Device& device, const char* source, const char* kernel,
                  const ocl::KernelTuning& tuning) {
  ocl::Defines defines;
  defines.set("GROUP_SIZE", static_cast<long long>(tuning.group)).set("LANES", tuning.lanes);
  return ocl::Program::build(device, source, defines).kernel(kernel);
}

bool is_finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void require_light(const char* name, const glm::dvec3& value) {
  if (is_finite(value) && std::min({value.x, value.y, value.z}) >= 0.0) return;
  throw Error(ErrorKind::bad_input, fmt::format("{}: expected finite numbers of 0 or more, got ({}, {}, {})",
                                                name, value.x, value.y, value.z));
}

/// With as many suns as asked for: beyond its own, suns that do not shine.
CloudLightParams packed(const CloudIllumination& light, int suns) {
  require_light("sky_kcdpm2", light.sky_kcdpm2);
  require_light("ground_kcdpm2", light.ground_kcdpm2);
  const glm::dvec3 with_clouds_above = light.sky_kcdpm2 + light.clouds_above_kcdpm2,
                   with_clouds_below = light.ground_kcdpm2 + light.clouds_below_kcdpm2;
  require_light("sky_kcdpm2 + clouds_above_kcdpm2", with_clouds_above);
  require_light("ground_kcdpm2 + clouds_below_kcdpm2", with_clouds_below);
  CloudLightParams params{};
  for (const CloudLight& sun : light.suns) {
    require_light("illuminance_klx", sun.illuminance_klx);
    if (!is_finite(sun.direction) || std::abs(glm::length(sun.direction) - 1.0) > 1e-3) {
      throw Error(ErrorKind::bad_input, fmt::format("sun.direction: expected a unit vector, got ({}, {}, {})",
                                                    sun.direction.x, sun.direction.y, sun.direction.z));
    }
    const glm::vec3 direction(sun.direction), colour(sun.illuminance_klx);
    params.suns[params.sun_count++] = {direction.x, direction.y, direction.z, colour.r, colour.g, colour.b};
  }
  for (; params.sun_count < suns; ++params.sun_count) params.suns[params.sun_count].y = 1.0f;
  const glm::vec3 sky(light.sky_kcdpm2), ground(light.ground_kcdpm2);
  params.sky_red = sky.r, params.sky_green = sky.g, params.sky_blue = sky.b;
  params.ground_red = ground.r, params.ground_green = ground.g, params.ground_blue = ground.b;
  const glm::vec3 above(with_clouds_above), below(with_clouds_below);
  params.above_red = above.r, params.above_green = above.g, params.above_blue = above.b;
  params.below_red = below.r, params.below_green = below.g, params.below_blue = below.b;
  return params;
}

}  // namespace

ParticleLight::ParticleLight(const ocl::Device& device, LightCells cells)
    : device_(device),
      cells_(cells),
      density_tuning_(ocl::tuning_for(device.info(), "light_density")),
      cell_tuning_(ocl::tuning_for(device.info(), "light_cells")),
      group_tuning_(ocl::tuning_for(device.info(), "light_groups")),
      scatter_tuning_(ocl::tuning_for(device.info(), "particle_scatter")),
      bounds_kernel_(built(device, "clouds/light_bounds.cl", "light_bounds", group_tuning_)),
      density_kernel_(built(device, "clouds/light_density.cl", "light_density", density_tuning_)),
      entry_kernel_(built(device, "clouds/light_entry.cl", "light_entry", group_tuning_)),
      beam_kernel_(built(device, "clouds/light_beam.cl", "light_beam", group_tuning_)),
      source_kernel_(built(device, "clouds/light_source.cl", "light_source", cell_tuning_)),
      coarsen_kernel_(built(device, "clouds/light_coarsen.cl", "light_coarsen", group_tuning_)),
      emission_kernel_(built(device, "clouds/light_emission.cl", "light_emission", cell_tuning_)),
      sweep_kernel_(built(device, "clouds/light_sweep.cl", "light_sweep", group_tuning_)),
      gather_kernel_(built(device, "clouds/light_gather.cl", "light_gather", cell_tuning_)),
      diffuse_kernel_(built(device, "clouds/light_diffuse.cl", "light_diffuse", group_tuning_)),
      glow_kernel_(built(device, "clouds/light_glow.cl", "light_glow", cell_tuning_)),
      scatter_kernel_(built(device, "clouds/particle_scatter.cl", "particle_scatter", scatter_tuning_)),
      recurrence_kernel_(built(device, "clouds/light_recurrence.cl", "light_recurrence", group_tuning_)),
      first_order_kernel_(
          built(device, "clouds/particle_first_order.cl", "particle_first_order", scatter_tuning_)),
      order_(device),
      recurrence_map_(device, recurrence_texels, "light along the order of particles") {}

void ParticleLight::set_lights(std::span<const CloudIllumination> lights, std::size_t clouds) {
  std::size_t suns = 0;
  for (const CloudIllumination& light : lights) suns = std::max(suns, light.suns.size());
  if (suns > CLOUD_SUNS) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("light of clouds: expected at most {} suns, got {}", CLOUD_SUNS, suns));
  }
  suns_ = static_cast<int>(suns);
  std::vector<CloudLightParams> all;
  for (std::size_t cloud = 0; cloud < clouds; ++cloud)
    all.push_back(packed(lights[lights.size() == 1 ? 0 : cloud], suns_));
  const bool is_known = all.size() == packed_lights_.size() &&
                        std::memcmp(all.data(), packed_lights_.data(), all.size() * sizeof(all[0])) == 0;
  if (is_known) return;  // a write waits for the device
  if (lights_.size() < clouds) lights_ = ocl::Buffer<CloudLightParams>(device_, clouds, "light on clouds");
  lights_.write(all);
  packed_lights_ = std::move(all);
}

void ParticleLight::set_looks(std::span<const CloudLook> looks) {
  if (std::equal(looks.begin(), looks.end(), known_looks_.begin(), known_looks_.end())) return;
  std::vector<CloudScattering> scattering;
  std::vector<CloudLook> tabled;
  std::vector<float> phases;
  for (const CloudLook& look : looks) {
    const PhaseFunction phase(look);
    const auto known = std::find(tabled.begin(), tabled.end(), look);
    const auto table = static_cast<std::uint32_t>(known - tabled.begin());
    if (known == tabled.end()) {
      tabled.push_back(look);
      const std::vector<float> values = phase_table(phase);
      phases.insert(phases.end(), values.begin(), values.end());
    }
    const DeltaScaling scaling = delta_scaling(phase);
    scattering.push_back({static_cast<float>(1.0 - look.albedo.x), static_cast<float>(scaling.forward_share),
                          static_cast<float>(scaling.scaled_mean_cosine), table});
  }
  looks_ = ocl::Buffer<CloudScattering>(device_, scattering, "looks of clouds");
  phases_ = ocl::Buffer<float>(device_, phases, "phase tables of clouds");
  known_looks_.assign(looks.begin(), looks.end());
}

void ParticleLight::reserve(std::size_t clouds) {
  if (clouds > grids_.size()) grids_ = ocl::Buffer<CloudGrid>(device_, clouds, "grids of clouds");
  const auto channels_of_cloud = static_cast<std::size_t>(channels_);
  const std::size_t channels = clouds * channels_of_cloud, beams = channels * static_cast<std::size_t>(suns_),
                    at_once = std::min(clouds, most_at_once);
  const std::size_t room = light_grid_cells(cells_);
  const std::tuple<ocl::Buffer<float>*, std::size_t, const char*> arrays[] = {
      {&medium_, clouds * CLOUD_MEDIUM_CELLS(room), "extinction in clouds"},
      {&absorption_, channels * CLOUD_MEDIUM_CELLS(room), "absorption in clouds"},
      {&faces_, at_once * channels_of_cloud * CLOUD_LEVEL_CELLS(room) * 4, "levels of clouds"},
      {&sources_, at_once * CLOUD_LEVEL_CELLS(room) * 3, "sources of light in clouds"},
      {&fluence_, at_once * CLOUD_LEVEL_CELLS(room) * 3, "fluence in clouds"},
      {&planes_, at_once * directions * 2 * 3 * CLOUD_RIMMED_CELLS(room), "planes of light in clouds"},
      {&beams_, beams * room + 2 * CLOUD_BEAM_MARGIN, "sunlight in clouds"},
      {&entries_, std::max<std::size_t>(beams, 1) * entry_texels, "sunlight between clouds"}};
  for (const auto& [buffer, size, name] : arrays) {
    if (size <= buffer->size()) continue;
    *buffer = ocl::Buffer<float>(device_, size, name);
    buffer->fill(0.0f);  // what stands for neighbours outside must be numbers
  }
  const std::tuple<ocl::Buffer<Float4>*, std::size_t, const char*> lights[] = {
      {&glow_, clouds * room, "scattered light in clouds"},
      {&drift_, channels * room, "drift of light in clouds"},
      {&moments_, at_once * room * floats4_of_moments, "moments of light in clouds"},
      {&emission_, at_once * room * floats4_of_moments, "emission of clouds"},
      {&radiances_, at_once * room * directions, "radiances in clouds"}};
  for (const auto& [buffer, size, name] : lights) {
    if (size > buffer->size()) *buffer = ocl::Buffer<Float4>(device_, size, name);
  }
}

void ParticleLight::relight(const ocl::Buffer<CloudParticle>& particles, std::uint32_t count,
                            std::span<const CloudIllumination> lights, std::span<const CloudLook> looks,
                            LightModel model, ParticleAlbedo albedo) {
  start_relight(particles, count, lights, looks, model, albedo);
  while (relight_further()) {
  }
}

void ParticleLight::start_relight(const ocl::Buffer<CloudParticle>& particles, std::uint32_t count,
                                  std::span<const CloudIllumination> lights, std::span<const CloudLook> looks,
                                  LightModel model, ParticleAlbedo albedo) {
  if (count > particles.size() || looks.empty() || (lights.size() != 1 && lights.size() != looks.size())) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("light of clouds: expected at most {} particles, a look, and a light for each or "
                            "for all, got {}, {} and {}",
                            particles.size(), count, looks.size(), lights.size()));
  }
  steps_.clear();
  steps_done_ = 0;
  const auto is_grey = [](const CloudLook& look) {
    return look.albedo.x == look.albedo.y && look.albedo.y == look.albedo.z;
  };
  const bool has_colours = albedo == ParticleAlbedo::own || !std::all_of(looks.begin(), looks.end(), is_grey);
  channels_ = has_colours ? 3 : 1;
  set_lights(lights, looks.size());
  set_looks(looks);
  reserve(looks.size());
  particles_ = &particles;
  count_ = count;
  if (count == 0) return;

  model_ = model;
  const std::size_t clouds = looks.size();
  add_step([this, clouds] {
    const CellCounts wanted = wanted_cells(cells_, clouds);
    bounds_kernel_.launch({{clouds * group_tuning_.group}, {group_tuning_.group}}, *particles_,
                          static_cast<int>(count_), static_cast<int>(light_grid_cells(cells_)),
                          wanted.of_heap, wanted.of_flat, grids_);
  });
  if (model == LightModel::calibrated) {
    diffuse(clouds);
  } else {
    carry_along(lights, clouds);
  }
}

bool ParticleLight::relight_further() {
  if (steps_done_ < steps_.size()) steps_[steps_done_++]();
  return steps_done_ < steps_.size();
}

void ParticleLight::diffuse(std::size_t clouds) {
  const auto channels = static_cast<std::size_t>(channels_);
  const auto groups = [this, clouds](std::size_t number) -> ocl::LaunchShape {
    return {{number * group_tuning_.group, clouds}, {group_tuning_.group}};
  };
  add_step([this, clouds] {
    density_kernel_.launch(ocl::launch_shape(density_tuning_, light_grid_cells(cells_), clouds), *particles_,
                           grids_, looks_, channels_, medium_, absorption_);
  });
  if (suns_ > 0) {
    const ocl::LaunchShape each_beam = groups(static_cast<std::size_t>(suns_) * channels);
    const auto number = static_cast<int>(clouds);
    if (clouds > 1) {
      add_step([this, each_beam, number] {
        entry_kernel_.launch(each_beam, grids_, looks_, lights_, medium_, absorption_, number, channels_,
                             entries_);
      });
    }
    add_step([this, each_beam, number] {
      beam_kernel_.launch(each_beam, grids_, looks_, lights_, medium_, absorption_, entries_, number,
                          channels_, beams_);
    });
  }
  for (std::size_t first = 0; first < clouds; first += most_at_once)
    scatter_often(first, std::min(most_at_once, clouds - first));
}

void ParticleLight::scatter_often(std::size_t first, std::size_t number) {
  const auto groups = [this, number](std::size_t count) -> ocl::LaunchShape {
    return {{count * group_tuning_.group, number}, {group_tuning_.group}};
  };
  const ocl::LaunchShape each_cell = ocl::launch_shape(cell_tuning_, light_grid_cells(cells_), number);
  const auto first_cloud = static_cast<int>(first);
  const auto add_diffusion = [&] {
    add_step([this, groups, first_cloud] {
      diffuse_kernel_.launch(groups(3), grids_, faces_, first_cloud, channels_, sources_, fluence_);
    });
  };
  add_step([this, groups, each_cell, first_cloud] {
    source_kernel_.launch(each_cell, grids_, looks_, lights_, medium_, absorption_, beams_, first_cloud,
                          channels_, faces_, sources_);
    coarsen_kernel_.launch(groups(static_cast<std::size_t>(channels_)), grids_, first_cloud, faces_);
  });
  add_diffusion();
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    add_step([this, each_cell, first_cloud, sweep] {
      emission_kernel_.launch(each_cell, grids_, looks_, lights_, medium_, absorption_, beams_, faces_,
                              fluence_, first_cloud, channels_, static_cast<int>(sweep == 0), moments_,
                              emission_);
    });
    add_step([this, groups, each_cell, first_cloud] {
      sweep_kernel_.launch(groups(directions), grids_, lights_, emission_, first_cloud, channels_, planes_,
                           radiances_);
      gather_kernel_.launch(each_cell, grids_, looks_, medium_, absorption_, radiances_, first_cloud,
                            channels_, moments_, sources_);
    });
    add_diffusion();
  }
  add_step([this, each_cell, first_cloud] {
    glow_kernel_.launch(each_cell, grids_, looks_, medium_, faces_, fluence_, moments_, first_cloud,
                        channels_, glow_, drift_);
  });
}

void ParticleLight::carry_along(std::span<const CloudIllumination> lights, std::size_t clouds) {
  if (suns_ > 1) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("light of clouds: harris: expected at most 1 sun, got {}", suns_),
                "use the calibrated model");
  }
  if (reached_.size() < count_) reached_ = ocl::Buffer<float>(device_, count_, "sunlight on particles");
  const auto lit =
      std::find_if(lights.begin(), lights.end(), [](const auto& light) { return !light.suns.empty(); });
  if (lit == lights.end()) return;
  // Clouds differ in how bright it is.
  const glm::vec3 way(lit->suns.front().direction);
  add_step([this, way, clouds] {
    order_.along_light(*particles_, count_, way);
    recurrence_kernel_.launch({{group_tuning_.group}, {group_tuning_.group}}, *particles_,
                              static_cast<int>(count_), order_.order(), grids_, static_cast<int>(clouds),
                              looks_, phases_, way.x, way.y, way.z, recurrence_map_, reached_);
  });
}

glm::dvec3 ParticleLight::first_sun() const {
  if (suns_ == 0) return {0.0, 1.0, 0.0};
  // Clouds differ in how bright it is.
  const CloudLightSource& sun = packed_lights_.front().suns[0];
  return glm::normalize(glm::dvec3(sun.x, sun.y, sun.z));
}

std::optional<CloudBox> ParticleLight::box() const {
  if (count_ == 0) return std::nullopt;
  std::optional<CloudBox> box;
  const std::vector<CloudGrid> grids = grids_.read();
  for (std::size_t cloud = 0; cloud < known_looks_.size(); ++cloud) {
    const CloudGrid& grid = grids[cloud];
    if (grid.first == grid.end) continue;
    const glm::vec3 low_m(grid.low_x, grid.low_y, grid.low_z);
    const glm::vec3 high_m = low_m + glm::vec3(grid.size_x, grid.size_y, grid.size_z) *
                                         glm::vec3(grid.cell_x, grid.cell_y, grid.cell_z);
    box =
        box ? CloudBox{glm::min(box->low_m, low_m), glm::max(box->high_m, high_m)} : CloudBox{low_m, high_m};
  }
  return box;
}

void ParticleLight::see(const glm::vec3& eye_m, ocl::Buffer<CloudSprite>& sprites, Part part) {
  if (count_ > sprites.size()) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("light of clouds: expected at least {} sprites, got {}", count_, sprites.size()));
  }
  const auto bound = [&](std::uint32_t index) {
    return static_cast<std::uint32_t>(std::uint64_t{count_} * index / part.of);
  };
  const std::uint32_t first = bound(part.index), end = bound(part.index + 1);
  if (first == end) return;
  const ocl::LaunchShape shape = ocl::launch_shape(scatter_tuning_, end - first);
  if (model_ == LightModel::harris) {
    first_order_kernel_.launch(shape, *particles_, static_cast<int>(first), static_cast<int>(end),
                               scatter_tuning_.per_item, looks_, lights_, phases_, reached_, eye_m.x, eye_m.y,
                               eye_m.z, sprites);
    return;
  }
  scatter_kernel_.launch(shape, *particles_, static_cast<int>(first), static_cast<int>(end),
                         scatter_tuning_.per_item, grids_, looks_, lights_, phases_, absorption_, beams_,
                         glow_, drift_, channels_, eye_m.x, eye_m.y, eye_m.z, sprites);
}

}  // namespace offing::clouds
