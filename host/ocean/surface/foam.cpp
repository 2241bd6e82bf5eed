#include "host/ocean/surface/foam.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

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

double FoamInstants::share_beyond(std::int64_t instant, double time_s) const {
  // To 2^-20, so that times a loop apart have the same.
  const double share = time_s / step_s_ - static_cast<double>(instant);
  return std::clamp(std::round(share * 0x1p20) * 0x1p-20, 0.0, 1.0);
}

double FoamInstants::weight(double instants) const {
  return std::exp(-instants * step_s_ / decay_s_);
}

void require_valid_foam(const FoamParameters& parameters) {
  require_within("foam.fraction", parameters.fraction.value_or(0.0), 0.0, most_foam);
  require_within("foam.onset_jacobian", parameters.onset_jacobian.value_or(0.0), -10.0, 10.0);
  require_within("foam.width", parameters.width.value_or(1.0), 1e-3, 100.0);
  require_within("foam.min_wavelength_m", parameters.min_wavelength_m, 0.0, 1e6);
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
           const FoamOnset& onset, double choppiness, std::optional<double> loop_period_s)
    : device_(device),
      onset_(onset),
      choppiness_(foam_choppiness(choppiness)),
      k_most_radpm_(largest_wavenumber_radpm(parameters.min_wavelength_m)),
      instants_(parameters, loop_period_s) {
  const auto n = static_cast<std::size_t>(modes.size());
  texels_ = n * n * static_cast<std::size_t>(modes.cascade_count());
  foam_ = ocl::Buffer<float>(device, texels_, "foam");
  if (!onset_.has_foam()) return;
  require_foam_fits(device.info(), instants_.past_count() + 2, texels_);
  filter_ = ocl::Program::build(device, "ocean/mode_filter.cl").kernel("mode_filter");
  coverage_ = ocl::Program::build(device, "ocean/foam_coverage.cl").kernel("foam_coverage");
  decay_ = ocl::Program::build(device, "ocean/foam_decay.cl").kernel("foam_decay");
  past_ = ocl::Buffer<float>(device, texels_, "foam of an instant");
}

const ocl::Buffer<float>& Foam::foaming_amplitude(const WaveModes& modes) {
  if (amplitude_.empty()) {
    ocl::Buffer<float> filtered(device_, modes.amplitude().size(), "amplitudes of waves that foam");
    filter_.launch({{static_cast<std::size_t>(modes.columns()), static_cast<std::size_t>(modes.size()),
                     static_cast<std::size_t>(modes.cascade_count())}},
                   modes.amplitude(), modes.wavenumber_step(), modes.columns(), modes.size(),
                   static_cast<float>(k_most_radpm_), filtered);
    amplitude_ = std::move(filtered);
  }
  return amplitude_;
}

/// Those of the newest instant and of all that it looks back at.
bool Foam::make_coverages(const WaveModes& modes, SurfaceMaps& surface, std::int64_t newest) {
  std::set<std::int64_t> needed;
  for (std::int64_t j = 0; j <= instants_.past_count() + 1; ++j) needed.insert(instants_.key_of(newest - j));
  std::erase_if(coverages_, [&](const auto& entry) { return !needed.contains(entry.first); });
  std::erase_if(needed, [&](std::int64_t key) { return coverages_.contains(key); });
  if (needed.size() > 3) device_.finish();  // so that the first one is timed alone; frames never wait
  TimeEstimate estimate(
      static_cast<std::int64_t>(needed.size()),
      fmt::format("ocean.foam: {} past instants of {} x {} samples in {} cascades", needed.size(),
                  modes.size(), modes.size(), modes.cascade_count()),
      "use a smaller ocean.size, a longer ocean.foam.step_s, or a shorter ocean.foam.decay_s",
      TimeEstimate::Steps::large);
  for (const std::int64_t key : needed) {
    surface.at(modes, foaming_amplitude(modes), choppiness_, static_cast<double>(key) * instants_.step_s());
    Coverage coverage(device_, texels_, "foam coverage");
    coverage_.launch({{texels_, 1, 1}}, surface.displacement(), surface.gradient(), 0,
                     static_cast<float>(onset_.jacobian), static_cast<float>(onset_.width), coverage);
    coverages_.emplace(key, std::move(coverage));
    estimate.step_done([this] { device_.finish(); });
  }
  return !needed.empty();
}

/// The foam of an instant whose coverages there are. foam_ is room to work in.
void Foam::make_past(std::int64_t instant) {
  if (past_key_ == instants_.key_of(instant)) return;
  past_key_.reset();
  past_.fill(0.0f);
  for (std::int64_t j = 0; j <= instants_.past_count(); ++j) {
    decay_.launch({{texels_, 1, 1}}, past_, 1.0f, coverages_.at(instants_.key_of(instant - j)),
                  static_cast<float>(instants_.weight(static_cast<double>(j))), foam_);
    std::swap(past_, foam_);
  }
  past_key_ = instants_.key_of(instant);
}

bool Foam::at(const WaveModes& modes, SurfaceMaps& surface, double time_s) {
  held_s_.reset();
  bool used_surface = false;
  if (onset_.has_foam()) {
    const std::int64_t instant = instants_.at_or_before(time_s);
    used_surface = make_coverages(modes, surface, instant + 1);
    make_past(instant);
    const double share = instants_.share_beyond(instant, time_s);
    decay_.launch({{texels_, 1, 1}}, past_, static_cast<float>(instants_.weight(share)),
                  coverages_.at(instants_.key_of(instant + 1)), static_cast<float>(share), foam_);
  } else {
    foam_.fill(0.0f);
  }
  held_s_ = time_s;
  return used_surface;
}

void Foam::reset() {
  coverages_.clear();
  amplitude_ = {};
  past_key_.reset();
  held_s_.reset();
}

}  // namespace offing::ocean
