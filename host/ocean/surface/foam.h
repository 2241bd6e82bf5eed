#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "host/ocean/surface/ocean.h"
#include "host/ocean/surface/surface_maps.h"
#include "host/ocl/device.h"

/// Foam of the cascades at a time, from past instants at which crests folded.
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

/// Throws Error(bad_input) if these parameters are out of range, or look back at more instants than a frame
/// has time for.
void require_valid_foam(const FoamParameters& parameters);

/// Throws Error(out_of_memory) if the coverages of this many instants would fill more than half of the
/// device's memory. texels: of all cascades together.
void require_foam_fits(const ocl::DeviceInfo& device, std::int64_t instants, std::size_t texels);

/// Foam of every cascade: the largest coverage of the last instants, decayed (FoamParameters). It depends on
/// the time alone; coverages of instants that the next frame needs again are kept.
class Foam {
 public:
  /// Throws what require_foam_fits() throws.
  Foam(const ocl::Device& device, const WaveModes& modes, const FoamParameters& parameters,
       std::optional<double> loop_period_s);

  /// Whether foam() is already that of this time: foam changes only from one instant to the next.
  bool holds(double time_s) const;
  /// Enqueues the foam at this time. Uses `surface` for past instants: afterwards it holds one of them.
  /// Throws Error(bad_input) if more than two instants would take longer than a first picture may
  /// (host/base/time_estimate.h).
  void at(const WaveModes& modes, SurfaceMaps& surface, double time_s);
  /// Forgets foam and coverages: the waves have changed.
  void reset();

  /// [cascades][n][n], 0 ... 1.
  const ocl::Buffer<float>& foam() const { return foam_; }

 private:
  using Coverage = ocl::Buffer<std::uint16_t>;  // [cascades][n][n] half

  const Coverage& coverage_at(const WaveModes& modes, SurfaceMaps& surface, std::int64_t instant);

  ocl::Device device_;
  FoamParameters parameters_;
  FoamInstants instants_;
  std::size_t texels_;
  ocl::Kernel coverage_, decay_;
  std::map<std::int64_t, Coverage> coverages_;
  std::optional<std::int64_t> held_;  // key of the instant that foam_ belongs to
  ocl::Buffer<float> foam_;
};

}  // namespace offing::ocean
