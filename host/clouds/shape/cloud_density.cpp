#include "host/clouds/shape/cloud_density.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "host/base/error.h"
#include "host/base/parameter_check.h"
#include "host/clouds/light/field_albedo.h"
#include "host/clouds/particles/cloud_model.h"
#include "host/clouds/particles/cloud_particle.h"
#include "host/clouds/particles/particle_motion.h"
#include "host/clouds/shape/ball_bins.h"
#include "host/clouds/shape/metaball.h"
#include "host/clouds/shape/noise_octaves.h"
#include "host/ocl/buffer.h"
#include "host/ocl/program.h"
#include "host/ocl/tuning.h"
#include "kernels/shared/cloud_field.h"

namespace offing::clouds {
namespace {

// Bricks a launch: 8 MiB of cells, so that a volume is never on device and host twice, and that slow devices
// can be stopped within a second or so.
constexpr std::size_t bricks_a_launch = std::size_t{1} << 12;
constexpr std::size_t rows_of_brick = CLOUD_BRICK_CELLS * CLOUD_BRICK_CELLS;

/// The kernel for a device, and how many of its work-items share a brick.
struct DensityKernel {
  ocl::Kernel kernel;
  std::size_t group;

  DensityKernel(const ocl::Device& device, ocl::Defines defines)
      : group(ocl::tuning_for(device.info(), "cloud_density").group) {
    defines.set("ROWS", static_cast<long long>(rows_of_brick / group));
    kernel = ocl::Program::build(device, "clouds/cloud_density.cl", defines).kernel("cloud_density");
  }

