#include "host/terrain/analysis/sight_counts.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <numeric>
#include <queue>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/terrain/analysis/sight_limits.h"
#include "kernels/shared/terrain_sight.h"

namespace offing::terrain {
namespace {

using Bits = std::vector<std::uint64_t>;
constexpr std::size_t bits_a_word = 64;
constexpr std::size_t most_in_a_byte = 255;
// Each choice that a search begins keeps the bits of what it sees.
constexpr double most_choices = 5000.0, most_begun = 50'000.0;
constexpr double most_bytes = 8.0 * (1 << 30);

/// Posts of `seen` that `known` does not have.
std::size_t added_by(const Bits& known, const Bits& seen) {
  std::size_t added = 0;
  for (std::size_t i = 0; i < known.size(); ++i)
    added += static_cast<std::size_t>(std::popcount(seen[i] & ~known[i]));
  return added;
}

void join(Bits& known, const Bits& seen) {
  for (std::size_t i = 0; i < known.size(); ++i) known[i] |= seen[i];
}

/// The next best of `among` after those before it. What an observer adds never grows, so that those whose
/// last sum is less than the best new one are not counted again (Minoux 1978).
BestObservers greedy(std::span<const Bits> each, const std::vector<std::size_t>& among, std::size_t count,
                     const CancelToken& cancel) {
  struct Bound {
    std::size_t added, observer;
    // The largest is on top, and of equal ones the first observer.
    bool operator<(const Bound& other) const {
      return added != other.added ? added < other.added : observer > other.observer;
    }
  };
  Bits known(each.front().size(), 0);
  std::priority_queue<Bound> bounds;
  for (const std::size_t observer : among) bounds.push({added_by(known, each[observer]), observer});
  BestObservers best;
  std::size_t seen_posts = 0;
  while (best.observers.size() < count) {
    cancel.throw_if_cancelled();
    const std::size_t observer = bounds.top().observer;
    bounds.pop();
    const Bound now{added_by(known, each[observer]), observer};
    if (!bounds.empty() && now < bounds.top()) {
      bounds.push(now);
      continue;
    }
    join(known, each[observer]);
    seen_posts += now.added;
    best.observers.push_back(observer);
    best.seen_posts.push_back(seen_posts);
  }
  return best;
}

/// Tries all choices that begin with those that `known` has.
struct Search {
  std::span<const Bits> each;
  std::size_t count = 0;
  const CancelToken& cancel;
  std::vector<std::size_t> chosen{}, best{};
  std::size_t most = 0;

