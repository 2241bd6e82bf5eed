#include "host/ocean/wakes/wake_window.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/parameter_check.h"
#include "host/base/time_estimate.h"
#include "host/ocean/ocean_limits.h"
#include "host/ocl/program.h"

namespace offing::ocean {
namespace {

using std::numbers::pi;
// Verlet's scheme is stable up to a Courant number of sqrt(3 / 8) = 0.61 with these differences, whose
// largest eigenvalue is 16/3 along either axis.
constexpr double largest_courant = 0.55;
// Every wave fades at this rate, so that rounding adds no energy: 2e-7 of a height in a step of 1/120 s gains
// less than half as much. Waves keep 99 % of their height for 100 s.
constexpr double fade_per_s = 1e-4;
constexpr std::size_t most_hulls = 1024;
// Foam is made this often or at every step: the hull moves by little in between.
constexpr double foam_step_s = 1.0 / 30.0;
// Waves break this often at least, or at every step: a wave a metre long fades by an eighth at most in
// between.
constexpr double breaking_step_s = 0.1;
// The longest waves that break at their full rate.
constexpr double longest_breaking_m = 10.0;
constexpr double most_mixed = WAKE_MOST_MIXED;

/// How many steps there are in this time, 1 at least.
std::int64_t steps_in(double time_s, const WakeParameters& parameters) {
  return std::max<std::int64_t>(std::llround(time_s / parameters.step_s), 1);
}

/// From one breaking of the waves to the next: the viscosity of the longest ones mixes most.
std::int64_t steps_to_breaking(const WakeParameters& parameters) {
  const double length_m = longest_breaking_m / (2.0 * pi), cell_m = parameters.cell_m();
  const double viscosity_m2ps =
      std::sqrt(parameters.dispersion.gravity_mps2 * length_m) * length_m / (2.0 * pi);
  return steps_in(std::min(breaking_step_s, most_mixed * cell_m * cell_m / viscosity_m2ps), parameters);
}

// Turbulence spreads foam: the wake of a ship of 5 m beam widens by a metre on either side in 10 s. Really it
// widens faster at first and slower later, as the fifth root of the way (Milgram et al. 1993).
constexpr double foam_diffusion_m2ps = 0.05;

int parts_of(const WakeParameters& parameters) {
  if (parameters.method == WakeMethod::dispersive) return 1;
  const double courant = parameters.speed_mps * parameters.step_s / parameters.cell_m();
  return std::max(1, static_cast<int>(std::ceil(courant / largest_courant)));
}

/// What a drop presses for a step, so that the hollow it leaves is as deep as asked: waves as long as it is
/// wide turn by omega dt in that time.
double drop_depth_m(const WakeParameters& parameters) {
  if (parameters.rain.drops_per_m2s <= 0.0) return 0.0;
  const double radius_m = WAKE_DROP_RADIUS * parameters.cell_m();
  const double omega_radps = parameters.method == WakeMethod::verlet
                                 ? parameters.speed_mps / radius_m
                                 : parameters.dispersion.omega_radps(1.0 / radius_m);
  return parameters.rain.hollow_m / (omega_radps * parameters.step_s);
}

struct ModeTables {
  std::vector<float> turn, omega;
};

/// e^(-i omega dt) / n^2 of each mode, with what it loses in a step: waves four cells long, which the window
/// shows badly, fade to 1/e in a period, others by the sixth power of their wavenumber faster or more slowly;
/// those 16 cells long keep 99.9 % in one of theirs. Such short waves would stay along a hull's track as a
/// serrated line, where a real wake's turbulence takes them (Milgram et al. 1993). The mean level, K = 0,
/// loses nothing.
ModeTables mode_tables(const WakeParameters& parameters) {
  const int n = parameters.cells;
  const double k_step = 2.0 * pi / parameters.length_m, shortest = 0.5 * n * k_step;
  const double short_wave = 0.5 * shortest;
  const double short_fade_per_s = parameters.dispersion.omega_radps(short_wave) / (2.0 * pi);
  const double scale = 1.0 / (static_cast<double>(n) * n);
  // omega of |K| for one octant: the others follow by symmetry.
  const int half = n / 2;
  ModeTables tables;
  const auto count = static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
  tables.turn.resize(2 * count);
  tables.omega.resize(count);
  for (int i = 0; i <= half; ++i) {
    for (int j = 0; j <= i; ++j) {
      const double k = k_step * std::hypot(i, j), omega = parameters.dispersion.omega_radps(k);
      const double ratio = k / short_wave, cube = ratio * ratio * ratio;
      const double rate = fade_per_s + short_fade_per_s * cube * cube;
      const double kept = i == 0 ? scale : scale * std::exp(-rate * parameters.step_s);
      const auto cosine = static_cast<float>(kept * std::cos(omega * parameters.step_s));
      const auto sine = static_cast<float>(-kept * std::sin(omega * parameters.step_s));
      for (const auto& [a, b] : {std::pair{i, j}, {j, i}}) {
        for (const int row : {a, (n - a) % n}) {
          for (const int column : {b, (n - b) % n}) {
            const std::size_t place = static_cast<std::size_t>(row) * static_cast<std::size_t>(n) +
                                      static_cast<std::size_t>(column);
            tables.turn[2 * place] = cosine;
            tables.turn[2 * place + 1] = sine;
            tables.omega[place] = static_cast<float>(omega);
          }
        }
      }
    }
  }
  return tables;
}

void require_valid_hull(const WakeHull& hull) {
  require_within("wake hull x_m", hull.x_m, -farthest_point_m, farthest_point_m);
  require_within("wake hull z_m", hull.z_m, -farthest_point_m, farthest_point_m);
  require_within("wake hull length_m", hull.length_m, 0.01, 1e4);
  require_within("wake hull beam_m", hull.beam_m, 0.01, 1e4);
  require_within("wake hull draught_m", hull.draught_m, 0.0, 100.0);
  require_within("wake hull heading_rad", hull.heading_rad, -1e6, 1e6);
}

WakeHullShape device_hull(const WakeHull& hull, const WakeGrid& grid, double cell_m) {
  return {.x_m = static_cast<float>(hull.x_m - grid.first_column * cell_m),
          .z_m = static_cast<float>(hull.z_m - grid.first_row * cell_m),
          .cosine = static_cast<float>(std::cos(hull.heading_rad)),
          .sine = static_cast<float>(std::sin(hull.heading_rad)),
          .half_length_m = static_cast<float>(0.5 * hull.length_m),
          .half_beam_m = static_cast<float>(0.5 * hull.beam_m),
          .draught_m = static_cast<float>(hull.draught_m),
          .shape = hull.shape == WakeHull::Shape::gaussian ? WAKE_SHAPE_GAUSSIAN : WAKE_SHAPE_ELLIPSOID};
}

/// The cells of a window that a hull may reach: as many columns and rows from the first ones on.
struct HullCells {
  int first_column, first_row, columns, rows;
};

HullCells cells_of(const WakeHullShape& hull, const WakeGrid& grid) {
  const float reach = hull.shape == WAKE_SHAPE_GAUSSIAN ? WAKE_GAUSSIAN_REACH : 1.0f;
  const float length_m = reach * hull.half_length_m, beam_m = reach * hull.half_beam_m;
  const float cosine = std::abs(hull.cosine), sine = std::abs(hull.sine);
  const auto along = [&](float middle_m, float half_m, int& first, int& count) {
    // A cell counts what is up to a cell away.
    const double low = (static_cast<double>(middle_m) - half_m) / grid.cell_m - 1.0,
                 high = (static_cast<double>(middle_m) + half_m) / grid.cell_m + 1.0;
    first = static_cast<int>(std::clamp(std::ceil(low), 0.0, static_cast<double>(grid.size)));
    count = static_cast<int>(std::clamp(std::floor(high), -1.0, grid.size - 1.0)) + 1 - first;
  };
  HullCells cells{};
  along(hull.x_m, cosine * length_m + sine * beam_m, cells.first_column, cells.columns);
  along(hull.z_m, sine * length_m + cosine * beam_m, cells.first_row, cells.rows);
  return cells;
}

/// Samples along a side of the square of a cell: fewer for a hull of many cells.
int samples_of(const WakeHullShape& hull, const WakeGrid& grid) {
  const float cells = std::min(hull.half_length_m, hull.half_beam_m) / grid.cell_m;
  return cells < 8.0f ? 6 : (cells < 32.0f ? 4 : 2);
}

bool are_same(const WakeGrid& a, const WakeGrid& b) {
  return a.size == b.size && a.first_column == b.first_column && a.first_row == b.first_row &&
         a.cell_m == b.cell_m;
}

bool are_same(const std::vector<WakeHullShape>& a, const std::vector<WakeHullShape>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(WakeHullShape)) == 0);
}

