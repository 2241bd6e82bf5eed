#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "host/ocean/ocean.h"
#include "host/ocean/surface_maps.h"
#include "host/ocl/device.h"

namespace offing::ocean {

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
  /// In a loop the instants are spaced so that a whole number of them fills it. Throws what
  /// require_foam_fits() throws.
  Foam(const ocl::Device& device, const WaveModes& modes, const FoamParameters& parameters,
       std::optional<double> loop_period_s);

  /// Whether foam() is already that of this time: foam changes only from one instant to the next.
  bool holds(double time_s) const;
  /// Enqueues the foam at this time. Uses `surface` for past instants: afterwards it holds one of them.
  void at(const WaveModes& modes, SurfaceMaps& surface, double time_s);
  /// Forgets foam and coverages: the waves have changed.
  void reset();

  /// [cascades][n][n], 0 ... 1.
  const ocl::Buffer<float>& foam() const { return foam_; }

 private:
  using Coverage = ocl::Buffer<std::uint16_t>;  // [cascades][n][n] half

  /// The last instant at or before this time.
  std::int64_t instant_of(double time_s) const;
  /// Equal for instants that look the same: those a whole loop apart.
  std::int64_t key_of(std::int64_t instant) const;
  const Coverage& coverage_at(const WaveModes& modes, SurfaceMaps& surface, std::int64_t instant);

  ocl::Device device_;
  FoamParameters parameters_;
  double step_s_;
  std::int64_t past_count_;         // M: instants looked back
  std::int64_t loop_instants_ = 0;  // 0: no loop
  std::size_t texels_;
  ocl::Kernel coverage_, decay_;
  std::map<std::int64_t, Coverage> coverages_;
  std::optional<std::int64_t> held_;  // key of the instant that foam_ belongs to
  ocl::Buffer<float> foam_;
};

}  // namespace offing::ocean
