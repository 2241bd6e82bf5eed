// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/bench/measure.h"
#include "tests/bench/step_statistics.h"

namespace offing::bench {

/// One line of a benchmark's result.
struct Row {
  std::string name;
  int size = 0;
  double ours_ms = 0.0;
  std::string peer;  ///< what ours is measured against, and how that was set up
  // Absent where there is no peer.
  std::optional<double> peer_ms{};
  std::optional<double> ratio{};      ///< peer_ms / ours_ms
  std::optional<double> ratio_low{};  ///< lower bound of the 95 % confidence interval of the ratio
  double spread = 0.0;                ///< interquartile range over median, of the ratios or else of ours_ms
  std::optional<StepStatistics> steps{};  ///< of the rays of four cameras, where rays are cast
};

Row row_of(std::string name, int size, std::string peer, const Comparison& comparison);

/// A line of the table for people, and the heading above it.
std::string table_line(const Row& row);
std::string table_heading();
/// A JSON array.
std::string to_json(const std::vector<Row>& rows);

}  // namespace offing::bench