  void go_on(std::size_t first, const Bits& known, std::size_t seen_posts) {
    cancel.throw_if_cancelled();
    if (chosen.size() == count) {
      if (best.empty() || seen_posts > most) {
        best = chosen;
        most = seen_posts;
      }
      return;
    }
    for (std::size_t i = first; i + (count - chosen.size()) <= each.size(); ++i) {
      Bits with = known;
      const std::size_t added = added_by(known, each[i]);
      join(with, each[i]);
      chosen.push_back(i);
      go_on(i + 1, with, seen_posts + added);
      chosen.pop_back();
    }
  }
};

/// A bit a post: whether its byte is SIGHT_VISIBLE, all of whose bits are set.
Bits bits_of(std::span<const std::uint8_t> seen) {
  static_assert(SIGHT_VISIBLE == 0xff);
  constexpr std::size_t bytes_a_step = 8;
  constexpr std::uint64_t low_bits = 0x0101010101010101, to_top = 0x0102040810204080;
  Bits bits((seen.size() + bits_a_word - 1) / bits_a_word);
  std::size_t post = 0;
  if constexpr (std::endian::native == std::endian::little) {
    for (; post + bytes_a_step <= seen.size(); post += bytes_a_step) {
      std::uint64_t bytes;
      std::memcpy(&bytes, seen.data() + post, sizeof bytes);
      bytes &= bytes >> 4;
      bytes &= bytes >> 2;
      bytes &= bytes >> 1;
      // The lowest bits of bytes side by side, in the highest byte.
      bits[post / bits_a_word] |= (bytes & low_bits) * to_top >> 56 << post % bits_a_word;
    }
  }
  for (; post < seen.size(); ++post)
    bits[post / bits_a_word] |= std::uint64_t{seen[post] == SIGHT_VISIBLE ? 1u : 0u} << post % bits_a_word;
  return bits;
}

double choices_of(std::size_t all, std::size_t count) {
  double choices = 1.0;
  for (std::size_t i = 0; i < std::min(count, all - count); ++i)
    choices *= static_cast<double>(all - i) / static_cast<double>(i + 1);
  return choices;
}

}  // namespace

SightCounts::SightCounts(std::size_t posts, bool keeps_each)
    : counts_(posts), is_reached_(posts), keeps_each_(keeps_each) {}

void SightCounts::add(std::span<const std::uint8_t> seen) {
  if (observers() == most_observers) {
    throw Error(ErrorKind::bad_input,
                fmt::format("viewshed: expected at most {} observers, found more", most_observers),
                "cut them into several files");
  }
  std::size_t seen_posts = 0, outside_posts = 0;
  // Few enough at a time for sums in bytes: compilers turn such loops into vectors.
  for (std::size_t from = 0; from < counts_.size(); from += most_in_a_byte) {
    const std::size_t count = std::min(most_in_a_byte, counts_.size() - from);
    const std::uint8_t* const here = seen.data() + from;
    std::uint16_t* const counts = counts_.data() + from;
    std::uint8_t* const is_reached = is_reached_.data() + from;
    std::uint8_t seen_here = 0, outside_here = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint8_t is_seen = here[i] == SIGHT_VISIBLE ? 1 : 0,
                         is_out = here[i] == sight_outside ? 1 : 0;
      seen_here = static_cast<std::uint8_t>(seen_here + is_seen);
      outside_here = static_cast<std::uint8_t>(outside_here + is_out);
      is_reached[i] = static_cast<std::uint8_t>(is_reached[i] | (is_out ^ 1));
    }
    for (std::size_t i = 0; i < count; ++i)
      counts[i] = static_cast<std::uint16_t>(counts[i] + (here[i] == SIGHT_VISIBLE ? 1 : 0));
    seen_posts += seen_here;
    outside_posts += outside_here;
  }
  seen_posts_.push_back(seen_posts);
  reached_posts_.push_back(counts_.size() - outside_posts);
  if (keeps_each_) each_.push_back(bits_of(seen));
}

std::size_t SightCounts::union_posts() const {
  return static_cast<std::size_t>(
      std::count_if(counts_.begin(), counts_.end(), [](std::uint16_t count) { return count > 0; }));
}

std::vector<std::size_t> SightCounts::only_posts() const {
  Bits single((counts_.size() + bits_a_word - 1) / bits_a_word);
  for (std::size_t i = 0; i < counts_.size(); ++i)
    single[i / bits_a_word] |= std::uint64_t{counts_[i] == 1 ? 1u : 0u} << i % bits_a_word;
  std::vector<std::size_t> posts;
  for (const Bits& bits : each_) {
    std::size_t own = 0;
    for (std::size_t i = 0; i < bits.size(); ++i)
      own += static_cast<std::size_t>(std::popcount(bits[i] & single[i]));
    posts.push_back(own);
  }
  return posts;
}

void require_room(std::size_t posts, std::size_t observers) {
  const double bytes = static_cast<double>(posts) / 8.0 * static_cast<double>(observers);
  if (bytes <= most_bytes) return;
  throw Error(
      ErrorKind::bad_input,
      fmt::format("viewshed: expected at most {:.0f} GiB for what each observer sees, found {:.1f} GiB "
                  "for {} observers of {} posts",
                  most_bytes / (1 << 30), bytes / (1 << 30), observers, posts),
      "ask for no best observers and no shares of single ones, or give fewer observers or a smaller map");
}

BestObservers best_observers(std::span<const std::vector<std::uint64_t>> each, std::size_t count,
                             const CancelToken& cancel) {
  count = std::min(count, each.size());
  if (count == 0) return {};
  std::vector<std::size_t> all(each.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  // Those that choices begin with are as many as the choices of one more observer.
  const bool is_exhaustive = choices_of(each.size(), count) <= most_choices &&
                             (count == each.size() || choices_of(each.size() + 1, count) <= most_begun);
  if (is_exhaustive && count < each.size()) {
    Search search{each, count, cancel};
    search.go_on(0, Bits(each.front().size(), 0), 0);
    all = search.best;
  }
  BestObservers best = greedy(each, all, count, cancel);
  best.is_exhaustive = is_exhaustive;
  return best;
}

}  // namespace offing::terrain