/// The border of the window, an eighth of its side wide, in which waves die away: those that leave neither
/// come back nor enter again at the other side, although the window is periodic.
///
/// With u the way from the outer edge in widths, all water is damped at the rate (1 - u)^2 r, r such that a
/// wave as long as the border is wide keeps e^-5 of its height on its way through the borders of both sides.
/// The profile grows so slowly that such a wave is reflected by 1 %, and shorter ones by less.
struct WakeBorder {
  std::vector<float> kept;   ///< [n]: share of the water's height that each column keeps in a step
  std::vector<float> blend;  ///< [n][2]: share that is shown, 0 at both ends, and its derivative, 1/m
};

constexpr double border_share = 0.125;
// e^-5 = 0.7 %: damping and reflection of the longest waves are alike then.
constexpr double attenuation = 5.0;

double group_speed_mps(const WakeParameters& parameters, double wavelength_m) {
  if (parameters.method == WakeMethod::verlet) return parameters.speed_mps;
  return parameters.dispersion.group_speed_mps(2.0 * pi / wavelength_m);
}

/// Width of the border, m.
double wake_border_m(const WakeParameters& parameters) {
  return border_share * parameters.length_m;
}

/// For one of the equal parts into which a step is divided.
WakeBorder make_wake_border(const WakeParameters& parameters, double part_s) {
  const double width_m = wake_border_m(parameters);
  // The integral of (1 - u)^2 over both borders is 2/3 of a width.
  const double rate_per_s = 1.5 * attenuation * group_speed_mps(parameters, width_m) / width_m;
  WakeBorder border;
  for (int i = 0; i < parameters.cells; ++i) {
    const int from_edge = std::min(i, parameters.cells - 1 - i);
    const double u = std::min(1.0, (from_edge + 0.5) * parameters.cell_m() / width_m);
    border.kept.push_back(static_cast<float>(std::exp(-rate_per_s * (1.0 - u) * (1.0 - u) * part_s)));
    // Shown is what is left where the outer half of the border begins, faded by a smooth step.
    const double v = std::min(1.0, 2.0 * from_edge * parameters.cell_m() / width_m);
    const double sign = 2 * i < parameters.cells ? 1.0 : -1.0;
    border.blend.push_back(static_cast<float>(v * v * (3.0 - 2.0 * v)));
    border.blend.push_back(static_cast<float>(sign * 6.0 * v * (1.0 - v) * 2.0 / width_m));
  }
  return border;
}

