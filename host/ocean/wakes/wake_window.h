#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "host/fft/fft2d.h"
#include "host/fft/fft_plan.h"
#include "host/ocean/query/water_query.h"
#include "host/ocean/spectrum/dispersion.h"
#include "host/ocl/buffer.h"
#include "host/ocl/kernel.h"
#include "kernels/shared/wake.h"

namespace offing::ocean {

/// How the waves of a wake window move.
enum class WakeMethod {
  dispersive,  ///< each mode at the omega(k) of water: the wake of a ship
  verlet,      ///< the wave equation, all waves at one speed (O14 of docs/sources.md): a Mach cone
};

/// Rain on a wake window.
struct WakeRain {
  double drops_per_m2s = 0.0;  ///< at most one a step on each square of 8 x 8 cells
  double hollow_m = 0.01;      ///< about the depth of the hollow that a drop leaves, 1.5 cells in radius
  std::uint64_t seed = 1;
};

/// Everything that defines a wake window.
struct WakeParameters {
  WakeMethod method = WakeMethod::dispersive;
  int cells = 256;          ///< n, along a side: a power of two, 16 ... 4096
  double length_m = 128.0;  ///< of a side; its border absorbs waves up to an eighth of it
  double step_s = 1.0 / 120.0;
  Dispersion dispersion = {};  ///< of `dispersive`
  double speed_mps = 5.0;      ///< of all waves of `verlet`, c
  WakeRain rain = {};
  double foam_decay_s = 10.0;  ///< time in which foam fades to 1/e, 0 ... 1000; 0: there is none

  double cell_m() const { return length_m / cells; }
};

/// A hull as what it presses: its displaced depth is that of an ellipsoid's lower half, or a bell.
struct WakeHull {
  /// The form of the displaced depth.
  enum class Shape { ellipsoid, gaussian } shape = Shape::ellipsoid;
  double x_m = 0.0, z_m = 0.0;           ///< its middle
  double heading_rad = 0.0;              ///< of its bow, from +x toward +z
  double length_m = 10.0, beam_m = 3.0;  ///< of the waterline; a bell is down to 1/e there
  double draught_m = 0.5;                ///< 0 ... 100

  /// Of water, m^3.
  double displaced_volume_m3() const;
};

/// What a wake window is told of a time.
struct WakeForcing {
  WaterPoint centre = {};  ///< of the window
  std::vector<WakeHull> hulls = {};
};

/// Throws Error(bad_input) that names what is out of range.
void require_valid_wake(const WakeParameters& parameters);

/// A wake window in host memory, each field [n][n] row-major, row = z, column = x from the window's corner.
struct WakeFields {
  double origin_x_m = 0.0, origin_z_m = 0.0;  ///< of the first sample
  double cell_m = 0.0;
  std::vector<float> height_m, slope_x, slope_z, rise_mps;
  std::vector<float> foam;  ///< 0 ... 1
};

/// A map of WakeWindow::draw() and what show() makes of it, row by row from the corner of the grid; without
/// place.
WakeFields unrolled_wake(const WakeGrid& grid, std::span<const float> map, std::span<const float> shown);

/// Its state, laid out alike: height, m, and the second field of its method, m. The sum of both squares is
/// twice the energy over density, gravity and a cell's area (of `dispersive`).
struct WakeState {
  std::vector<float> height_m, second_m;
};

/// The step of a wake window whose modes move each by itself: to modes, on by a step, and back. The rows of
/// both transforms are one pass (kernels/fft), so that a small window hardly waits for launches.
class WakeStep {
 public:
  /// `turn` [n][n][2]: what each mode is multiplied by in a step, over n^2. Throws what Fft2d throws.
  WakeStep(const ocl::Device& device, int cells, const std::vector<float>& turn);

  /// Enqueues a step of `state` [n][n][2] under `displaced` [n][n] m; `kept` [2][n] as
  /// kernels/ocean/wakes/wake_settle_columns.cl says.
  void advance(const WakeGrid& grid, const ocl::Buffer<float>& displaced, const ocl::Buffer<float>& kept,
               ocl::Buffer<float>& state);

 private:
  WakeStep(const ocl::Device& device, const fft::FftPlan& plan, const std::vector<float>& turn);

