#include "host/clouds/particles/cloud_model.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/time_estimate.h"
#include "host/clouds/particles/cloud_particle.h"
#include "host/clouds/particles/hierarchy.h"
#include "host/clouds/particles/particle_thinning.h"
#include "host/clouds/particles/sampled_particles.h"
#include "host/clouds/shape/cloud_density.h"
#include "host/clouds/shape/metaball.h"

namespace offing::clouds {
namespace {

// Cells with density that a particle is merged from, about, and how near to that is near enough.
constexpr double cells_a_particle = 20.0;
constexpr double fewest_cells_a_particle = 8.0, most_cells_a_particle = 40.0;
// What hangs below the base is pressed to this share of its depth.
constexpr double pressed_share = 0.1;

std::size_t cells_with_density(const CloudVolume& volume) {
  return static_cast<std::size_t>(std::count_if(volume.density.begin(), volume.density.end(),
                                                [](float density) { return density > 0.0f; }));
}

/// The field in cells such that there are some for each particle.
CloudVolume volume_to_sample(const ocl::Device& device, const CloudParameters& parameters, const Work& work) {
  double volume_m3 = 0.0;
  for (const Metaball& ball : parameters.balls) {
    volume_m3 += 4.0 / 3.0 * std::numbers::pi * std::pow(ball.radius_m, 3);
  }
  if (parameters.shape) {
    volume_m3 = static_cast<double>(parameters.shape->density.size()) * std::pow(parameters.shape->cell_m, 3);
  }
  double cell_m = std::cbrt(std::max(volume_m3, 1e-9) / (cells_a_particle * parameters.target_particles));
  constexpr int rounds = 3;
  const auto part = [&](int round) {
    return work.part(round / (rounds + 1.0), (round + 1) / (rounds + 1.0));
  };
  CloudVolume volume = field_volume(device, parameters, std::max(cell_m, 1e-3), 0.0, part(0));
  // Balls overlap and shapes fill their bricks in part: the true volume is known from the field alone.
  for (int round = 1; round <= rounds; ++round) {
    const double found = static_cast<double>(cells_with_density(volume)) / parameters.target_particles;
    if (found == 0.0 || (found >= fewest_cells_a_particle && found <= most_cells_a_particle)) break;
    cell_m *= std::cbrt(found / cells_a_particle);
    volume = field_volume(device, parameters, std::max(cell_m, 1e-3), 0.0, part(round));
  }
  return volume;
}

/// Before minutes are spent on them.
void require_room(const ocl::Device& device, const CloudParameters& parameters) {
  const ocl::DeviceInfo& info = device.info();
  const std::uint64_t bytes = static_cast<std::uint64_t>(parameters.target_particles) * sizeof(CloudParticle);
  if (bytes <= info.max_allocation_bytes) return;
  constexpr std::uint64_t megabyte = 1'000'000;
  throw Error(
      ErrorKind::out_of_memory,
      fmt::format("cloud.target_particles: {} particles take {} MB, more than the {} MB that {} holds "
                  "in one piece",
                  parameters.target_particles, bytes / megabyte, info.max_allocation_bytes / megabyte,
                  info.name),
      "ask for fewer, or lower clouds.quality");
}

std::vector<CloudParticle> sampled(const ocl::Device& device, const CloudParameters& parameters,
                                   const Work& work) {
  require_room(device, parameters);
  constexpr double share_of_field = 0.2;
  CloudVolume field;
  const bool takes_cells = parameters.shape && parameters.takes_cells_of_shape;
  try {
    if (!takes_cells) field = volume_to_sample(device, parameters, work.part(0.0, share_of_field));
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::bad_input) throw;
    // Cells follow from the target: nobody gave them.
    throw Error(error.kind(), error.what(),
                "ask for fewer cloud.target_particles, or bring its parts closer together");
  }
  const CloudVolume& volume = takes_cells ? *parameters.shape : field;
  std::vector<CloudParticle> particles = sampled_particles(volume,
                                                           {.sampling = parameters.sampling,
                                                            .target_particles = parameters.target_particles,
                                                            .seed = parameters.seed},
                                                           parameters.look, work.part(share_of_field, 1.0));
  const glm::vec3 shift(volume.origin_m);
  for (CloudParticle& particle : particles) {
    particle.x += shift.x;
    particle.y += shift.y;
    particle.z += shift.z;
  }
  return particles;
}

std::vector<CloudParticle> hierarchical(const CloudParameters& parameters, const Work& work) {
  const std::vector<HierarchyParticle> grown =
      grown_hierarchy(parameters.balls, parameters.levels, parameters.seed, work);
  std::vector<double> weights(grown.size());  // of the seed that each comes from
  std::vector<CloudParticle> particles;
  for (std::size_t i = 0; i < grown.size(); ++i) {
    const HierarchyParticle& particle = grown[i];
    weights[i] =
        particle.parent < 0 ? parameters.balls[i].weight : weights[static_cast<std::size_t>(particle.parent)];
    glm::dvec3 place_m = particle.centre_m;
    if (parameters.base_m) {
      // Pressed by its lower rim, so that all of it lies above.
      const double lowest_m = place_m.y - 0.7 * particle.radius_m;
      if (lowest_m < *parameters.base_m) {
        place_m.y += (1.0 - pressed_share) * (*parameters.base_m - lowest_m);
      }
    }
    const double optical_mass_m2 =
        parameters.look.extinction_per_m * weights[i] * ball_mass * std::pow(particle.radius_m, 3);
    particles.push_back(cloud_particle(place_m, particle.radius_m, optical_mass_m2, parameters.look,
                                       {parameters.seed, static_cast<std::uint32_t>(i)}));
  }
  return particles;
}

bool grows(const CloudParameters& parameters) {
  return parameters.modelling == Modelling::hierarchical && !parameters.shape;
}

/// Where it is would round the places of its particles.
CloudParameters at_origin(CloudParameters parameters) {
  parameters.position_m = glm::dvec3(0.0);
  parameters.motion = {};
  return parameters;
}

ocl::Buffer<CloudParticle> uploaded(const ocl::Device& device, std::span<const CloudParticle> particles) {
  const CloudParticle none{};
  return {device, particles.empty() ? std::span(&none, 1) : particles, "cloud particles at rest"};
}

}  // namespace