/// Work-items that take a run of samples each: RUN of ocean/wakes/wake_slopes.clh.
ocl::LaunchShape in_runs(int cells) {
  constexpr std::size_t run = 16;
  const auto side = static_cast<std::size_t>(cells);
  return {{side / run, side, 1}};
}

fft::FftPlan plan_for(const ocl::Device& device, int cells) {
  return {device.info(),
          {.size = cells, .columns = cells},
          fft::Fft2d::family_for(device, cells, fft::Direction::inverse)};
}

}  // namespace

double WakeHull::displaced_volume_m3() const {
  const double box_m3 = 0.25 * length_m * beam_m * draught_m * pi;
  return shape == Shape::gaussian ? box_m3 : 2.0 / 3.0 * box_m3;
}

void require_valid_wake(const WakeParameters& parameters) {
  require_valid_size(parameters.cells);
  require_within("wake.length_m", parameters.length_m, 0.1, 1e5);
  require_within("wake.step_s", parameters.step_s, 1e-4, 1.0);
  require_valid_dispersion(parameters.dispersion);
  require_within("wake.speed_mps", parameters.speed_mps, 0.01, 100.0);
  const double square_m = WAKE_RAIN_SQUARE * parameters.cell_m();
  require_within("wake.rain.drops_per_m2s", parameters.rain.drops_per_m2s, 0.0,
                 1.0 / (square_m * square_m * parameters.step_s));
  require_within("wake.rain.hollow_m", parameters.rain.hollow_m, -1.0, 1.0);
  require_within("wake.foam_decay_s", parameters.foam_decay_s, 0.0, 1000.0);
}

WakeStep::WakeStep(const ocl::Device& device, int cells, const std::vector<float>& turn)
    : WakeStep(device, plan_for(device, cells), turn) {}