  ocl::Kernel press_columns_, turn_rows_, settle_columns_;
  ocl::LaunchShape columns_shape_, rows_shape_;
  ocl::LocalMemory scratch_;
  ocl::Buffer<float> column_twiddles_, row_twiddles_, turn_, intermediate_;
};

/// A square of water that bodies and rain disturb, and that moves with them in whole cells (O14 of
/// docs/sources.md, and linear water waves).
///
/// What disturbs it presses on the water as deep as it displaces it: a pressure of density, gravity and that
/// depth. The water's volume in the window stays as it is, but for what the border absorbs. Waves do not
/// mind the other waves of the sea. Steep ones of `dispersive` break (ocean/wakes/wake_break.cl). At the
/// border waves die away, and what is shown is faded to nothing there.
///
/// Foam covers 0 ... 1 of the water, as that of the sea does (FoamParameters). Hulls make it where their
/// depth changes fast in the water around them, and steep waves where they break (ocean/wakes/wake_foam.cl).
/// It stays where it is, spreads by turbulence and fades.
///
/// State is history: it is known at multiples of step_s, and advance_to() takes it from one to the next. The
/// same steps give the same state, bit by bit, whatever times are asked for in between.
class WakeWindow {
 public:
  /// The centre and the hulls of any time.
  using ForcingAt = std::function<WakeForcing(double time_s)>;
  /// Enqueues what adds to `displaced_m`, [n][n] laid out as WakeGrid says (kernels/shared/wake.h), in a
  /// step: hulls of other shapes. `time_s` is the middle of the step.
  using AddDisplaced =
      std::function<void(double time_s, const WakeGrid& grid, ocl::Buffer<float>& displaced_m)>;

  /// Throws what require_valid_wake() throws, Error(out_of_memory) if it does not fit.
  WakeWindow(const ocl::Device& device, const WakeParameters& parameters);

  const WakeParameters& parameters() const { return parameters_; }
  /// Of the state: a multiple of step_s.
  double time_s() const { return static_cast<double>(step_) * parameters_.step_s; }
  WakeGrid grid() const { return grid_; }

  /// Calm water around this centre at the last multiple of step_s up to time_s.
  void reset(double time_s, const WaterPoint& centre);
  /// Scrolls by whole cells to where this centre asks for; what comes in is calm, what stays is the same bit
  /// by bit.
  void scroll_to(const WaterPoint& centre);
  /// Enqueues the steps up to time_s, none for an earlier one. Throws Error(bad_input) for a time beyond 1e8
  /// s, a centre beyond farthest_point_m, a hull out of range, or steps that would take longer than
  /// a first picture may (base/time_estimate.h): the state is that of the last whole step then.
  /// `add_growth`, for foam, adds to [n][n] m/s how fast the depth grows that hulls of other shapes displace,
  /// by their motion in the water around them.
  void advance_to(double time_s, const ForcingAt& forcing_at, const AddDisplaced& add_displaced = {},
                  const AddDisplaced& add_growth = {});

  /// Enqueues the map of time_s, which is to be within a step of the state: [n][n] float4 from texel `first`
  /// on (height m, dh/dx, dh/dz, dh/dt m/s), laid out as WakeGrid says. Of `dispersive` the hollows under
  /// hulls that `add_displaced` adds at the time of the state are filled: the water stands there as its
  /// pressure says, so that it meets their sides where it meets those around.
  void draw(double time_s, ocl::Buffer<float>& map, std::size_t first = 0,
            const AddDisplaced& add_displaced = {});

  /// Enqueues what a picture shows of a map that draw() made: [n][n] float4 (height m, dh/dx, dh/dz, foam),
  /// from texel `first` on in both.
  void show(double time_s, const ocl::Buffer<float>& map, ocl::Buffer<float>& shown, std::size_t first = 0);

  /// The maps of time_s in host memory.
  WakeFields read(double time_s);
  WakeState read_state() const;
  /// Puts another state in its place; throws Error(bad_usage) unless it has n * n values.
  void write_state(const WakeState& state);

 private:
  void step(const ForcingAt& forcing_at, double middle_s, const AddDisplaced& add_displaced,
            const AddDisplaced& add_growth);
  std::vector<WakeHullShape> shapes_of(const std::vector<WakeHull>& hulls) const;
  void add_hulls(const std::vector<WakeHullShape>& hulls, double factor, ocl::Buffer<float>& sum) const;
  void displace(const std::vector<WakeHull>& hulls);
  void rain();
  void make_foam(const ForcingAt& forcing_at, double middle_s, const AddDisplaced& add_growth);
  void break_waves();
  void advance_verlet();
  ocl::LaunchShape whole() const;
  std::size_t texels() const;

  ocl::Device device_;
  WakeParameters parameters_;
  int parts_;     // of a step, for the wave equation
  float drop_m_;  // that a drop presses, while a step lasts
  WakeGrid grid_{};
  std::int64_t step_ = 0;
  std::optional<WakeStep> dispersive_;
  std::optional<fft::Fft2d> forward_, fields_inverse_;
  ocl::Kernel scroll_, rain_, hollows_, displace_, press_, break_, verlet_, spectrum_, differences_, map_,
      foam_step_, shown_;
  ocl::Buffer<float> kept_, blend_, omega_;
  ocl::Buffer<float> state_, next_, displaced_, fields_, drops_;
  ocl::Buffer<float> foam_, next_foam_;           // [n][n]
  ocl::Buffer<float> growth_;                     // [n][n] m/s, of what hulls displace
  std::optional<std::int64_t> foam_step_number_;  // of foam_; none: nothing has made any
  // All that displaced_ holds; nothing where it holds more, or rain.
  struct DisplacedBy {
    std::vector<WakeHullShape> hulls;
    WakeGrid grid;
  };
  std::optional<DisplacedBy> displaced_by_;
};

}  // namespace offing::ocean
