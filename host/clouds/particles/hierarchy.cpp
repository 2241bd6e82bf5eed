#include "host/clouds/particles/hierarchy.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "host/base/error.h"
#include "host/base/host_memory.h"
#include "host/clouds/particles/cloud_particle.h"
#include "host/clouds/particles/random_draws.h"
#include "host/clouds/shape/hexagon_hash.h"

namespace offing::clouds {
namespace {

constexpr std::size_t most_particles = 10'000'000;
// While they grow and are turned into CloudParticle.
constexpr double bytes_a_particle = 2.0 * (sizeof(HierarchyParticle) + sizeof(CloudParticle));
// Of the parent's radius: touching children are this much nearer at most, by rounding.
constexpr double slack = 1e-9;

/// The angle at the middle of a sphere of radius 1 between two points `chord` apart, negative if none are.
double angle_of_chord(double chord) {
  return chord > 2.0 ? -1.0 : 2.0 * std::asin(0.5 * chord);
}

/// Two unit vectors across a unit vector, and one another.
struct AcrossAxes {
  glm::dvec3 first, second;

  explicit AcrossAxes(const glm::dvec3& axis) {
    const glm::dvec3 other = std::abs(axis.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    first = glm::normalize(glm::cross(other, axis));
    second = glm::cross(axis, first);
  }
};

/// The children of one level.
class Level {
 public:
  /// largest_m: radius of a parent.
  Level(std::vector<HierarchyParticle>& particles, const HierarchyLevel& parameters, int level,
        double largest_m, std::uint64_t seed, const Work& work)
      : particles_(particles),
        parameters_(parameters),
        level_(level),
        largest_m_(parameters.repulsion * parameters.ratio * (largest_m + parameters.deviation_m)),
        seed_(seed),
        work_(work),
        hash_(2.0 * largest_m_ + 1e-6 * largest_m),  // touching children, with their rounding
        grown_on_(2.0 * (largest_m + largest_m_)) {}

  void grow_on(int parent) {
    parent_ = parent;
    middle_ = particles_[static_cast<std::size_t>(parent)].centre_m;
    radius_m_ = particles_[static_cast<std::size_t>(parent)].radius_m;
    find_near();
    RandomDraws draws(seed_, OFFING_STREAM_CLOUD_HIERARCHY, parent, level_);
    const std::size_t first = particles_.size();
    put(draws.direction(), radius_of(draws.next()));
    for (std::size_t child = first; child < particles_.size(); ++child) grow_ring(child, first, draws);
    // Larger children first: those of the smallest radius would leave them no gap.
    if (parameters_.deviation_m > 0.0) {
      fill_gaps(radius_of(1.0), first);
      fill_gaps(radius_of(0.5), first);
    }
    fill_gaps(radius_of(0.0), first);
    grown_on_.insert(middle_, static_cast<std::uint32_t>(families_.size()));
    families_.push_back({middle_, radius_m_, first, particles_.size()});
  }

 private:
  /// The children of one parent.
  struct Family {
    glm::dvec3 middle_m;
    double radius_m;
    std::size_t first, past;
  };

  /// Children of others that may keep a child off this parent's sphere.
  void find_near() {
    std::vector<std::uint32_t> families;
    grown_on_.all_near(middle_, [&](std::uint32_t number) {
      const Family& family = families_[number];
      const double apart_m = glm::distance(middle_, family.middle_m);
      const double reach_m = 2.0 * largest_m_;
      if (apart_m <= radius_m_ + family.radius_m + reach_m &&
          apart_m >= std::abs(radius_m_ - family.radius_m) - reach_m) {
        families.push_back(number);
      }
      return true;
    });
    std::sort(families.begin(), families.end());  // whatever order the hash has
    near_.clear();
    for (const std::uint32_t number : families) {
      for (std::size_t child = families_[number].first; child < families_[number].past; ++child) {
        if (std::abs(glm::distance(particles_[child].centre_m, middle_) - radius_m_) <= 2.0 * largest_m_) {
          near_.push_back(static_cast<std::uint32_t>(child));
        }
      }
    }
  }

  double radius_of(double rand) const {
    return parameters_.ratio * (radius_m_ + parameters_.deviation_m * rand);
  }

  glm::dvec3 direction_of(std::size_t child) const {
    return glm::normalize(particles_[child].centre_m - middle_);
  }