WakeStep::WakeStep(const ocl::Device& device, const fft::FftPlan& plan, const std::vector<float>& turn)
    : columns_shape_(plan.columns().shape_for(1)),
      rows_shape_(plan.rows().shape_for(1)),
      scratch_{plan.columns().scratch_bytes},
      column_twiddles_(device, plan.columns().twiddles, "column twiddles"),
      row_twiddles_(device, plan.rows().twiddles, "row twiddles"),
      turn_(device, turn, "turns of modes"),
      intermediate_(device, plan.intermediate_floats(), "transform intermediate") {
  const auto kernel = [&](const char* source, const char* name, const ocl::Defines& defines) {
    return ocl::Program::build(device, source, defines).kernel(name);
  };
  const ocl::Defines &columns = plan.columns().defines, &rows = plan.rows().defines;
  press_columns_ = kernel("ocean/wakes/wake_press_columns.cl", "wake_press_columns", columns);
  turn_rows_ = kernel("ocean/wakes/wake_turn_rows.cl", "wake_turn_rows", rows);
  settle_columns_ = kernel("ocean/wakes/wake_settle_columns.cl", "wake_settle_columns", columns);
}

void WakeStep::advance(const WakeGrid& grid, const ocl::Buffer<float>& displaced,
                       const ocl::Buffer<float>& kept, ocl::Buffer<float>& state) {
  press_columns_.launch(columns_shape_, state, displaced, intermediate_, column_twiddles_, scratch_);
  turn_rows_.launch(rows_shape_, intermediate_, row_twiddles_, turn_);
  settle_columns_.launch(columns_shape_, grid, displaced, kept, state, intermediate_, column_twiddles_,
                         scratch_);
}

WakeWindow::WakeWindow(const ocl::Device& device, const WakeParameters& parameters)
    : device_(device),
      parameters_((require_valid_wake(parameters), parameters)),
      parts_(parts_of(parameters)),
      drop_m_(static_cast<float>(drop_depth_m(parameters))) {
  const auto kernel = [&](const char* source, const char* name) {
    return ocl::Program::build(device, source).kernel(name);
  };
  scroll_ = kernel("ocean/wakes/wake_scroll.cl", "wake_scroll");
  rain_ = kernel("ocean/wakes/wake_rain.cl", "wake_rain");
  hollows_ = kernel("ocean/wakes/wake_hollows.cl", "wake_hollows");
  displace_ = kernel("ocean/wakes/wake_displace.cl", "wake_displace");
  map_ = kernel("ocean/wakes/wake_map.cl", "wake_map");
  foam_step_ = kernel("ocean/wakes/wake_foam.cl", "wake_foam");
  shown_ = kernel("ocean/wakes/wake_shown.cl", "wake_shown");
  WakeBorder border = make_wake_border(parameters_, parameters_.step_s / parts_);
  // Twice: see ocean/wakes/wake_settle_columns.cl.
  border.kept.insert(border.kept.end(), border.kept.begin(), border.kept.begin() + parameters_.cells);
  kept_ = ocl::Buffer<float>(device, border.kept, "wake border");
  blend_ = ocl::Buffer<float>(device, border.blend, "wake blend");
  state_ = ocl::Buffer<float>(device, 2 * texels(), "wake state");
  next_ = ocl::Buffer<float>(device, 2 * texels(), "wake step");
  displaced_ = ocl::Buffer<float>(device, texels(), "displaced depth");
  fields_ = ocl::Buffer<float>(device, 4 * texels(), "wake fields");
  foam_ = ocl::Buffer<float>(device, texels(), "foam of wakes");
  next_foam_ = ocl::Buffer<float>(device, texels(), "foam of wakes");
  growth_ = ocl::Buffer<float>(device, texels(), "growing depth");
  drops_ = ocl::Buffer<float>(device, 2 * texels() / (WAKE_RAIN_SQUARE * WAKE_RAIN_SQUARE), "wake rain");
  if (parameters_.method == WakeMethod::verlet) {
    verlet_ = kernel("ocean/wakes/wake_verlet.cl", "wake_verlet");
    differences_ = kernel("ocean/wakes/wake_differences.cl", "wake_differences");
  } else {
    press_ = kernel("ocean/wakes/wake_press.cl", "wake_press");
    break_ = kernel("ocean/wakes/wake_break.cl", "wake_break");
    spectrum_ = kernel("ocean/wakes/wake_spectrum.cl", "wake_spectrum");
    forward_.emplace(device, parameters_.cells, 1, fft::Direction::forward);
    fields_inverse_.emplace(device, parameters_.cells, 2, fft::Direction::inverse);
    const ModeTables tables = mode_tables(parameters_);
    dispersive_.emplace(device, parameters_.cells, tables.turn);
    omega_ = ocl::Buffer<float>(device, tables.omega, "frequencies of modes");
  }
  reset(0.0, {});
}

