#include "host/clouds/particles/sampled_particles.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/parameter_check.h"
#include "host/clouds/particles/cloud_particle.h"
#include "host/clouds/particles/random_draws.h"
#include "host/clouds/particles/sample_merging.h"
#include "host/clouds/shape/metaball.h"

namespace offing::clouds {
namespace {

// Cells a particle that merging starts from: enough that where they are does not show.
constexpr std::size_t cells_a_particle = 40;
// Radii, in those that spread a particle's mass just as far as the cells that it stands for. Those of 1 leave
// an even density with ripples of 25 %, one sees each; of 1.6 7 %; of 2 edges are blurred more than ripples
// fall.
constexpr double overlap = 1.6;
// Most that random sampling walks through: 1 GiB, and as much again while they are sorted.
constexpr std::size_t most_cells = std::size_t{1} << 24;

/// The bits of a number, two zeros between them.
std::uint64_t spread(std::uint64_t bits) {
  bits &= 0x1fffff;
  bits = (bits | bits << 32) & 0x1f00000000ffff;
  bits = (bits | bits << 16) & 0x1f0000ff0000ff;
  bits = (bits | bits << 8) & 0x100f00f00f00f00f;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3;
  return (bits | bits << 2) & 0x1249249249249249;
}

std::uint64_t morton(const VolumeSample& sample) {
  const auto bits = [&](std::size_t axis) { return spread(static_cast<std::uint64_t>(sample.block[axis])); };
  return bits(0) | bits(1) << 1 | bits(2) << 2;
}

/// Neighbours merged into `count` at most.
std::vector<VolumeSample> merged_cells(const CloudVolume& volume, std::size_t count,
                                       const SamplingOptions& options, const Work& work) {
  const auto has_density = [](float density) { return density > 0.0f; };
  const auto cells =
      static_cast<std::size_t>(std::count_if(volume.density.begin(), volume.density.end(), has_density));
  const std::size_t most = std::min(cells, cells_a_particle * count);
  const double bytes = merging_bytes * static_cast<double>(most);
  if (bytes > static_cast<double>(options.most_bytes)) {
    constexpr double megabyte = 1e6;
    throw Error(
        ErrorKind::out_of_memory,
        fmt::format("cloud.target_particles: merging {} cells into {} particles takes {:.0f} MB, "
                    "more than the {:.0f} MB that are free",
                    most, count, bytes / megabyte, static_cast<double>(options.most_bytes) / megabyte),
        "ask for fewer, or sampling = \"random\"");
  }
  return merged_samples(volume_samples(volume, std::max<std::size_t>(most, 1), work), count, options.seed,
                        work);
}

/// One place in each of `count` parts of equal mass.
std::vector<VolumeSample> drawn_samples(const CloudVolume& volume, std::size_t count, std::uint64_t seed,
                                        const Work& work) {
  VolumeBlocks cells = volume_samples(volume, most_cells, work);
  std::vector<VolumeSample>& samples = cells.samples;
  if (samples.size() <= count) return samples;
  std::stable_sort(samples.begin(), samples.end(),
                   [](const VolumeSample& a, const VolumeSample& b) { return morton(a) < morton(b); });
  double total = 0.0;
  for (const VolumeSample& sample : samples) total += sample.mass;
  const double part = total / static_cast<double>(count), cell_m3 = std::pow(cells.edge_m, 3);
  RandomDraws draws(seed, OFFING_STREAM_CLOUD_PARTICLES, 0, 1);
  std::vector<VolumeSample> drawn;
  std::size_t cell = 0;
  double before = 0.0;  // mass of the cells before this one
  for (std::size_t i = 0; i < count; ++i) {
    work.poll();
    const double wanted = (static_cast<double>(i) + draws.next()) * part;
    while (cell + 1 < samples.size() && before + samples[cell].mass <= wanted) before += samples[cell++].mass;
    const glm::dvec3 jitter(draws.next(), draws.next(), draws.next());
    const double volume_m3 = part / samples[cell].mass * cell_m3;
    drawn.push_back({samples[cell].block, samples[cell].place_m + (jitter - 0.5) * cells.edge_m, part,
                     0.25 * std::pow(volume_m3, 2.0 / 3.0), samples[cell].albedo});
  }
  return drawn;
}

}  // namespace

std::vector<CloudParticle> sampled_particles(const CloudVolume& volume, const SamplingOptions& options,
                                             const CloudLook& look, const Work& work) {
  require_valid(volume);
  require_within("cloud.target_particles", options.target_particles, 1, 10'000'000);
  const auto count = static_cast<std::size_t>(options.target_particles);
  const std::vector<VolumeSample> samples = options.sampling == Sampling::random
                                                ? drawn_samples(volume, count, options.seed, work)
                                                : merged_cells(volume, count, options, work);
  std::vector<CloudParticle> particles;
  for (const VolumeSample& sample : samples) {
    particles.push_back(cloud_particle(sample.place_m, overlap * std::sqrt(sample.square_m2 / ball_variance),
                                       sample.mass * volume.extinction_per_m, look,
                                       {options.seed, static_cast<std::uint32_t>(particles.size())}));
    if (volume.albedo.empty()) continue;
    CloudParticle& particle = particles.back();
    particle.red = sample.albedo.x;
    particle.green = sample.albedo.y;
    particle.blue = sample.albedo.z;
  }
  return particles;
}

}  // namespace offing::clouds
