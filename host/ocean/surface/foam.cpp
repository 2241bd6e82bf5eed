#include "host/ocean/surface/foam.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/time_estimate.h"
#include "host/ocean/ocean_limits.h"
#include "host/ocl/program.h"

namespace offing::ocean {
namespace {

// After four decay times 2 % is left; older foam is not looked for.
constexpr double decay_times_kept = 4.0;

// Past instants are computed and kept one by one: 400 of three cascades of 512 take 600 MB and, at first,
// seconds. Foam of a minute needs no instants closer than a wave's period.
constexpr double largest_decay_steps = 100.0;

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

void require_valid_foam(const FoamParameters& parameters) {
  require_within("foam.onset_jacobian", parameters.onset_jacobian, -10.0, 10.0);
  require_within("foam.width", parameters.width, 1e-3, 100.0);
  require_within("foam.decay_s", parameters.decay_s, 0.01, 3600.0);
  require_within("foam.step_s", parameters.step_s, 0.01, 60.0);
  // Rounding of a quotient such as 2.3 / 0.023 is no reason to refuse.
  if (parameters.decay_s <= largest_decay_steps * parameters.step_s * (1.0 + 1e-9)) return;
  throw Error(
      ErrorKind::bad_input,
      fmt::format("ocean.foam: expected a decay_s of at most {:g} steps, found {:g} s in steps of {:g} s",
                  largest_decay_steps, parameters.decay_s, parameters.step_s),
      fmt::format("set foam.step_s to {0:g} or more, or foam.decay_s to {1:g} or less",
                  parameters.decay_s / largest_decay_steps, parameters.step_s * largest_decay_steps));
}

void require_foam_fits(const ocl::DeviceInfo& device, std::int64_t instants, std::size_t texels) {
  constexpr double bytes_per_gb = 1e9;
  const double needed = sizeof(std::uint16_t) * static_cast<double>(texels) * static_cast<double>(instants);
  const double allowed = 0.5 * static_cast<double>(device.global_memory_bytes);
  if (needed <= allowed) return;
  throw Error(ErrorKind::out_of_memory,
              fmt::format("ocean.foam: {} past instants need {:.3g} GB on {}, expected at most {:.3g} GB",
                          instants, needed / bytes_per_gb, device.name, allowed / bytes_per_gb),
              "set foam.step_s larger, foam.decay_s smaller, or --size smaller");
}

Foam::Foam(const ocl::Device& device, const WaveModes& modes, const FoamParameters& parameters,
           std::optional<double> loop_period_s)
    : device_(device), parameters_(parameters), instants_(parameters, loop_period_s) {
  const auto n = static_cast<std::size_t>(modes.size());
  texels_ = n * n * static_cast<std::size_t>(modes.cascade_count());
  require_foam_fits(device.info(), instants_.past_count() + 1, texels_);
  coverage_ = ocl::Program::build(device, "ocean/foam_coverage.cl").kernel("foam_coverage");
  decay_ = ocl::Program::build(device, "ocean/foam_decay.cl").kernel("foam_decay");
  foam_ = ocl::Buffer<float>(device, texels_, "foam");
}

const Foam::Coverage& Foam::coverage_at(const WaveModes& modes, SurfaceMaps& surface, std::int64_t instant) {
  const std::int64_t key = instants_.key_of(instant);
  const auto found = coverages_.find(key);
  if (found != coverages_.end()) return found->second;
  surface.at(modes, static_cast<double>(key) * instants_.step_s());
  Coverage coverage(device_, texels_, "foam coverage");
  coverage_.launch({{texels_, 1, 1}}, surface.displacement(), surface.gradient(), 0,
                   static_cast<float>(parameters_.onset_jacobian), static_cast<float>(parameters_.width),
                   coverage);
  return coverages_.emplace(key, std::move(coverage)).first->second;
}

void Foam::at(const WaveModes& modes, SurfaceMaps& surface, double time_s) {
  const std::int64_t now = instants_.at_or_before(time_s), past_count = instants_.past_count();
  std::set<std::int64_t> needed;
  for (std::int64_t j = 0; j <= past_count; ++j) needed.insert(instants_.key_of(now - j));
  std::erase_if(coverages_, [&](const auto& entry) { return !needed.contains(entry.first); });
  held_.reset();
  foam_.fill(0.0f);
  const std::size_t missing = needed.size() - coverages_.size();
  if (missing > 2) device_.finish();  // so that the first one is timed alone; frames never wait
  TimeEstimate estimate(
      static_cast<std::int64_t>(missing),
      fmt::format("ocean.foam: {} past instants of {} x {} samples in {} cascades", missing, modes.size(),
                  modes.size(), modes.cascade_count()),
      "use a smaller ocean.size, a longer ocean.foam.step_s, or a shorter ocean.foam.decay_s",
      TimeEstimate::Steps::large);
  for (std::int64_t j = 0; j <= past_count; ++j) {
    const bool is_new = !coverages_.contains(instants_.key_of(now - j));
    decay_.launch({{texels_, 1, 1}}, coverage_at(modes, surface, now - j),
                  static_cast<float>(instants_.weight(j)), foam_);
    if (is_new) estimate.step_done([this] { device_.finish(); });
  }
  held_ = instants_.key_of(now);
}

bool Foam::holds(double time_s) const {
  return held_ == instants_.key_of(instants_.at_or_before(time_s));
}

void Foam::reset() {
  coverages_.clear();
  held_.reset();
}

}  // namespace offing::ocean