std::size_t WakeWindow::texels() const {
  return static_cast<std::size_t>(parameters_.cells) * static_cast<std::size_t>(parameters_.cells);
}

ocl::LaunchShape WakeWindow::whole() const {
  const auto side = static_cast<std::size_t>(parameters_.cells);
  return {{side, side, 1}};
}

void WakeWindow::scroll_to(const WaterPoint& centre) {
  require_within("wake centre x_m", centre.x_m, -farthest_point_m, farthest_point_m);
  require_within("wake centre z_m", centre.z_m, -farthest_point_m, farthest_point_m);
  const auto first = [&](double place_m) {
    return static_cast<int>(std::llround(place_m / parameters_.cell_m())) - parameters_.cells / 2;
  };
  WakeGrid moved{.size = parameters_.cells,
                 .first_column = first(centre.x_m),
                 .first_row = first(centre.z_m),
                 .cell_m = static_cast<float>(parameters_.cell_m())};
  const int columns = moved.first_column - grid_.first_column, rows = moved.first_row - grid_.first_row;
  grid_ = moved;
  if (columns == 0 && rows == 0) return;
  scroll_.launch(whole(), grid_, columns, rows, state_, foam_);
}

void WakeWindow::reset(double time_s, const WaterPoint& centre) {
  require_within("time_s", time_s, -largest_time_s, largest_time_s);
  step_ = static_cast<std::int64_t>(std::floor(time_s / parameters_.step_s));
  scroll_to(centre);
  state_.fill(0.0f);
  foam_.fill(0.0f);
  foam_step_number_.reset();
}

void WakeWindow::advance_to(double time_s, const ForcingAt& forcing_at, const AddDisplaced& add_displaced,
                            const AddDisplaced& add_growth) {
  require_within("time_s", time_s, -largest_time_s, largest_time_s);
  // A time that is a multiple of the step but for rounding is taken as that multiple.
  const auto last = static_cast<std::int64_t>(std::floor(time_s / parameters_.step_s + 1e-6));
  TimeEstimate estimate(
      last - step_,
      fmt::format("ocean.wake: {} steps of {:g} s on {} x {} cells", last - step_, parameters_.step_s,
                  parameters_.cells, parameters_.cells),
      "use a shorter ocean.wake.history_s, a longer ocean.wake.step_s, or fewer ocean.wake.cells");
  while (step_ < last) {
    const double middle_s = (static_cast<double>(step_) + 0.5) * parameters_.step_s;
    step(forcing_at, middle_s, add_displaced, add_growth);
    ++step_;
    estimate.step_done([&] { device_.finish(); });
  }
}

std::vector<WakeHullShape> WakeWindow::shapes_of(const std::vector<WakeHull>& hulls) const {
  require_within("wake hull count", static_cast<double>(hulls.size()), 0.0, most_hulls);
  std::vector<WakeHullShape> shapes;
  for (const WakeHull& hull : hulls) {
    require_valid_hull(hull);
    shapes.push_back(device_hull(hull, grid_, parameters_.cell_m()));
  }
  return shapes;
}

void WakeWindow::add_hulls(const std::vector<WakeHullShape>& hulls, double factor,
                           ocl::Buffer<float>& sum) const {
  for (const WakeHullShape& hull : hulls) {
    const HullCells cells = cells_of(hull, grid_);
    if (cells.columns <= 0 || cells.rows <= 0) continue;
    displace_.launch({{static_cast<std::size_t>(cells.columns), static_cast<std::size_t>(cells.rows), 1}},
                     grid_, hull, cells.first_column, cells.first_row, samples_of(hull, grid_),
                     static_cast<float>(factor), sum);
  }
}