  /// Adds a child in a direction where it fits; whether it does.
  bool put(const glm::dvec3& direction, double child_radius_m) {
    work_.poll();
    const glm::dvec3 centre_m = middle_ + radius_m_ * direction;
    const double repulsion_m = parameters_.repulsion * child_radius_m;
    const bool fits = hash_.all_near(centre_m, [&](std::uint32_t number) {
      const HierarchyParticle& other = particles_[number];
      return glm::distance(centre_m, other.centre_m) >= repulsion_m + other.repulsion_m - slack * radius_m_;
    });
    if (!fits) return false;
    if (particles_.size() >= most_particles) {
      throw Error(ErrorKind::bad_input,
                  fmt::format("cloud: level {} has more than {} particles", level_, most_particles),
                  "use larger ratios or repulsions, or fewer levels or balls");
    }
    hash_.insert(centre_m, static_cast<std::uint32_t>(particles_.size()));
    particles_.push_back({centre_m, child_radius_m, repulsion_m, level_, parent_});
    return true;
  }

  /// Children around one of this parent's, each touching it and the one before, to both sides of the first.
  void grow_ring(std::size_t centre, std::size_t first, RandomDraws& draws) {
    const glm::dvec3 axis = direction_of(centre);
    const AcrossAxes across(axis);
    const double to_centre_m = particles_[centre].repulsion_m;
    const auto at = [&](double distance, double azimuth) {
      return std::cos(distance) * axis +
             std::sin(distance) * (std::cos(azimuth) * across.first + std::sin(azimuth) * across.second);
    };
    std::size_t start = centre;  // the first child that touches this one, itself if none does
    hash_.all_near(particles_[centre].centre_m, [&](std::uint32_t child) {
      const double distance_m = glm::distance(particles_[child].centre_m, particles_[centre].centre_m);
      if (child >= first && child < start &&
          distance_m <= to_centre_m + particles_[child].repulsion_m + 1e-6 * radius_m_) {
        start = child;
      }
      return true;
    });
    if (start == centre) {
      const double child_m = radius_of(draws.next());
      const double distance = angle_of_chord((to_centre_m + parameters_.repulsion * child_m) / radius_m_);
      if (distance < 0.0 || !put(at(distance, 2.0 * std::numbers::pi * draws.next()), child_m)) return;
      start = particles_.size() - 1;
    }
    for (const double side : {1.0, -1.0}) {
      std::size_t before = start;
      while (true) {
        const double child_m = radius_of(draws.next());
        const double repulsion_m = parameters_.repulsion * child_m;
        const double a = angle_of_chord((to_centre_m + repulsion_m) / radius_m_);
        const double b = angle_of_chord((particles_[before].repulsion_m + repulsion_m) / radius_m_);
        if (a < 0.0 || b < 0.0) break;
        // Spherical law of cosines: the corner at the ring's centre between the one before and the next.
        const glm::dvec3 direction = direction_of(before);
        const double e = std::acos(std::clamp(glm::dot(axis, direction), -1.0, 1.0));
        const double corner = (std::cos(b) - std::cos(a) * std::cos(e)) / (std::sin(a) * std::sin(e));
        if (!(std::abs(corner) <= 1.0)) break;
        const double azimuth =
            std::atan2(glm::dot(direction, across.second), glm::dot(direction, across.first));
        if (!put(at(a, azimuth + side * std::acos(corner)), child_m)) break;
        before = particles_.size() - 1;
      }
    }
  }

  /// What a child of the level keeps free of children of some radius on this parent's sphere: directions
  /// whose cosine with `axis` is above `cosine`.
  struct Cap {
    glm::dvec3 axis;
    double cosine;
  };

  Cap cap_of(const HierarchyParticle& child, double repulsion_m) const {
    const glm::dvec3 offset_m = child.centre_m - middle_;
    const double distance_m = glm::length(offset_m), free_m = child.repulsion_m + repulsion_m;
    return {offset_m / distance_m, (radius_m_ * radius_m_ + distance_m * distance_m - free_m * free_m) /
                                       (2.0 * radius_m_ * distance_m)};
  }

