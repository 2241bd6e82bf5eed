// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include "tests/bench/measure.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace offing::bench {
namespace {

constexpr double warm_up_ms = 15.0;  // longer than OpenMP's idle threads spin after the block before
constexpr double least_block_ms = 30.0;
constexpr std::size_t least_repetitions = 3;
constexpr int selection_rounds = 3;

double now_ms() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

/// By linear interpolation between order statistics.
double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return std::lerp(values[below], values[above], place - static_cast<double>(below));
}

}  // namespace

double block_ms(const Work& work) {
  const double start = now_ms();
  do {
    work();
  } while (now_ms() - start < warm_up_ms);
  std::vector<double> repetitions;
  const double first = now_ms();
  double last = first;
  do {
    work();
    const double end = now_ms();
    repetitions.push_back(end - last);
    last = end;
  } while (last - first < least_block_ms || repetitions.size() < least_repetitions);
  return median(repetitions);
}

double once_ms(const Work& work) {
  const double start = now_ms();
  work();
  return now_ms() - start;
}

std::size_t fastest(const std::vector<Work>& alternatives) {
  std::vector<double> best(alternatives.size(), std::numeric_limits<double>::infinity());
  for (int round = 0; round < selection_rounds; ++round) {
    for (std::size_t i = 0; i < alternatives.size(); ++i) {
      best[i] = std::min(best[i], block_ms(alternatives[i]));
    }
  }
  return static_cast<std::size_t>(std::min_element(best.begin(), best.end()) - best.begin());
}

Comparison compare(const Work& ours, const Work& peer, int blocks) {
  std::vector<double> ours_ms, peer_ms, ratios;
  for (int block = 0; block < blocks; ++block) {
    ours_ms.push_back(block_ms(ours));
    peer_ms.push_back(block_ms(peer));
    ratios.push_back(peer_ms.back() / ours_ms.back());
  }
  return {.ours_ms = median(ours_ms),
          .peer_ms = median(peer_ms),
          .ratio = median(ratios),
          .ratio_low = median_lower_bound(ratios),
          .spread = relative_spread(ratios)};
}

Work repeated(const Work& work) {
  return [work] {
    for (int i = 0; i < works_in_a_row; ++i) work();
  };
}

Comparison for_each_one(Comparison comparison) {
  comparison.ours_ms /= works_in_a_row;
  comparison.peer_ms /= works_in_a_row;
  return comparison;
}

double median(const std::vector<double>& values) {
  return quantile(values, 0.5);
}

double relative_spread(const std::vector<double>& values) {
  return (quantile(values, 0.75) - quantile(values, 0.25)) / quantile(values, 0.5);
}

double median_lower_bound(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  double probability = std::pow(0.5, static_cast<double>(n));  // of exactly `below` values under the median
  double cumulative = probability;
  std::size_t rank = 0;
  for (std::size_t below = 0; cumulative <= 0.025 && below < n; ++below) {
    rank = below;
    probability *= static_cast<double>(n - below) / static_cast<double>(below + 1);
    cumulative += probability;
  }
  return values[rank];
}

}  // namespace offing::bench
