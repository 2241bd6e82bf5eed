#include "host/scene/file/nearest_name.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace offing::scene {

namespace {

/// Levenshtein 1966, by the usual two-row recurrence.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> above(b.size() + 1);
  std::iota(above.begin(), above.end(), std::size_t{0});
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({change, above[j] + 1, row[j - 1] + 1});
    }
    std::swap(above, row);
  }
  return above[b.size()];
}

}  // namespace

std::string_view nearest_name(std::string_view name, std::span<const std::string_view> candidates) {
  if (name.size() > 100) {  // nobody's misspelling; keeps hostile input cheap
    return {};
  }
  std::string_view best;
  std::size_t best_distance = name.size() / 3 + 1;
  for (const std::string_view candidate : candidates) {
    // A name without its unit is right but for the end.
    const bool is_cut_short = name.size() >= 3 && candidate.starts_with(name);
    const std::size_t distance = is_cut_short ? 0 : edit_distance(name, candidate);
    if (distance < best_distance) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

std::string hint_of_names(std::string_view name, const std::vector<std::string>& known,
                          std::string_view without_any) {
  constexpr std::size_t most_listed = 20;
  if (known.empty()) return std::string(without_any);
  const std::vector<std::string_view> candidates(known.begin(), known.end());
  const std::string_view near = nearest_name(name, candidates);
  const auto listed = std::span(candidates).first(std::min(most_listed, candidates.size()));
  return fmt::format("{}known here: {}{}", near.empty() ? "" : fmt::format("did you mean {}? ", near),
                     fmt::join(listed, ", "), listed.size() < candidates.size() ? ", ..." : "");
}

}  // namespace offing::scene
