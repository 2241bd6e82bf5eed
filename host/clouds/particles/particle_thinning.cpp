#include "host/clouds/particles/particle_thinning.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <numeric>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "host/base/error.h"
#include "host/clouds/shape/metaball.h"

namespace offing::clouds {
namespace {

// Of the particles, by their size: what stays as it is.
constexpr std::size_t kept_part = 16;
constexpr std::ptrdiff_t largest_group = 1 << most_particle_halvings;

using Numbers = std::vector<std::size_t>;

glm::vec3 place_of(const CloudParticle& particle) {
  return {particle.x, particle.y, particle.z};
}

/// The axis along which particles lie farthest apart.
int widest_axis(std::span<const CloudParticle> particles, std::span<const std::size_t> numbers) {
  glm::vec3 low = place_of(particles[numbers.front()]), high = low;
  for (const std::size_t number : numbers) {
    low = glm::min(low, place_of(particles[number]));
    high = glm::max(high, place_of(particles[number]));
  }
  const glm::vec3 extent = high - low;
  if (extent.x >= extent.y && extent.x >= extent.z) return 0;
  return extent.y >= extent.z ? 1 : 2;
}

/// Puts neighbours together: any aligned group of two or four are some, as halves of halves of space.
void put_neighbours_together(std::span<const CloudParticle> particles, std::span<std::size_t> numbers) {
  const auto count = std::ssize(numbers);
  if (count <= 2) return;
  const std::ptrdiff_t groups = (count + largest_group - 1) / largest_group;
  const std::ptrdiff_t half = groups > 1 ? groups / 2 * largest_group : largest_group / 2;
  const int axis = widest_axis(particles, numbers);
  std::nth_element(numbers.begin(), numbers.begin() + half, numbers.end(), [&](std::size_t a, std::size_t b) {
    const float at_a = place_of(particles[a])[axis], at_b = place_of(particles[b])[axis];
    return at_a != at_b ? at_a < at_b : a < b;
  });
  put_neighbours_together(particles, numbers.first(static_cast<std::size_t>(half)));
  put_neighbours_together(particles, numbers.subspan(static_cast<std::size_t>(half)));
}

/// What some particles have together.
struct Sum {
  double mass_m2 = 0.0, cube_m3 = 0.0;
  double square_m2 = 0.0;  // mean squared distance of the mass from its middle
  glm::dvec3 middle_m{0.0}, albedo{0.0};

  void add(const CloudParticle& particle) {
    if (particle.optical_mass <= 0.0f) return;
    const double radius_m = static_cast<double>(particle.radius);
    mass_m2 += static_cast<double>(particle.optical_mass);
    cube_m3 += radius_m * radius_m * radius_m;
    // So summed up, means of what is alike are just that.
    const double share = static_cast<double>(particle.optical_mass) / mass_m2;
    const glm::dvec3 way_m = glm::dvec3(place_of(particle)) - middle_m;
    square_m2 +=
        share * (ball_variance * radius_m * radius_m + (1.0 - share) * glm::dot(way_m, way_m) - square_m2);
    middle_m += share * way_m;
    albedo += share * (glm::dvec3(particle.red, particle.green, particle.blue) - albedo);
  }

  /// Spreads the mass no farther than it was, in no larger a volume.
  double radius_m() const { return std::min(std::cbrt(cube_m3), std::sqrt(square_m2 / ball_variance)); }
};

/// The number of the heaviest, and what stands for all in its place.
std::pair<std::size_t, CloudParticle> joined(std::span<const CloudParticle> particles,
                                             std::span<std::size_t> numbers) {
  std::sort(numbers.begin(), numbers.end());  // sums round by their order
  const std::size_t heaviest = *std::max_element(
      numbers.begin(), numbers.end(),
      [&](std::size_t a, std::size_t b) { return particles[a].optical_mass < particles[b].optical_mass; });
  Sum sum;
  for (const std::size_t number : numbers) sum.add(particles[number]);
  CloudParticle all = particles[heaviest];
  if (sum.mass_m2 == 0.0 || numbers.size() == 1) return {heaviest, all};
  const glm::vec3 place_m(sum.middle_m), colour(sum.albedo);
  all.x = place_m.x, all.y = place_m.y, all.z = place_m.z;
  all.red = colour.x, all.green = colour.y, all.blue = colour.z;
  all.optical_mass = static_cast<float>(sum.mass_m2);
  all.radius = static_cast<float>(sum.radius_m());
  return {heaviest, all};
}

}  // namespace

void require_halvings(int halvings) {
  if (halvings >= 0 && halvings <= most_particle_halvings) return;
  throw Error(ErrorKind::bad_usage, fmt::format("particles of clouds: expected 0 to {} halvings, got {}",
                                                most_particle_halvings, halvings));
}

std::vector<CloudParticle> thinned_particles(std::span<const CloudParticle> particles, int halvings) {
  require_halvings(halvings);
  if (halvings == 0) return {particles.begin(), particles.end()};
  Numbers by_size(particles.size());
  std::iota(by_size.begin(), by_size.end(), std::size_t{0});
  const auto small = by_size.begin() + static_cast<std::ptrdiff_t>(particles.size() / kept_part);
  std::nth_element(by_size.begin(), small, by_size.end(), [&](std::size_t a, std::size_t b) {
    return particles[a].radius != particles[b].radius ? particles[a].radius > particles[b].radius : a < b;
  });
  std::vector<std::pair<std::size_t, CloudParticle>> left;
  for (auto number = by_size.begin(); number != small; ++number)
    left.emplace_back(*number, particles[*number]);
  std::map<int, Numbers> octaves;
  for (auto number = small; number != by_size.end(); ++number)
    octaves[std::ilogb(particles[*number].radius / particles[*small].radius)].push_back(*number);
  const std::size_t most = std::size_t{1} << halvings;
  for (auto& [octave, numbers] : octaves) {
    put_neighbours_together(particles, numbers);
    for (std::span<std::size_t> rest(numbers); !rest.empty();
         rest = rest.subspan(std::min(most, rest.size())))
      left.push_back(joined(particles, rest.first(std::min(most, rest.size()))));
  }
  std::sort(left.begin(), left.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<CloudParticle> thinned;
  thinned.reserve(left.size());
  for (const auto& [number, particle] : left) thinned.push_back(particle);
  return thinned;
}

}  // namespace offing::clouds
