#include "host/ocean/surface/foam_instants.h"

#include <algorithm>
#include <cmath>

namespace offing::ocean {
namespace {
// After four decay times 2 % is left; older foam is not looked for.
constexpr double decay_times_kept = 4.0;
}  // namespace

FoamInstants::FoamInstants(const FoamParameters& parameters, std::optional<double> loop_period_s)
    : step_s_(parameters.step_s), decay_s_(parameters.decay_s) {
  if (loop_period_s) {
    loop_instants_ =
        std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(*loop_period_s / step_s_ - 1e-9)));
    step_s_ = *loop_period_s / static_cast<double>(loop_instants_);
  }
  past_count_ = static_cast<std::int64_t>(std::ceil(decay_times_kept * parameters.decay_s / step_s_ - 1e-9));
  // Instants of an earlier turn look like those of this one and have decayed further.
  if (loop_instants_ > 0) past_count_ = std::min(past_count_, loop_instants_ - 1);
}

std::int64_t FoamInstants::at_or_before(double time_s) const {
  return static_cast<std::int64_t>(std::floor(time_s / step_s_ + 1e-9));
}

std::int64_t FoamInstants::key_of(std::int64_t instant) const {
  if (loop_instants_ == 0) return instant;
  return ((instant % loop_instants_) + loop_instants_) % loop_instants_;
}

double FoamInstants::weight(std::int64_t instants) const {
  return std::exp(-static_cast<double>(instants) * step_s_ / decay_s_);
}

}  // namespace offing::ocean