std::vector<CloudParticle> particles_at_rest(const ocl::Device& device, const CloudParameters& parameters,
                                             const Work& work) {
  require_valid(parameters);
  return grows(parameters) ? hierarchical(parameters, work) : sampled(device, at_origin(parameters), work);
}

void require_short_sampling(const ocl::Device& device, const CloudParameters& parameters) {
  constexpr int tried = 4000, few = 10 * tried;
  const bool takes_cells = parameters.shape && parameters.takes_cells_of_shape;
  if (grows(parameters) || takes_cells || parameters.target_particles <= few) return;
  require_room(device, parameters);
  CloudParameters part = parameters;
  part.target_particles = tried;
  using Clock = std::chrono::steady_clock;
  Clock::time_point start;
  for (int round = 0; round < 2; ++round) {  // the first one compiles kernels
    start = Clock::now();
    particles_at_rest(device, part);
  }
  const double elapsed_s = std::chrono::duration<double>(Clock::now() - start).count();
  // Merging sorts pairs of cells, which outgrow the caches. Measured from 4000 to 60000 particles: 0.4, 0.9,
  // 2.6, 6.6 and 15.6 s, the power 1.35.
  const double growth = std::pow(static_cast<double>(parameters.target_particles) / tried, 4.0 / 3.0);
  require_short_wait(elapsed_s * growth,
                     fmt::format("cloud.target_particles: {} particles", parameters.target_particles),
                     "ask for fewer, or lower clouds.quality");
}

CloudModel::CloudModel(const ocl::Device& device, const CloudParameters& parameters, std::uint32_t cloud)
    : CloudModel(device, parameters, particles_at_rest(device, parameters), cloud) {}

CloudModel::CloudModel(const ocl::Device& device, const CloudParameters& parameters,
                       std::span<const CloudParticle> at_rest, std::uint32_t cloud)
    : CloudModel(device, edited_particles(at_rest, parameters.edits), parameters, cloud) {}

CloudModel::CloudModel(const ocl::Device& device, std::span<const CloudParticle> edited,
                       const CloudParameters& parameters, std::uint32_t cloud)
    : parameters_(parameters),
      count_(static_cast<std::uint32_t>(edited.size())),
      cloud_(cloud),
      extent_(extent_of(edited)),
      motion_(device),
      rest_(uploaded(device, edited)),
      moved_(device, rest_.size(), "cloud particles") {
  require_valid(parameters);
  float densest = 0.0f;
  for (const CloudParticle& particle : edited) {
    densest = std::max(densest, particle.optical_mass / (particle.radius * particle.radius));
  }
  if (densest > 0.0f) densest_ = densest;
  const glm::vec3 albedo(parameters.look.albedo);
  has_own_albedo_ = std::any_of(edited.begin(), edited.end(), [&](const CloudParticle& particle) {
    return glm::vec3(particle.red, particle.green, particle.blue) != albedo;
  });
}

CloudModel CloudModel::thinned(const ocl::Device& device, int halvings) const {
  const std::vector<CloudParticle> whole = rest_.read();
  CloudModel model(device, thinned_particles(std::span(whole).first(count_), halvings), parameters_, cloud_);
  // The wind drags ahead what is thin beside this. Joined ones have 2^h times the mass, and radii 2^(h/3)
  // times.
  model.densest_ = densest_ * static_cast<float>(std::exp2(halvings / 3.0));
  return model;
}

void CloudModel::at(double time_s, const glm::dvec3& origin_m) {
  at(time_s, origin_m, moved_, 0);
}

void CloudModel::at(double time_s, const glm::dvec3& origin_m, const ocl::Buffer<CloudParticle>& target,
                    std::uint32_t first) const {
  if (count_ == 0) return;
  motion_.move(parameters_, time_s, origin_m, densest_, cloud_, rest_, first, target);
}

}  // namespace offing::clouds
