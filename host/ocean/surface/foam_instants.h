#pragma once

#include <cstdint>
#include <optional>

#include "host/ocean/surface/ocean.h"

namespace offing::ocean {

/// The past instants at which foam looks for folding crests, numbered from time 0. In a loop they are spaced
/// so that a whole number of them fills it.
class FoamInstants {
 public:
  FoamInstants(const FoamParameters& parameters, std::optional<double> loop_period_s);

  double step_s() const { return step_s_; }
  /// How many are looked at before the last one.
  std::int64_t past_count() const { return past_count_; }
  /// The last instant at or before this time.
  std::int64_t at_or_before(double time_s) const;
  /// Equal for instants that look the same: those a whole loop apart. The first of them is its own key.
  std::int64_t key_of(std::int64_t instant) const;
  /// What is left of foam after so many instants.
  double weight(std::int64_t instants) const;

 private:
  double step_s_, decay_s_;
  std::int64_t past_count_ = 0;
  std::int64_t loop_instants_ = 0;  // 0: no loop
};

}  // namespace offing::ocean