void WakeWindow::displace(const std::vector<WakeHull>& hulls) {
  std::vector<WakeHullShape> shapes = shapes_of(hulls);
  if (displaced_by_ && are_same(displaced_by_->hulls, shapes) && are_same(displaced_by_->grid, grid_)) return;
  displaced_.fill(0.0f);
  add_hulls(shapes, 1.0, displaced_);
  displaced_by_ = DisplacedBy{.hulls = std::move(shapes), .grid = grid_};
}

void WakeWindow::make_foam(const ForcingAt& forcing_at, double middle_s, const AddDisplaced& add_growth) {
  if (parameters_.foam_decay_s == 0.0) return;
  const std::int64_t every = steps_in(foam_step_s, parameters_);
  if (step_ % every != 0) return;
  const double since_s = static_cast<double>(every) * parameters_.step_s;
  const double cell_m = parameters_.cell_m();
  const double spread = std::min(foam_diffusion_m2ps * since_s / (cell_m * cell_m), most_mixed);
  growth_.fill(0.0f);
  // Nothing is known of the time before the first one.
  if (foam_step_number_) {
    add_hulls(shapes_of(forcing_at(middle_s).hulls), 1.0 / since_s, growth_);
    add_hulls(shapes_of(forcing_at(middle_s - since_s).hulls), -1.0 / since_s, growth_);
    if (add_growth) add_growth(middle_s, grid_, growth_);
  }
  const float second = parameters_.method == WakeMethod::verlet ? 0.0f : 1.0f;
  foam_step_.launch(in_runs(parameters_.cells), grid_, state_, displaced_, growth_, foam_, second,
                    static_cast<float>(std::exp(-since_s / parameters_.foam_decay_s)),
                    static_cast<float>(spread), next_foam_);
  std::swap(foam_, next_foam_);
  foam_step_number_ = step_;
}

void WakeWindow::break_waves() {
  const std::int64_t every = steps_to_breaking(parameters_);
  if (parameters_.method == WakeMethod::verlet || step_ % every != 0) return;
  break_.launch(in_runs(parameters_.cells), grid_, state_, displaced_,
                static_cast<float>(parameters_.dispersion.gravity_mps2),
                static_cast<float>(static_cast<double>(every) * parameters_.step_s), next_);
  std::swap(state_, next_);
}

void WakeWindow::rain() {
  if (drop_m_ == 0.0f) return;
  displaced_by_.reset();
  struct Seed {
    std::uint32_t low, high;
  };
  const std::uint64_t seed = parameters_.rain.seed;
  const double square_m = WAKE_RAIN_SQUARE * parameters_.cell_m();
  const auto squares = static_cast<std::size_t>(parameters_.cells / WAKE_RAIN_SQUARE);
  rain_.launch({{squares, squares, 1}}, grid_,
               Seed{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)},
               static_cast<std::uint32_t>(step_),
               static_cast<float>(parameters_.rain.drops_per_m2s * square_m * square_m * parameters_.step_s),
               drops_);
  hollows_.launch(whole(), grid_, drops_, drop_m_, displaced_);
}

void WakeWindow::step(const ForcingAt& forcing_at, double middle_s, const AddDisplaced& add_displaced,
                      const AddDisplaced& add_growth) {
  const WakeForcing forcing = forcing_at(middle_s);
  scroll_to(forcing.centre);
  displace(forcing.hulls);
  if (add_displaced) {
    add_displaced(middle_s, grid_, displaced_);
    displaced_by_.reset();
  }
  make_foam(forcing_at, middle_s, add_growth);
  break_waves();
  rain();
  if (parameters_.method == WakeMethod::verlet) {
    advance_verlet();
  } else {
    dispersive_->advance(grid_, displaced_, kept_, state_);
  }
}

void WakeWindow::advance_verlet() {
  const double part_s = parameters_.step_s / parts_;
  const auto courant = static_cast<float>(parameters_.speed_mps * part_s / parameters_.cell_m());
  for (int part = 0; part < parts_; ++part) {
    verlet_.launch(whole(), grid_, state_, displaced_, kept_, courant, next_);
    std::swap(state_, next_);
  }
}

