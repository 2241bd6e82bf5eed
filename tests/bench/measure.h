// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#pragma once

#include <functional>
#include <vector>

namespace offing::bench {

using Work = std::function<void()>;

/// Milliseconds of one repetition: the median over a block that lasts 30 ms and at least three repetitions,
/// after a warm-up of 15 ms and at least one.
double block_ms(const Work& work);

/// Milliseconds of one run, without a warm-up.
double once_ms(const Work& work);

/// Runs the alternatives in turn for a few rounds; index of the one with the shortest block.
std::size_t fastest(const std::vector<Work>& alternatives);

/// Two pieces of work side by side.
struct Comparison {
  double ours_ms = 0.0;  ///< medians over the blocks
  double peer_ms = 0.0;
  double ratio = 0.0;      ///< median over the blocks of peer / ours
  double ratio_low = 0.0;  ///< lower bound of its 95 % confidence interval
  double spread = 0.0;     ///< interquartile range of the blocks' ratios over their median
};

/// Blocks of ours and of the peer in turn, so that a machine that slows down slows both.
Comparison compare(const Work& ours, const Work& peer, int blocks);

/// How often work is queued in a row where the device need not be waited for, as a bake queues its frames.
inline constexpr int works_in_a_row = 16;
/// Calls the work so often, one after the other.
Work repeated(const Work& work);
/// The same comparison for one of the works in a row.
Comparison for_each_one(Comparison comparison);

/// Of a non-empty set.
double median(const std::vector<double>& values);
/// Interquartile range over median.
double relative_spread(const std::vector<double>& values);
/// Lower bound of the two-sided 95 % confidence interval of the median, from binomial order statistics: the
/// largest k-th value with P(at most k - 1 of n lie below the median) <= 2.5 %. With fewer than six values
/// there is none, and the least value is returned.
double median_lower_bound(std::vector<double> values);

}  // namespace offing::bench
