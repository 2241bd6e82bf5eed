#include "host/world/world_bodies.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/time_estimate.h"
#include "host/bodies/built_in_data.h"
#include "host/bodies/hull.h"

namespace offing::world {
namespace {

// Rows of a path that are on their way at a time, so that a long way does not fill the queue.
constexpr std::size_t most_ahead = 64;

using bodies::FloatingBodies;

constexpr double question_s = FloatingBodies::steps_a_question / FloatingBodies::steps_per_s;
// Three frames at 30 a second.
constexpr double ahead_s = 0.1;
// Long enough for poses to come, short against a hull's way over a beach.
constexpr double shoal_lag_s = 0.3;
constexpr double longest_leap_s = 7200.0;
// Of the run-up, while hulls come to their weight: a hull that is put on the water at once throws a ring.
constexpr double settling_s = 5.0;
// How fast hulls move in the water is measured over this time or, where that is less than a cell of a wake
// window, over a cell, but no longer than this.
constexpr double growth_step_s = 1.0 / 30.0, longest_growth_s = 1.0;
// Samples of the shortest wave that counts: bilinear maps have lost 4 % of its height midway between them.
constexpr double samples_of_wave = 6.0;
constexpr int smallest_size = 16;

double shortest_hull_m(const std::vector<BodySettings>& settings) {
  double shortest_m = std::numeric_limits<double>::infinity();
  for (const BodySettings& each : settings) {
    const bodies::Extent extent = bodies::extent_of(each.body.hull);
    shortest_m = std::min(shortest_m, extent.high_m.x - extent.low_m.x);
  }
  return shortest_m;
}

ocean::WaterQuery query_of(const std::vector<BodySettings>& settings) {
  ocean::WaterQuery query;
  query.min_wavelength_m = std::min(shortest_hull_m(settings), ocean::longest_filter_m);
  query.tolerance_m = 1e-3;
  return query;
}

/// A sea's long waves alone: modes are drawn by their number, so that they are the same on coarser maps.
ocean::OceanParameters long_waves_of(const ocean::OceanParameters& whole, double min_wavelength_m) {
  ocean::OceanParameters kept = whole;
  kept.cascades.clear();
  const double k_max_radpm = ocean::largest_wavenumber_radpm(min_wavelength_m);
  double samples = smallest_size;
  for (const ocean::Cascade& cascade : whole.cascades) {
    if (!kept.cascades.empty() && cascade.k_min_radpm >= k_max_radpm) break;
    ocean::Cascade& last = kept.cascades.emplace_back(cascade);
    last.k_max_radpm = std::max(last.k_min_radpm, std::min(last.k_max_radpm, k_max_radpm));
    samples = std::max(
        samples, samples_of_wave * cascade.patch_length_m * last.k_max_radpm / (2.0 * std::numbers::pi));
  }
  while (kept.size / 2 >= samples) kept.size /= 2;
  return kept;
}

glm::dvec2 velocity_of(const ocean::Wind& wind) {
  return wind.wind_speed_mps *
         glm::dvec2(std::cos(wind.wind_direction_rad), std::sin(wind.wind_direction_rad));
}

std::vector<bodies::FloatingBody> bodies_of(const std::vector<BodySettings>& settings, double gravity_mps2) {
  std::vector<bodies::FloatingBody> bodies;
  for (const BodySettings& each : settings) {
    bodies::FloatingBody& body = bodies.emplace_back(each.body);
    if (!body.hydrodynamics) {
      body.hydrodynamics =
          bodies::built_in_data(body, bodies::BodyWaterParameters{}.density_kgpm3, gravity_mps2);
    }
  }
  return bodies;
}

/// Whole questions, so that one falls on the start.
double whole_questions_s(double duration_s) {
  return question_s * std::ceil(duration_s / question_s - 1e-9);
}

}  // namespace

BodyPath::~BodyPath() {
  // The device may still write to rows.
  try {
    if (!rows_.empty()) fetched_row(rows_.size() - 1);
  } catch (const std::exception&) {
    // Whoever asks for poses hears of it.
  }
}

void BodyPath::begin(double time_s, double step_s, const std::vector<bodies::BodyPose>& starts) {
  if (!rows_.empty()) fetched_row(rows_.size() - 1);
  rows_.clear();
  Row& first = rows_.emplace_back();
  for (const bodies::BodyPose& start : starts) first.states.push_back(bodies::device_state(start));
  fetched_ = 1;
  begin_s_ = time_s;
  step_s_ = step_s;
}

void BodyPath::add(const ocl::Buffer<BodyState>& states, const ocl::Buffer<BodyReport>* reports) {
  if (rows_.size() >= fetched_ + most_ahead) fetched_row(fetched_);
  Row& row = rows_.emplace_back();
  row.states.resize(states.size());
  row.fetched = states.begin_read(row.states.data());
  if (reports == nullptr) return;
  row.reports.resize(reports->size());
  row.fetched = reports->begin_read(row.reports.data());
}

const BodyPath::Row& BodyPath::fetched_row(std::size_t row) const {
  // One queue in order: with a row those before it have come.
  if (row >= fetched_) {
    rows_[row].fetched.wait();
    fetched_ = row + 1;
  }
  return rows_[row];
}

std::pair<std::size_t, double> BodyPath::place_of(double time_s) const {
  const double place = std::clamp((time_s - begin_s_) / step_s_, 0.0, static_cast<double>(rows_.size() - 1));
  const auto row = static_cast<std::size_t>(place);
  return {row, place - static_cast<double>(row)};
}

bodies::BodyPose BodyPath::at(std::size_t body, double time_s) const {
  const auto [before, share] = place_of(time_s);
  const bodies::BodyPose from = bodies::pose_of(fetched_row(before).states[body]);
  if (share == 0.0) return from;
  return bodies::pose_between(from, bodies::pose_of(fetched_row(before + 1).states[body]), share);
}

BodyReport BodyPath::report(std::size_t body, double time_s) const {
  const auto [before, share] = place_of(time_s);
  const auto of_row = [&](std::size_t row) {
    const std::vector<BodyReport>& reports = fetched_row(row).reports;
    return reports.empty() ? BodyReport{} : reports[body];
  };
  BodyReport report = of_row(before);
  if (share == 0.0) return report;
  const BodyReport next = of_row(before + 1);
  const auto mix = [part = static_cast<float>(share)](float& from, float to) { from += part * (to - from); };
  mix(report.displaced_m3, next.displaced_m3);
  mix(report.wetted_m2, next.wetted_m2);
  for (std::size_t i = 0; i < std::size(report.forces); ++i) mix(report.forces[i], next.forces[i]);
  return report;
}

WorldBodies::WorldBodies(const ocl::Device& device, std::vector<BodySettings> settings, const BodySea& sea,
                         double run_up_s, double start_s, const BodiesBefore& before)
    : device_(device),
      settings_(std::move(settings)),
      run_up_s_(whole_questions_s(run_up_s)),
      level_m_(sea.level_m),
      bodies_(device, bodies_of(settings_, sea.spectrum.dispersion.gravity_mps2),
              {.gravity_mps2 = sea.spectrum.dispersion.gravity_mps2, .wind_mps = velocity_of(sea.wind)}),
      sea_(device, sea.spectrum, long_waves_of(sea.ocean, shortest_hull_m(settings_))),
      query_(query_of(settings_)),
      path_(std::make_shared<BodyPath>()) {
  for (const BodySettings& each : settings_) {
    pressers_.emplace_back(device, *each.map, each.body.mass_centre_m);
  }
  set_shoals(sea.shoals);
  tell_waves();
  draught_m_ = total_draught_m();
  if (before.bodies != nullptr) {
    path_before_ = before.bodies->path_;
    numbers_before_ = before.numbers;
  }
  reset(start_s);
}

void WorldBodies::set_sea(const BodySea& sea) {
  sea_ = ocean::Ocean(device_, sea.spectrum, long_waves_of(sea.ocean, query_.min_wavelength_m));
  bodies_.set_wind(velocity_of(sea.wind));
  level_m_ = sea.level_m;
  set_shoals(sea.shoals);
  tell_waves();
}

void WorldBodies::set_gerstner_waves(const ocean::GerstnerSea& gerstner_waves) {
  sea_.set_gerstner_waves(gerstner_waves);
  tell_waves();
}

void WorldBodies::set_shoals(std::shared_ptr<const ocean::Shoals> shoals) {
  shoals_ = shoals;
  sea_.set_shoals(std::move(shoals));
}

/// What shoals take from waves where a body was a little earlier: a pose that has come, always that of the
/// same time. The mean of the cascades.
double WorldBodies::lost_wave_share(std::size_t body, double time_s) const {
  if (!shoals_) return 0.0;
  const glm::dvec3 place_m = pose(body, time_s - shoal_lag_s).mass_centre_m;
  const auto shares = shoals_->instant().at(place_m.x, place_m.z);
  const std::size_t cascades = std::min<std::size_t>(sea_.parameters().cascades.size(), SHOAL_FIRST_GERSTNER);
  double sum = 0.0;
  for (std::size_t cascade = 0; cascade < cascades; ++cascade) sum += std::min(shares[cascade], 1.0);
  return cascades > 0 ? 1.0 - sum / static_cast<double>(cascades) : 0.0;
}

/// The waves that bodies float on.
void WorldBodies::tell_waves() {
  if (!bodies_.feels_waves()) return;
  ModalSea sea = sea_.modes();
  const double k_max_radpm = ocean::largest_wavenumber_radpm(query_.min_wavelength_m);
  std::erase_if(sea.modes, [k_max_radpm](const SeaMode& mode) {
    return std::hypot(mode.kx_radpm, mode.kz_radpm) > k_max_radpm;
  });
  bodies_.set_waves(sea);
}

void WorldBodies::reset(double start_s) {
  start_s_ = start_s;
  bodies_.reset(start_s - run_up_s_);
  std::vector<bodies::BodyPose> starts;
  for (const BodySettings& each : settings_) starts.push_back(each.body.start);
  for (std::size_t body = 0; path_before_ && body < size(); ++body) {
    if (numbers_before_[body]) starts[body] = path_before_->at(*numbers_before_[body], start_s - run_up_s_);
  }
  path_->begin(start_s - run_up_s_, question_s, starts);
  follow_paths_before();
}

/// In the run-up, whose wakes are then those that these bodies have.
void WorldBodies::follow_paths_before() {
  if (!path_before_) return;
  const double now_s = bodies_.stepped_to_s();
  if (now_s > start_s_ + 0.5 * question_s) {
    path_before_.reset();
    return;
  }
  for (std::size_t body = 0; body < size(); ++body) {
    if (numbers_before_[body]) bodies_.put(body, path_before_->at(*numbers_before_[body], now_s));
  }
}

void WorldBodies::ask_sea(double time_s, const ocl::Buffer<SurfaceQueryPoint>& points, std::size_t count,
                          ocl::Buffer<SurfaceQueryShifted>& samples) {
  sea_.at(time_s);
  sea_.sample(points, count, samples, query_);
}

void WorldBodies::reach(double time_s) {
  // A start that an edit has put later is not that of times before it.
  if (time_s < start_s_ && start_s_ > 0.0) {
    path_before_.reset();
    reset(0.0);
  }
  if (time_s - path_->end_s() > longest_leap_s) {
    throw Error(ErrorKind::bad_input,
                fmt::format("time: expected within {:g} s of the bodies' {:g} s, found {:g} s",
                            longest_leap_s, path_->end_s(), time_s),
                "bodies are simulated from their start on: choose an earlier time, or a scene without them");
  }
  const auto water = [this](double at_s, const auto& points, std::size_t count, auto& samples) {
    ask_sea(at_s, points, count, samples);
  };
  const auto drive = [this](std::size_t body, double at_s) {
    BodyDrive driven = settings_[body].drive(at_s, start_s_);
    driven.lost_wave_share = static_cast<float>(lost_wave_share(body, at_s));
    return driven;
  };
  const double missing_s = std::max(time_s + ahead_s - path_->end_s(), 0.0);
  TimeEstimate estimate(static_cast<std::int64_t>(missing_s / question_s) + 1,
                        fmt::format("time: {:.0f} s of floating bodies", missing_s),
                        "choose an earlier time, a smaller ocean.size, or fewer bodies");
  while (path_->end_s() < time_s + ahead_s) {
    bodies_.advance_to(bodies_.stepped_to_s() + question_s, water, drive);
    follow_paths_before();
    path_->add(bodies_.latest(), keeps_forces_ ? &bodies_.reports() : nullptr);
    estimate.step_done([this] { device_.finish(); });
  }
}

bodies::BodyPose WorldBodies::pose(std::size_t body, double time_s) const {
  bodies::BodyPose pose = pose_on_sea(body, time_s);
  pose.mass_centre_m.y += level_m_;
  return pose;
}

std::function<highlights::RigidMotion(double)> WorldBodies::motion_of_hull(std::size_t body) const {
  return [path = std::shared_ptr<const BodyPath>(path_), body, level_m = level_m_,
          centre_m = settings_[body].body.mass_centre_m](double time_s) {
    const bodies::BodyPose pose = path->at(body, time_s);
    const glm::dmat3 turn = glm::mat3_cast(pose.turn);
    return highlights::RigidMotion{
        .rotation = turn,
        .translation_m = pose.mass_centre_m + glm::dvec3(0.0, level_m, 0.0) - turn * centre_m};
  };
}

/// Of their weight that hulls have come to in the run-up.
double WorldBodies::settled_share(double time_s) const {
  const double settled =
      run_up_s_ > 0.0 ? std::clamp((time_s - begin_s()) / std::min(settling_s, run_up_s_), 0.0, 1.0) : 1.0;
  return settled * settled * (3.0 - 2.0 * settled);
}

void WorldBodies::press(double time_s, const WakeGrid& grid, ocl::Buffer<float>& displaced) const {
  for (std::size_t body = 0; body < size(); ++body) {
    pressers_[body].press(pose_on_sea(body, time_s), settled_share(time_s), grid, displaced);
  }
}

void WorldBodies::add_growth(double time_s, const WakeGrid& grid, ocl::Buffer<float>& growth) const {
  for (std::size_t body = 0; body < size(); ++body) {
    const bodies::BodyPose now = pose_on_sea(body, time_s),
                           before = pose_on_sea(body, time_s - growth_step_s);
    const glm::dvec2 speed_mps = glm::dvec2(now.velocity_mps.x, now.velocity_mps.z) - now.flow_mps;
    const double volume_rate_m3ps = (now.displaced_m3 - before.displaced_m3) / growth_step_s;
    // The difference over a way of a cell or more: a hull's edge that passes a sample of a cell is a jump.
    const double slowest_mps = static_cast<double>(grid.cell_m) / longest_growth_s;
    const double span_s = std::max(
        growth_step_s, static_cast<double>(grid.cell_m) / std::max(glm::length(speed_mps), slowest_mps));
    for (const double side : {0.5, -0.5}) {
      bodies::BodyPose moved = now;
      moved.mass_centre_m += side * span_s * glm::dvec3(speed_mps.x, 0.0, speed_mps.y);
      moved.displaced_m3 += side * span_s * volume_rate_m3ps;
      pressers_[body].press(moved, 2.0 * side * settled_share(time_s) / span_s, grid, growth);
    }
  }
}

double WorldBodies::total_draught_m() const {
  double sum_m = 0.0;
  for (std::size_t body = 0; body < size(); ++body) {
    const bodies::FloatingBody& each = settings_[body].body;
    const double volume_m3 = each.mass_kg / bodies::BodyWaterParameters{}.density_kgpm3;
    sum_m += pressers_[body].level_m(volume_m3) - bodies::extent_of(each.hull).low_m.y;
  }
  return sum_m;
}

}  // namespace offing::world
