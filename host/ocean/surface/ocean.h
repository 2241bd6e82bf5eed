#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "host/base/sea/modal_sea.h"
#include "host/ocean/query/shoals.h"
#include "host/ocean/query/surface_instant.h"
#include "host/ocean/query/water_query.h"
#include "host/ocean/spectrum/sea_spectrum.h"
#include "host/ocean/surface/cascades.h"
#include "host/ocean/surface/foam_onset.h"
#include "host/ocean/surface/gerstner_waves.h"
#include "host/ocean/surface/sample_grid.h"
#include "host/ocean/wakes/wake_maps.h"
#include "host/ocl/buffer.h"
#include "host/ocl/device.h"

namespace offing::ocean {

/// Everything that defines a sea besides its spectrum.
struct OceanParameters {
  int size = 512;                 ///< n, samples along a patch: a power of two, 16 ... 4096
  std::vector<Cascade> cascades;  ///< 1 ... 4
  std::uint64_t seed = 1;
  double choppiness = 1.0;                   ///< alpha >= 0 of O7
  std::optional<double> loop_period_s = {};  ///< the surface repeats exactly after this time
  FoamParameters foam = {};
  GerstnerSea gerstner_waves = {};  ///< those below the cascades' k_split, swells, raindrops
  /// The waves of the cascades themselves, in place of random ones of the spectrum; their patches are the
  /// cascades', in the same order. Waves alone are not taken from here.
  std::shared_ptr<const ModalSea> modes = {};
};

/// One cascade's surface in host memory, each field [n][n] row-major, row = z, column = x.
struct SurfaceFields {
  int size = 0;
  std::vector<float> displacement_x, displacement_y, displacement_z;  ///< m
  std::vector<float> slope_x, slope_z;                                ///< dh/dx, dh/dz at rest labels
  std::vector<float> gradient_xx, gradient_xz, gradient_zz;           ///< d dx/dx, d dx/dz, d dz/dz
  std::vector<float> jacobian, jacobian_min_eigenvalue;  ///< of F = I + gradient, this cascade alone
};

/// The fields of SurfaceFields, one by one.
enum class SeaField {
  displacement_x,
  displacement_y,
  displacement_z,
  slope_x,
  slope_z,
  gradient_xx,
  gradient_xz,
  gradient_zz,
  jacobian,
  jacobian_min_eigenvalue,
};

/// Particle velocity, m/s, each [n][n] row-major.
struct VelocityFields {
  int size = 0;
  std::vector<float> x, y, z;
};

/// How the slopes of a composed surface follow from those at labels.
enum class SlopeRule {
  of_displaced_surface,  ///< F^-T times their sum: exactly those of the surface as it is displaced
  added,  ///< their sum, as Lee & Lee 2007 have it (O9): too gentle at crests, too steep in troughs
};

/// The composed sea on a SampleGrid, each [rows][columns]: sums of all cascades and Gerstner waves, then F
/// (O7, O9).
struct ComposedFields {
  int columns = 0, rows = 0;
  std::vector<float> displacement_x, displacement_y, displacement_z;  ///< m
  std::vector<float> slope_x, slope_z;                                ///< by the SlopeRule
  std::vector<float> jacobian, jacobian_min_eigenvalue;
};

/// A sea on a device (O1-O10 of docs/sources.md): 1-4 cascades of periodic patches and Gerstner waves,
/// reachable at any time. read_composed(), sample() and instant() have all waves; maps, foam, velocity and
/// variances are those of the cascades alone.
///
/// at() sets the time; read_*() wait and copy to the host. Same seed and parameters give the same sea on
/// every device within 1e-4 Hs. Before the first at() the time is 0.
///
/// read_*() and mode_variance() throw Error(bad_input) for a cascade that there is not. Every call may throw
/// Error(out_of_memory) or Error(device); a read after an at() or read_*() that failed is right or fails too.
/// Not safe for use from several threads at once.
class Ocean {
 public:
  /// Throws Error(bad_input) for parameters out of range, Error(out_of_memory) if the maps do not fit.
  Ocean(const ocl::Device& device, const SeaSpectrum& spectrum, const OceanParameters& parameters);
  Ocean(Ocean&&) noexcept;
  Ocean& operator=(Ocean&&) noexcept;
  ~Ocean();

  const OceanParameters& parameters() const;

  /// Sets the time. What is asked for then is enqueued at its first use: sums over modes need no maps. Throws
  /// Error(bad_input) unless |time_s| <= 1e8, three years.
  void at(double time_s);

  /// Changes Gerstner waves, swells and raindrops from now on. Throws what require_valid_gerstner_waves()
  /// throws, and has changed nothing then.
  void set_gerstner_waves(const GerstnerSea& gerstner_waves);

  /// The wakes that read_composed(), sample() and instant() add to the sea from now on, as they stand then;
  /// none for nullptr. Wakes count at labels, as Gerstner waves do, whatever the query's minimum wavelength;
  /// below the surface they fade as waves of a sixteenth of their window, and move the water up and down
  /// only.
  void set_wakes(std::shared_ptr<const WakeMaps> wakes);

  /// What is left of the waves of cascades and Gerstner waves in sample() and instant() from now on, by the
  /// depth of the water at their labels; nullptr: the open sea everywhere. Wakes and rings do not shoal;
  /// maps, foam and read_composed() stay those of the open sea. A query that leaves out short waves goes by
  /// the same shares.
  void set_shoals(std::shared_ptr<const Shoals> shoals);

