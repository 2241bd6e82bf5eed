#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/base/work.h"

namespace offing::terrain {

/// The most observers that are counted.
inline constexpr std::size_t most_observers = 65000;

/// What several observers of one map see together. Viewsheds are bytes a post: 255 is seen, sight_outside is
/// beyond an observer's radius or limits, anything else is hidden.
class SightCounts {
 public:
  /// Keeps what each observer sees, a bit a post, where `keeps_each` says so.
  SightCounts(std::size_t posts, bool keeps_each);

  /// Of the next observer, [posts].
  void add(std::span<const std::uint8_t> seen);

  std::size_t observers() const { return seen_posts_.size(); }
  /// How many observers see each post.
  std::span<const std::uint16_t> counts() const { return counts_; }
  /// Whether a post is within the radius and the limits of any observer.
  bool is_reached(std::size_t post) const { return is_reached_[post] != 0; }
  /// How many posts each observer sees, and how many are within its radius and limits.
  const std::vector<std::size_t>& seen_posts() const { return seen_posts_; }
  const std::vector<std::size_t>& reached_posts() const { return reached_posts_; }
  /// How many posts at least one observer sees.
  std::size_t union_posts() const;
  /// How many posts each observer sees that no other one does; only with keeps_each.
  std::vector<std::size_t> only_posts() const;

  /// What each observer sees, bits of posts; empty without keeps_each.
  const std::vector<std::vector<std::uint64_t>>& each() const { return each_; }

 private:
  std::vector<std::uint16_t> counts_;
  std::vector<std::uint8_t> is_reached_;
  std::vector<std::size_t> seen_posts_, reached_posts_;
  std::vector<std::vector<std::uint64_t>> each_;
  bool keeps_each_;
};

/// Observers that together see the most, and how.
struct BestObservers {
  std::vector<std::size_t> observers;   ///< in the order in which each adds the most to those before it
  std::vector<std::size_t> seen_posts;  ///< of the first, of the first two ...
  bool is_exhaustive = false;  ///< all choices were compared; otherwise each choice was the next best
};

/// Throws Error(bad_input) where the bits of so many viewsheds are more than 8 GiB.
void require_room(std::size_t posts, std::size_t observers);

/// The best `count` of observers, of all choices where there are at most 5000 that are quickly searched: all
/// but one of more than 300 are not. Otherwise greedy: each adds
/// the most to what those before it see, which is at least 63 % of what the best choice sees (Nemhauser,
/// Wolsey and Fisher 1978). Equal ones are taken in their order. `each` are bits of posts, all of one size.
BestObservers best_observers(std::span<const std::vector<std::uint64_t>> each, std::size_t count,
                             const CancelToken& cancel);

}  // namespace offing::terrain