  /// Puts children of one radius until none fits. Where there is room, its border is made of circles around
  /// caps: it has a corner where two of them meet, or it is all of one.
  void fill_gaps(double child_m, std::size_t first) {
    const double repulsion_m = parameters_.repulsion * child_m;
    std::vector<Cap> caps;
    // Of two caps that meet the children are no further apart than both reach.
    HexagonHash reaches(2.0 * (largest_m_ + repulsion_m));
    std::vector<glm::dvec3> places_m;  // of the caps' children
    const auto add = [&](const HierarchyParticle& child) {
      const double distance_m = glm::distance(child.centre_m, middle_);
      const double reach_m = child.repulsion_m + repulsion_m;
      if (distance_m > radius_m_ + reach_m ||
          distance_m < std::max(1e-9, 1.0 - reach_m / radius_m_) * radius_m_) {
        return;
      }
      const Cap cap = cap_of(child, repulsion_m);
      if (cap.cosine >= 1.0) return;
      reaches.insert(child.centre_m, static_cast<std::uint32_t>(caps.size()));
      caps.push_back(cap);
      places_m.push_back(child.centre_m);
    };
    for (const std::uint32_t child : near_) add(particles_[child]);
    std::size_t seen = first;
    const auto add_new = [&] {
      for (; seen < particles_.size(); ++seen) add(particles_[seen]);
    };
    add_new();
    std::vector<std::uint32_t> others;
    for (std::size_t i = 0; i < caps.size(); ++i) {
      const Cap cap = caps[i];
      if (cap.cosine > -1.0) {
        const double sine = std::sqrt(1.0 - cap.cosine * cap.cosine);
        if (put(cap.cosine * cap.axis + sine * AcrossAxes(cap.axis).first, child_m)) add_new();
      }
      others.clear();
      reaches.all_near(places_m[i], [&](std::uint32_t other) {
        if (other < i) others.push_back(other);
        return true;
      });
      std::sort(others.begin(), others.end());  // whatever order the hash has
      for (const std::uint32_t j : others) {
        const Cap other = caps[j];
        const double c = glm::dot(cap.axis, other.axis), across = 1.0 - c * c;
        if (across < 1e-12) continue;
        const double along_cap = (cap.cosine - c * other.cosine) / across;
        const double along_other = (other.cosine - c * cap.cosine) / across;
        const double square = (1.0 - along_cap * cap.cosine - along_other * other.cosine) / across;
        if (!(square >= 0.0)) continue;
        const glm::dvec3 between = along_cap * cap.axis + along_other * other.axis;
        const glm::dvec3 up = std::sqrt(square) * glm::cross(cap.axis, other.axis);
        if (put(glm::normalize(between + up), child_m)) add_new();
        if (put(glm::normalize(between - up), child_m)) add_new();
      }
    }
  }

  std::vector<HierarchyParticle>& particles_;
  const HierarchyLevel parameters_;
  const int level_;
  const double largest_m_;  // repulsion radius
  const std::uint64_t seed_;
  const Work& work_;
  HexagonHash hash_;
  HexagonHash grown_on_;  // places of families by number
  std::vector<Family> families_;
  std::vector<std::uint32_t> near_;  // by find_near()
  int parent_ = -1;
  glm::dvec3 middle_{0.0};
  double radius_m_ = 0.0;
};

/// Before minutes are spent on them. A sphere of radius R has room for 4 (R / r)^2 caps of radius r; children
/// of the genera are at least a third of that on those that others cover in part (tests/clouds/
/// hierarchy_test.cpp). Less than a tenth has only what lies nearly all within others.
void require_countable(std::span<const HierarchyParticle> parents, const HierarchyLevel& parameters,
                       int level) {
  constexpr double fewest_share = 0.1;
  double count = 0.0;
  for (const HierarchyParticle& parent : parents) {
    const double child_m =
        parameters.repulsion * parameters.ratio * (parent.radius_m + parameters.deviation_m);
    count += 4.0 * fewest_share * std::pow(parent.radius_m / child_m, 2);
  }
  if (count <= static_cast<double>(most_particles)) {
    require_host_memory(bytes_a_particle * count,
                        fmt::format("cloud: at least {:.0e} particles of level {}", count, level),
                        "use larger ratios or repulsions, or fewer levels or balls");
    return;
  }
  throw Error(ErrorKind::bad_input,
              fmt::format("cloud: level {} would have some {:.0e} particles, expected at most {}", level,
                          count, most_particles),
              "use larger ratios or repulsions, or fewer levels or balls");
}

}  // namespace

std::vector<HierarchyParticle> grown_hierarchy(std::span<const Metaball> seeds,
                                               std::span<const HierarchyLevel> levels, std::uint64_t seed,
                                               const Work& work) {
  std::vector<HierarchyParticle> particles;
  for (const Metaball& ball : seeds)
    particles.push_back({.centre_m = ball.centre_m, .radius_m = ball.radius_m});
  std::size_t first = 0;
  for (std::size_t i = 0; i < levels.size() && first < particles.size(); ++i) {
    const std::size_t past = particles.size();
    double largest_m = 0.0;
    for (std::size_t parent = first; parent < past; ++parent) {
      largest_m = std::max(largest_m, particles[parent].radius_m);
    }
    require_countable(std::span(particles).subspan(first), levels[i], static_cast<int>(i) + 1);
    Level level(particles, levels[i], static_cast<int>(i) + 1, largest_m, seed, work);
    for (std::size_t parent = first; parent < past; ++parent) {
      const double done = static_cast<double>(parent - first) / static_cast<double>(past - first);
      work.tell((static_cast<double>(i) + done) / static_cast<double>(levels.size()));
      level.grow_on(static_cast<int>(parent));
    }
    first = past;
  }
  return particles;
}

}  // namespace offing::clouds