  ocl::LaunchShape shape(std::size_t bricks) const { return {{bricks * group}, {group}}; }
};

template <typename T>
ocl::Buffer<T> uploaded(const ocl::Device& device, std::span<const T> values, const char* name) {
  const T nothing{};
  return ocl::Buffer<T>(device, values.empty() ? std::span<const T>(&nothing, 1) : values, name);
}

/// Launches for some bricks at a time and keeps those with any density, while the next are computed.
/// launch(first, count, density): bricks first ... first + count of brick_index; returns what it reads of its
/// own.
template <typename Launch>
CloudVolume collected(const ocl::Device& device, const BrickGrid& grid,
                      std::span<const std::uint32_t> brick_index, const Work& work, const Launch& launch) {
  require_holdable(brick_index.size(), grid.cell_m);
  CloudVolume volume;
  volume.cell_m = grid.cell_m;
  volume.bricks = grid.bricks;
  volume.brick_of.assign(grid.brick_count(), CloudVolume::no_brick);
  volume.density.reserve(brick_index.size() * CloudVolume::cells_of_brick);
  const std::size_t most = std::min(bricks_a_launch, brick_index.size());
  if (most == 0) return volume;
  std::array<ocl::Buffer<float>, 2> densities;
  for (auto& density : densities)
    density = ocl::Buffer<float>(device, most * CloudVolume::cells_of_brick, "cloud density");
  const auto count_from = [&](std::size_t first) { return std::min(most, brick_index.size() - first); };
  std::array<decltype(launch(0, most, densities[0])), 2> read{launch(0, most, densities[0])};
  std::int32_t kept = 0;
  for (std::size_t first = 0, turn = 0; first < brick_index.size(); first += most, turn ^= 1) {
    const std::size_t count = count_from(first), next = first + most;
    work.tell(static_cast<double>(first) / static_cast<double>(brick_index.size()));
    const auto view = densities[turn].map();  // waits for it
    if (next < brick_index.size()) {
      read[turn ^ 1] = {};  // whose end waits for all that is enqueued
      read[turn ^ 1] = launch(next, count_from(next), densities[turn ^ 1]);
    }
    for (std::size_t i = 0; i < count; ++i) {
      const auto cells = view.span().subspan(i * CloudVolume::cells_of_brick, CloudVolume::cells_of_brick);
      if (std::all_of(cells.begin(), cells.end(), [](float value) { return value == 0.0f; })) continue;
      volume.brick_of[brick_index[first + i]] = kept++;
      volume.density.insert(volume.density.end(), cells.begin(), cells.end());
    }
  }
  return volume;
}

CloudFieldParams field_params(const BrickGrid& grid) {
  return {.cell_m = static_cast<float>(grid.cell_m),
          .blend = 0.0f,
          .strength = 0.0f,
          .wisp = 1.0f,
          .edge = 1.0f,
          .octaves = 0,
          .seed_low = 0,
          .seed_high = 0,
          .bricks_x = grid.bricks[0],
          .bricks_y = grid.bricks[1]};
}

CloudFieldParams field_params(const BrickGrid& grid, const CloudParameters& parameters, std::size_t octaves) {
  CloudFieldParams params = field_params(grid);
  params.blend = static_cast<float>(parameters.turbulence.blend);
  params.strength = static_cast<float>(parameters.turbulence.strength);
  params.wisp = static_cast<float>(parameters.turbulence.wisp);
  params.edge = static_cast<float>(parameters.turbulence.edge);
  params.octaves = static_cast<int>(octaves);
  params.seed_low = static_cast<std::uint32_t>(parameters.seed);
  params.seed_high = static_cast<std::uint32_t>(parameters.seed >> 32);
  return params;
}

/// Sums of balls, places relative to the grid, frayed by octaves.
CloudVolume volume_of_balls(const ocl::Device& device, const BrickGrid& grid,
                            std::span<const CloudBall> balls, const CloudFieldParams& params,
                            std::span<const CloudOctave> octaves, const Work& work) {
  const BallBins bins = ball_bins(grid, balls);
  const DensityKernel density_kernel(device, {});
  const auto device_balls = uploaded(device, balls, "metaballs");
  const auto device_octaves = uploaded(device, octaves, "octaves of noise");
  const auto entries = uploaded(device, std::span<const std::uint32_t>(bins.balls), "balls of bricks");
  return collected(
      device, grid, bins.brick_index, work,
      [&](std::size_t first, std::size_t count, const ocl::Buffer<float>& density) {
        std::array lists{
            uploaded(device, std::span(bins.brick_index).subspan(first, count), "bricks"),
            uploaded(device, std::span(bins.begin).subspan(first, count + 1), "lists of bricks")};
        density_kernel.kernel.launch(density_kernel.shape(count), params, device_octaves, lists[0], lists[1],
                                     entries, device_balls, density);
        return lists;
      });
}

/// Bricks of the grid that a brick of the shape reaches, half a cell beyond its own cells.
std::vector<std::uint32_t> bricks_of_shape(const BrickGrid& grid, const CloudVolume& shape) {
  std::vector<std::uint8_t> touched(grid.brick_count(), 0);
  const double brick_m = grid.cell_m * CLOUD_BRICK_CELLS, shape_brick_m = shape.cell_m * CLOUD_BRICK_CELLS;
  std::size_t number = 0;
  for (int z = 0; z < shape.bricks[2]; ++z) {
    for (int y = 0; y < shape.bricks[1]; ++y) {
      for (int x = 0; x < shape.bricks[0]; ++x) {
        if (shape.brick_of[number++] == CloudVolume::no_brick) continue;
        const glm::dvec3 low_m =
            shape.origin_m - grid.corner_m + glm::dvec3(x, y, z) * shape_brick_m - 0.5 * shape.cell_m;
        const glm::dvec3 first = glm::max(glm::floor(low_m / brick_m), glm::dvec3(0.0));
        const glm::dvec3 last = glm::min(glm::floor((low_m + shape_brick_m + shape.cell_m) / brick_m),
                                         glm::dvec3(grid.bricks[0], grid.bricks[1], grid.bricks[2]) - 1.0);
        for (int k = static_cast<int>(first.z); k <= static_cast<int>(last.z); ++k) {
          for (int j = static_cast<int>(first.y); j <= static_cast<int>(last.y); ++j) {
            for (int i = static_cast<int>(first.x); i <= static_cast<int>(last.x); ++i) {
              touched[(static_cast<std::size_t>(k) * static_cast<std::size_t>(grid.bricks[1]) +
                       static_cast<std::size_t>(j)) *
                          static_cast<std::size_t>(grid.bricks[0]) +
                      static_cast<std::size_t>(i)] = 1;
            }
          }
        }
      }
    }
  }
  std::vector<std::uint32_t> bricks;
  for (std::size_t brick = 0; brick < touched.size(); ++brick) {
    if (touched[brick] != 0) bricks.push_back(static_cast<std::uint32_t>(brick));
  }
  return bricks;
}

CloudVolume volume_of_shape(const ocl::Device& device, const BrickGrid& grid, const CloudVolume& shape,
                            const CloudFieldParams& params, std::span<const CloudOctave> octaves,
                            const Work& work) {
  const std::vector<std::uint32_t> bricks = bricks_of_shape(grid, shape);
  const DensityKernel density_kernel(device, ocl::Defines().set_flag("SHAPE"));
  const auto device_octaves = uploaded(device, octaves, "octaves of noise");
  const auto brick_of =
      uploaded(device, std::span<const std::int32_t>(shape.brick_of), "bricks of the shape");
  const auto values = uploaded(device, std::span<const float>(shape.density), "density of the shape");
  const glm::vec3 corner((shape.origin_m - grid.corner_m) / grid.cell_m);
  return collected(device, grid, bricks, work,
                   [&](std::size_t first, std::size_t count, const ocl::Buffer<float>& density) {
                     ocl::Buffer<std::uint32_t> index(device, std::span(bricks).subspan(first, count),
                                                      "bricks");
                     density_kernel.kernel.launch(density_kernel.shape(count), params, device_octaves, index,
                                                  brick_of, values, shape.bricks[0], shape.bricks[1],
                                                  shape.bricks[2], corner.x, corner.y, corner.z,
                                                  static_cast<float>(shape.cell_m / grid.cell_m), density);
                     return index;
                   });
}

CloudBall relative(const glm::dvec3& centre_m, double radius_m, double weight, const BrickGrid& grid) {
  const glm::vec3 place(centre_m - grid.corner_m);
  return {place.x, place.y, place.z, static_cast<float>(radius_m), static_cast<float>(weight)};
}

}  // namespace

CloudVolume field_volume(const ocl::Device& device, const CloudParameters& parameters, double cell_m,
                         double time_s, const Work& work) {
  require_valid(parameters);
  require_within("cloud.cell_m", cell_m, 1e-3, 1e5);
  CloudVolume volume;
  BrickGrid grid;
  const auto octaves_on = [&] {
    if (parameters.turbulence.blend == 0.0) return std::vector<CloudOctave>();
    return noise_octaves(parameters.turbulence, parameters.seed, grid.corner_m + 0.5 * cell_m, cell_m,
                         time_s);
  };
  if (parameters.shape) {
    const CloudVolume& shape = *parameters.shape;
    const glm::dvec3 size_m =
        glm::dvec3(shape.bricks[0], shape.bricks[1], shape.bricks[2]) * (shape.cell_m * CLOUD_BRICK_CELLS);
    grid = grid_around(shape.origin_m - 0.5 * shape.cell_m, shape.origin_m + size_m + 0.5 * shape.cell_m,
                       cell_m);
    const std::vector<CloudOctave> octaves = octaves_on();
    volume =
        volume_of_shape(device, grid, shape, field_params(grid, parameters, octaves.size()), octaves, work);
    if (!shape.albedo.empty()) {
      volume.origin_m = grid.corner_m;
      volume.albedo = field_albedo(shape, volume);
    }
  } else {
    glm::dvec3 low_m(0.0), high_m(0.0);
    for (std::size_t i = 0; i < parameters.balls.size(); ++i) {
      const Metaball& ball = parameters.balls[i];
      low_m = i == 0 ? ball.centre_m - ball.radius_m : glm::min(low_m, ball.centre_m - ball.radius_m);
      high_m = i == 0 ? ball.centre_m + ball.radius_m : glm::max(high_m, ball.centre_m + ball.radius_m);
    }
    grid = grid_around(low_m, high_m, cell_m);
    std::vector<CloudBall> balls;
    for (const Metaball& ball : parameters.balls) {
      balls.push_back(relative(ball.centre_m, ball.radius_m, ball.weight, grid));
    }
    const std::vector<CloudOctave> octaves = octaves_on();
    volume =
        volume_of_balls(device, grid, balls, field_params(grid, parameters, octaves.size()), octaves, work);
  }
  volume.origin_m = cloud_origin_m(parameters, time_s) + grid.corner_m;
  volume.extinction_per_m = parameters.look.extinction_per_m;
  return volume;
}

CloudVolume rasterised(const ocl::Device& device, std::span<const CloudParticle> particles, double cell_m,
                       double extinction_per_m) {
  require_within("cloud.cell_m", cell_m, 1e-3, 1e5);
  require_within("cloud.extinction_per_m", extinction_per_m, 1e-12, 1e12);
  // No ball of this radius falls between the middles of cells, which are sqrt(3) / 2 from a cell's corner.
  const auto radius_m = [&](const CloudParticle& particle) {
    return std::fmax(static_cast<double>(particle.radius), cell_m);
  };
  glm::dvec3 low_m(0.0), high_m(0.0);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    require_valid(particles[i], i);
    const glm::dvec3 centre_m(particles[i].x, particles[i].y, particles[i].z);
    low_m = i == 0 ? centre_m - radius_m(particles[i]) : glm::min(low_m, centre_m - radius_m(particles[i]));
    high_m = i == 0 ? centre_m + radius_m(particles[i]) : glm::max(high_m, centre_m + radius_m(particles[i]));
  }
  const BrickGrid grid = grid_around(low_m, high_m, cell_m);
  std::vector<CloudBall> balls;
  for (const CloudParticle& particle : particles) {
    balls.push_back(relative({particle.x, particle.y, particle.z}, radius_m(particle), 0.0, grid));
  }
  if (!balls.empty()) {
    const auto device_balls = uploaded(device, std::span<const CloudBall>(balls), "particles");
    const ocl::Buffer<float> sums(device, balls.size(), "sums of particles");
    ocl::Program::build(device, "clouds/ball_sum.cl")
        .kernel("ball_sum")
        .launch({{balls.size()}}, device_balls, static_cast<float>(cell_m), sums);
    const std::vector<float> found = sums.read();
    for (std::size_t i = 0; i < balls.size(); ++i) {
      const double volume_m3 = static_cast<double>(found[i]) * cell_m * cell_m * cell_m;
      balls[i].weight =
          static_cast<float>(static_cast<double>(particles[i].optical_mass) / (volume_m3 * extinction_per_m));
    }
  }
  CloudVolume volume = volume_of_balls(device, grid, balls, field_params(grid), {}, {});
  volume.origin_m = grid.corner_m;
  volume.extinction_per_m = extinction_per_m;
  return volume;
}

double optical_mass(const CloudVolume& volume) {
  double sum = 0.0;
  for (const float density : volume.density) sum += static_cast<double>(density);
  return sum * volume.cell_m * volume.cell_m * volume.cell_m * volume.extinction_per_m;
}

CloudVolume density_volume(const ocl::Device& device, const CloudParameters& parameters, double cell_m,
                           double time_s) {
  if (parameters.modelling == Modelling::sampled || parameters.shape) {
    return field_volume(device, parameters, cell_m, time_s);
  }
  CloudModel model(device, parameters);
  const glm::dvec3 origin_m = cloud_origin_m(parameters, time_s);
  model.at(time_s, origin_m);
  std::vector<CloudParticle> particles = model.particles().read();
  particles.resize(model.count());
  CloudVolume volume = rasterised(device, particles, cell_m, parameters.look.extinction_per_m);
  volume.origin_m += origin_m;
  return volume;
}

}  // namespace offing::clouds