void WakeWindow::draw(double time_s, ocl::Buffer<float>& map, std::size_t first,
                      const AddDisplaced& add_displaced) {
  const auto since_s = static_cast<float>(std::clamp(time_s - this->time_s(), 0.0, parameters_.step_s));
  if (parameters_.method == WakeMethod::verlet) {
    const double part_s = parameters_.step_s / parts_;
    differences_.launch(whole(), state_, parameters_.cells, grid_.cell_m,
                        static_cast<float>(parameters_.speed_mps * part_s / parameters_.cell_m()),
                        static_cast<float>(part_s), since_s, fields_);
  } else {
    if (add_displaced) {
      displaced_.fill(0.0f);
      displaced_by_.reset();
      add_displaced(this->time_s(), grid_, displaced_);
      press_.launch({{texels()}}, state_, displaced_, next_);
      forward_->transform(next_, next_);
    } else {
      forward_->transform(state_, next_);
    }
    spectrum_.launch(whole(), next_, omega_, parameters_.cells, since_s,
                     static_cast<float>(2.0 * pi / parameters_.length_m), fields_);
    fields_inverse_->transform(fields_, fields_);
  }
  map_.launch(whole(), grid_, fields_, blend_, static_cast<int>(first), map);
}

void WakeWindow::show(double time_s, const ocl::Buffer<float>& map, ocl::Buffer<float>& shown,
                      std::size_t first) {
  double left = 0.0;
  if (foam_step_number_ && parameters_.foam_decay_s > 0.0) {
    const double made_s = static_cast<double>(*foam_step_number_) * parameters_.step_s;
    left = std::exp(-std::max(time_s - made_s, 0.0) / parameters_.foam_decay_s);
  }
  shown_.launch(whole(), grid_, map, foam_, static_cast<float>(left), blend_, static_cast<int>(first), shown);
}

WakeFields unrolled_wake(const WakeGrid& grid, std::span<const float> map, std::span<const float> shown) {
  WakeFields fields;
  const int mask = grid.size - 1;
  for (int row = 0; row < grid.size; ++row) {
    for (int column = 0; column < grid.size; ++column) {
      const auto texel =
          4 * (static_cast<std::size_t>((grid.first_row + row) & mask) * static_cast<std::size_t>(grid.size) +
               static_cast<std::size_t>((grid.first_column + column) & mask));
      fields.height_m.push_back(map[texel]);
      fields.slope_x.push_back(map[texel + 1]);
      fields.slope_z.push_back(map[texel + 2]);
      fields.rise_mps.push_back(map[texel + 3]);
      fields.foam.push_back(shown[texel + 3]);
    }
  }
  return fields;
}

WakeFields WakeWindow::read(double time_s) {
  ocl::Buffer<float> map(device_, 4 * texels(), "wake map"), shown(device_, 4 * texels(), "wake shown");
  draw(time_s, map);
  show(time_s, map, shown);
  WakeFields fields = unrolled_wake(grid_, map.read(), shown.read());
  fields.cell_m = parameters_.cell_m();
  fields.origin_x_m = grid_.first_column * fields.cell_m;
  fields.origin_z_m = grid_.first_row * fields.cell_m;
  return fields;
}

WakeState WakeWindow::read_state() const {
  WakeState state;
  const auto values = state_.map();
  const int mask = parameters_.cells - 1;
  for (int row = 0; row < parameters_.cells; ++row) {
    for (int column = 0; column < parameters_.cells; ++column) {
      const auto place = 2 * (static_cast<std::size_t>((grid_.first_row + row) & mask) *
                                  static_cast<std::size_t>(parameters_.cells) +
                              static_cast<std::size_t>((grid_.first_column + column) & mask));
      state.height_m.push_back(values[place]);
      state.second_m.push_back(values[place + 1]);
    }
  }
  return state;
}

void WakeWindow::write_state(const WakeState& state) {
  if (state.height_m.size() != texels() || state.second_m.size() != texels()) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("wake state: expected {} values, found {} and {}", texels(),
                            state.height_m.size(), state.second_m.size()),
                "give both fields a value for each cell");
  }
  std::vector<float> values(2 * texels());
  const int mask = parameters_.cells - 1;
  std::size_t source = 0;
  for (int row = 0; row < parameters_.cells; ++row) {
    for (int column = 0; column < parameters_.cells; ++column, ++source) {
      const auto place = 2 * (static_cast<std::size_t>((grid_.first_row + row) & mask) *
                                  static_cast<std::size_t>(parameters_.cells) +
                              static_cast<std::size_t>((grid_.first_column + column) & mask));
      values[place] = state.height_m[source];
      values[place + 1] = state.second_m[source];
    }
  }
  state_.write(values);
}

}  // namespace offing::ocean
