#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "host/ocean/surface/foam_onset.h"
#include "host/ocean/surface/foam_parameters.h"
#include "host/ocean/surface/surface_maps.h"
#include "host/ocl/device.h"

/// Foam of the cascades at a time, from the crests that folded at past instants.
namespace offing::ocean {

/// The instants at which foam looks for folding crests, numbered from time 0. A whole number of them fills a
/// loop.
class FoamInstants {
 public:
  FoamInstants(const FoamParameters& parameters, std::optional<double> loop_period_s);

  double step_s() const { return step_s_; }
  /// The number of past instants that foam needs before the last one.
  std::int64_t past_count() const { return past_count_; }
  /// The last instant at or before this time.
  std::int64_t at_or_before(double time_s) const;
  /// The same for instants with the same waves, which are a whole number of loops apart. The first of them is
  /// its own key.
  std::int64_t key_of(std::int64_t instant) const;
  /// The share of the step from this instant to the next that has passed at a time, 0 ... 1.
  double share_beyond(std::int64_t instant, double time_s) const;
  /// The share of foam that is left after this many steps, whole or not.
  double weight(double instants) const;

 private:
  double step_s_, decay_s_;
  std::int64_t past_count_ = 0;
  std::int64_t loop_instants_ = 0;  // 0: no loop
};

/// Throws Error(bad_input) if these parameters are out of range, or need more past instants than a frame has
/// time for.
void require_valid_foam(const FoamParameters& parameters);

/// Throws Error(out_of_memory) if the coverages of this many instants would fill more than half of the
/// device's memory. texels: of all cascades together.
void require_foam_fits(const ocl::DeviceInfo& device, std::int64_t instants, std::size_t texels);

/// Foam of every cascade, as foam_parameters.h defines it. It depends on the time alone. Coverages that the
/// next frame needs are kept.
class Foam {
 public:
  /// `choppiness` is the sea's, which its surface maps have. Throws what require_foam_fits() throws.
  Foam(const ocl::Device& device, const WaveModes& modes, const FoamParameters& parameters,
       const FoamOnset& onset, double choppiness, std::optional<double> loop_period_s);

  /// Whether foam() is already the foam at this time.
  bool holds(double time_s) const { return held_s_ == time_s; }
  /// Enqueues the foam at this time. Returns whether it used `surface`, which then holds the maps of an
  /// instant. Throws Error(bad_input) if more than three instants would take longer than a first picture may
  /// (host/base/time_estimate.h).
  bool at(const WaveModes& modes, SurfaceMaps& surface, double time_s);
  /// Forgets foam and coverages: the waves have changed.
  void reset();

  /// [cascades][n][n], 0 ... 1.
  const ocl::Buffer<float>& foam() const { return foam_; }

 private:
  using Coverage = ocl::Buffer<std::uint16_t>;  // [cascades][n][n] half

  const ocl::Buffer<float>& foaming_amplitude(const WaveModes& modes);
  bool make_coverages(const WaveModes& modes, SurfaceMaps& surface, std::int64_t newest);
  void make_past(std::int64_t instant);

  ocl::Device device_;
  FoamOnset onset_;
  double choppiness_, k_most_radpm_;
  FoamInstants instants_;
  std::size_t texels_;
  ocl::Kernel filter_, coverage_, decay_;
  ocl::Buffer<float> amplitude_;  // of the waves that foam, once they are asked for
  std::map<std::int64_t, Coverage> coverages_;
  std::optional<std::int64_t> past_key_;  // of the instant that past_ belongs to
  std::optional<double> held_s_;          // that foam_ belongs to
  ocl::Buffer<float> past_, foam_;        // at the last instant, and now
};

}  // namespace offing::ocean