  /// Maps of the last at() on the device, for whoever draws or samples them: [cascades][n][n] float4 (dx m, h
  /// m, dz m, d dx/dz) and (dh/dx, dh/dz, d dx/dx, d dz/dz).
  const ocl::Buffer<float>& displacement_map() const;
  const ocl::Buffer<float>& gradient_map() const;
  /// Where foam begins, and how much of it theory expects.
  const FoamOnset& foam_onset() const;
  /// How longer waves gather the foam of each cascade.
  const std::vector<FoamGathering>& foam_gathering() const;
  /// Foam at the time of the last at() on the device, [cascades][n][n] float, 0 ... 1; costs and errors are
  /// those of read_foam().
  const ocl::Buffer<float>& foam_map();

  /// Fields of one cascade at the time of the last at().
  SurfaceFields read_surface(int cascade) const;
  /// The same into the caller's memory, the fields that are asked for alone: values[i] points at [n][n] of
  /// fields[i]. Throws Error(bad_usage) for another number of pointers.
  void read_fields(int cascade, std::span<const SeaField> fields, std::span<float* const> values) const;
  /// Enqueues the copy of one field of one cascade at the time of the last at() to values[first ...], a
  /// buffer of this device. Throws Error(bad_usage) where it has no room for [n][n] there.
  void copy_field(int cascade, SeaField field, ocl::Buffer<float>& values, std::size_t first = 0) const;
  /// Foam of one cascade, [n][n], 0 ... 1, at the time of the last at(). The first question of a time
  /// computes all cascades: it evaluates the past instants it needs and keeps them for the next frame, 2
  /// bytes a texel and instant. Throws Error(out_of_memory) if that is more than half of the device's memory,
  /// and Error(bad_input) if it would take too long.
  std::vector<float> read_foam(int cascade);
  /// Particle velocity at the time of the last at(), `depth_m` below the instantaneous surface (vertical
  /// coordinate measured from the surface: Wheeler stretching of linear theory); 0 is the surface itself. The
  /// first question of a time and depth computes all cascades.
  /// Throws Error(bad_input) for a depth below the bed.
  VelocityFields read_velocity(int cascade, double depth_m = 0.0);
  /// The composed surface at the time of the last at(), bilinear between samples of each cascade. Throws
  /// Error(bad_input) for a grid without samples, of more than 16384 a side, or not finite.
  ComposedFields read_composed(const SampleGrid& grid, SlopeRule slopes = SlopeRule::of_displaced_surface);

  /// Foam of the whole sea at the time of the last at(), [rows][columns], 0 ... 1: what any of the cascades
  /// makes, gathered by longer waves, and what wakes have. Costs and errors are those of read_foam() and
  /// read_composed().
  std::vector<float> read_composed_foam(const SampleGrid& grid);

  /// The water at points of the world at the time of the last at(): the surface that read_composed()
  /// composes, where it meets each point's vertical.
  ///
  /// The label X under a point x solves X + d(X) = x; each sample says by how much it is missed, residual_m:
  /// at most the query's tolerance, but where the surface folds (a point has several labels there, one of
  /// which is found) and after 24 steps without success. Velocity and pressure are those of linear theory at
  /// that label at exactly the query's depth below the surface, with no levels to interpolate between:
  /// another depth makes other maps. Water below a point is displaced as the surface above it. Pressure is
  /// density times gravity times (depth - height + head), the head being what is left of each wave's height
  /// at that depth, so that it is 0 at the surface.
  ///
  /// The first query of a time with flow, depth or minimum wavelength makes the maps that it needs; those of
  /// one minimum wavelength are kept. Throws Error(bad_input) for points beyond farthest_point_m and a query
  /// out of range.
  std::vector<WaterSample> sample(std::span<const WaterPoint> points, const WaterQuery& query = {});
  /// The same into the caller's memory, as many samples as points; throws Error(bad_usage) for another
  /// number.
  void sample(std::span<const WaterPoint> points, std::span<WaterSample> samples,
              const WaterQuery& query = {});
  /// The same without memory for all of them: `take` gets the samples in parts, in the order of the points.
  void sample(std::span<const WaterPoint> points, const TakeSamples& take, const WaterQuery& query = {});
  /// Enqueues the same for the first `count` points that are on the device already, and leaves the samples
  /// there: no transfer, no wait while waves and query stay the same and no rings run. Throws
  /// Error(bad_usage) if a buffer holds fewer. A point that is not finite gets a residual that is not either.
  void sample(const ocl::Buffer<SurfaceQueryPoint>& points, std::size_t count,
              ocl::Buffer<WaterSample>& samples, const WaterQuery& query = {});
  /// The same with samples that end with the pressure.
  void sample(const ocl::Buffer<SurfaceQueryPoint>& points, std::size_t count,
              ocl::Buffer<FirstWaterFloats>& samples, const WaterQuery& query = {});
  /// The same, and how far waves have moved the water sideways.
  void sample(const ocl::Buffer<SurfaceQueryPoint>& points, std::size_t count,
              ocl::Buffer<ShiftedWaterSample>& samples, const WaterQuery& query = {});
  /// The same sea at the time of the last at() in host memory, for single points without the device: from a
  /// frame's maps, as WaterQuery::Accuracy::frame_maps reads them.
  SurfaceInstant instant(const WaterQuery& query = {});

  /// Expected variance of each mode, [n][n] m^2, K = 0 at [0][0]: what the spectrum asks of this cascade.
  std::vector<float> mode_variance(int cascade) const;
  /// The waves that this sea is: those of the cascades and Gerstner waves; not rings, wakes and shoals.
  ModalSea modes() const;
  /// Draws a new sea of the same spectrum: all that is read from now on is of it, at the time of the last
  /// at(). Gerstner waves are drawn from the spectrum by the same seed: give those of the new sea. Throws
  /// what require_valid_gerstner_waves() throws, and has changed nothing then.
  void reseed(std::uint64_t seed, const GerstnerSea& gerstner_waves);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace offing::ocean
