#include "host/ocean/foam.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "host/ocl/program.h"

namespace offing::ocean {
namespace {
// After four decay times 2 % is left; older foam is not looked for.
constexpr double decay_times_kept = 4.0;
}  // namespace

Foam::Foam(const ocl::Device& device, const WaveModes& modes, const FoamParameters& parameters,
           std::optional<double> loop_period_s)
    : device_(device), parameters_(parameters), step_s_(parameters.step_s) {
  if (loop_period_s) {
    loop_instants_ =
        std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(*loop_period_s / step_s_ - 1e-9)));
    step_s_ = *loop_period_s / static_cast<double>(loop_instants_);
  }
  past_count_ = static_cast<std::int64_t>(std::ceil(decay_times_kept * parameters.decay_s / step_s_ - 1e-9));
  const auto n = static_cast<std::size_t>(modes.size());
  texels_ = n * n * static_cast<std::size_t>(modes.cascade_count());
  coverage_ = ocl::Program::build(device, "ocean/foam_coverage.cl").kernel("foam_coverage");
  decay_ = ocl::Program::build(device, "ocean/foam_decay.cl").kernel("foam_decay");
  foam_ = ocl::Buffer<float>(device, texels_, "foam");
}

std::int64_t Foam::instant_of(double time_s) const {
  return static_cast<std::int64_t>(std::floor(time_s / step_s_ + 1e-9));
}

std::int64_t Foam::key_of(std::int64_t instant) const {
  if (loop_instants_ == 0) return instant;
  return ((instant % loop_instants_) + loop_instants_) % loop_instants_;
}

const Foam::Coverage& Foam::coverage_at(const WaveModes& modes, SurfaceMaps& surface, std::int64_t instant) {
  const std::int64_t key = key_of(instant);
  const auto found = coverages_.find(key);
  if (found != coverages_.end()) return found->second;
  surface.at(modes, static_cast<double>(key) * step_s_);
  Coverage coverage(device_, texels_, "foam coverage");
  coverage_.launch({{texels_, 1, 1}}, surface.displacement(), surface.gradient(), 0,
                   static_cast<float>(parameters_.onset_jacobian), static_cast<float>(parameters_.width),
                   coverage);
  return coverages_.emplace(key, std::move(coverage)).first->second;
}

void Foam::at(const WaveModes& modes, SurfaceMaps& surface, double time_s) {
  const std::int64_t now = instant_of(time_s);
  std::set<std::int64_t> needed;
  for (std::int64_t j = 0; j <= past_count_; ++j) needed.insert(key_of(now - j));
  std::erase_if(coverages_, [&](const auto& entry) { return !needed.contains(entry.first); });
  held_.reset();
  foam_.fill(0.0f);
  for (std::int64_t j = 0; j <= past_count_; ++j) {
    const double weight = std::exp(-static_cast<double>(j) * step_s_ / parameters_.decay_s);
    decay_.launch({{texels_, 1, 1}}, coverage_at(modes, surface, now - j), static_cast<float>(weight), foam_);
  }
  held_ = key_of(now);
}

bool Foam::holds(double time_s) const {
  return held_ == key_of(instant_of(time_s));
}

void Foam::reset() {
  coverages_.clear();
  held_.reset();
}

}  // namespace offing::ocean
