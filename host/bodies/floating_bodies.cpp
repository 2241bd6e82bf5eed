#include "host/bodies/floating_bodies.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <glm/matrix.hpp>

#include "host/base/error.h"
#include "host/base/parameter_check.h"
#include "host/bodies/excitation.h"
#include "host/bodies/hull.h"
#include "host/bodies/hull_lift.h"
#include "host/bodies/radiation.h"
#include "host/ocl/program.h"
#include "host/ocl/tuning.h"

namespace offing::bodies {
namespace {

// Of a question: times closer than this to it are its own.
constexpr double time_tolerance = 1e-6;
// Of the times of a question's sub-steps: forces of waves are those at that time.
constexpr double middle_s = 0.5 * (FloatingBodies::steps_a_question - 1) / FloatingBodies::steps_per_s;

BodyWater device_water(const BodyWaterParameters& water) {
  require_within("bodies.density_kgpm3", water.density_kgpm3, 1.0, 1e5);
  require_within("bodies.gravity_mps2", water.gravity_mps2, 0.01, 100.0);
  require_within("bodies.viscosity_m2ps", water.viscosity_m2ps, 1e-9, 1.0);
  require_within("bodies.air_density_kgpm3", water.air_density_kgpm3, 0.0, 100.0);
  return {.density_kgpm3 = static_cast<float>(water.density_kgpm3),
          .gravity_mps2 = static_cast<float>(water.gravity_mps2),
          .viscosity_m2ps = static_cast<float>(water.viscosity_m2ps),
          .air_density_kgpm3 = static_cast<float>(water.air_density_kgpm3),
          .wind_x_mps = static_cast<float>(water.wind_mps.x),
          .wind_z_mps = static_cast<float>(water.wind_mps.y),
          .step_s = static_cast<float>(1.0 / FloatingBodies::steps_per_s),
          .steps = FloatingBodies::steps_a_question,
          .first_step = 0};
}

BodyShape device_shape(const FloatingBody& body) {
  const Extent extent = extent_of(body.hull);
  const glm::dmat3& inertia = body.inertia_kgm2;
  const glm::dmat3 inverse = glm::inverse((1.0 + body.drag.added_inertia) * inertia);
  const glm::dvec3 rudder = body.drive.rudder_m - body.mass_centre_m;
  const auto f = [](double value) { return static_cast<float>(value); };
  return {.propeller_vertex = 0,
          .first_face = 0,
          .face_count = static_cast<int>(body.hull.faces.size()),
          .mass_kg = f(body.mass_kg),
          .inertia_xx = f(inertia[0][0]),
          .inertia_yy = f(inertia[1][1]),
          .inertia_zz = f(inertia[2][2]),
          .inertia_xy = f(inertia[0][1]),
          .inertia_xz = f(inertia[0][2]),
          .inertia_yz = f(inertia[1][2]),
          .inverse_xx = f(inverse[0][0]),
          .inverse_yy = f(inverse[1][1]),
          .inverse_zz = f(inverse[2][2]),
          .inverse_xy = f(inverse[0][1]),
          .inverse_xz = f(inverse[0][2]),
          .inverse_yz = f(inverse[1][2]),
          .added_along = f(body.drag.added_along),
          .added_up = f(body.drag.added_up),
          .length_m = f(extent.high_m.x - extent.low_m.x),
          .face_drag = f(body.drag.face),
          .wake_drag = f(body.drag.wake),
          .wave_damping = body.hydrodynamics ? 0.0f : f(body.drag.waves),
          .propeller_diameter_m = f(body.drive.propeller_diameter_m),
          .rudder_x_m = f(rudder.x),
          .rudder_y_m = f(rudder.y),
          .rudder_z_m = f(rudder.z),
          .rudder_area_m2 = f(body.drive.rudder_area_m2),
          .rudder_lift = f(body.drive.rudder_lift),
          .lift_share = 0.0f,
          .lift_x_m = 0.0f,
          .lift_y_m = 0.0f,
          .lift_force_by_sway = 0.0f,
          .lift_force_by_yaw = 0.0f,
          .lift_moment_by_sway = 0.0f,
          .lift_moment_by_yaw = 0.0f,
          .first_memory_float = 0,
          .memory_samples = 0,
          .steps_a_sample = 1,
          .first_velocity_float = 0,
          .first_wave_float = 0,
          .wave_step_radps = 1.0f,
          .windage = f(body.drag.windage),
          .first_mooring = 0,
          .moorings = static_cast<int>(body.moorings.size())};
}

BodyMooring device_mooring(const MooringLine& line, const glm::dvec3& mass_centre_m) {
  const glm::dvec3 place_m = line.hull_m - mass_centre_m;
  const SurfaceQueryPoint anchor = tile_point(line.anchor_m.x, line.anchor_m.z);
  const auto f = [](double value) { return static_cast<float>(value); };
  return {.x_m = f(place_m.x),
          .y_m = f(place_m.y),
          .z_m = f(place_m.z),
          .anchor_tile_x = anchor.tile_x,
          .anchor_tile_z = anchor.tile_z,
          .anchor_x_m = anchor.x_m,
          .anchor_y_m = f(line.anchor_m.y),
          .anchor_z_m = anchor.z_m,
          .length_m = f(line.length_m),
          .stiffness_npm = f(line.stiffness_npm)};
}

void set_lift(const HullLift& lift, BodyShape& shape) {
  shape.lift_share = static_cast<float>(lift.share);
  shape.lift_x_m = static_cast<float>(lift.arm_m.x);
  shape.lift_y_m = static_cast<float>(lift.arm_m.y);
  shape.lift_force_by_sway = static_cast<float>(lift.force_by_sway_m2);
  shape.lift_force_by_yaw = static_cast<float>(lift.force_by_yaw_m3);
  shape.lift_moment_by_sway = static_cast<float>(lift.moment_by_sway_m3);
  shape.lift_moment_by_yaw = static_cast<float>(lift.moment_by_yaw_m4);
}

void append(const HullMatrix& matrix, std::vector<float>& floats) {
  for (const double value : matrix) floats.push_back(static_cast<float>(value));
}

}  // namespace

FloatingBodies::FloatingBodies(const ocl::Device& device, std::vector<FloatingBody> bodies,
                               const BodyWaterParameters& water)
    : device_(device),
      bodies_(std::move(bodies)),
      water_(device_water(water)),
      group_(ocl::tuning_for(device.info(), "body_advance").group) {
  if (bodies_.empty()) {
    throw Error(ErrorKind::bad_usage, "floating bodies: expected at least one, found none",
                "leave the simulation out where nothing floats");
  }
  for (const FloatingBody& body : bodies_) require_valid(body);

  std::vector<float> hull, memories, wave_tables;
  std::vector<BodyMooring> moorings;
  std::size_t velocities = 0;
  std::vector<std::uint32_t> owners, faces;
  for (std::uint32_t number = 0; number < bodies_.size(); ++number) {
    const FloatingBody& body = bodies_[number];
    const auto first = static_cast<std::uint32_t>(owners.size());
    const auto add_vertex = [&](const glm::dvec3& mesh_place_m) {
      const glm::dvec3 place_m = mesh_place_m - body.mass_centre_m;
      for (int axis = 0; axis < 3; ++axis) hull.push_back(static_cast<float>(place_m[axis]));
      owners.push_back(number);
    };
    for (const glm::dvec3& place : body.hull.positions_m) add_vertex(place);
    add_vertex(body.drive.propeller_m);
    BodyShape shape = device_shape(body);
    shape.propeller_vertex = static_cast<int>(owners.size() - 1);
    shape.first_face = static_cast<int>(faces.size() / 3);
    for (const TriangleIndices& face : body.hull.faces) {
      for (const std::uint32_t corner : face) faces.push_back(first + corner);
    }
    shape.first_mooring = static_cast<int>(moorings.size());
    for (const MooringLine& line : body.moorings)
      moorings.push_back(device_mooring(line, body.mass_centre_m));
    HullMatrix added_mass{};
    if (body.hydrodynamics) {
      const HullMemory made =
          memory_of_hull(*body.hydrodynamics, body.mass_centre_m, shape.length_m, steps_per_s);
      shape.first_memory_float = static_cast<int>(memories.size());
      shape.memory_samples = static_cast<int>(made.memory.size());
      shape.steps_a_sample = made.steps_a_sample;
      shape.first_velocity_float = static_cast<int>(velocities);
      added_mass = made.added_mass;
      append(made.added_mass, memories);
      for (const HullMatrix& matrix : made.memory) append(matrix, memories);
      velocities += BODY_MOTIONS * made.memory.size();
      const WaveTable waves = wave_table(body, water.density_kgpm3, water.gravity_mps2);
      shape.first_wave_float = static_cast<int>(wave_tables.size());
      shape.wave_step_radps = static_cast<float>(waves.step_radps);
      wave_tables.insert(wave_tables.end(), waves.values.begin(), waves.values.end());
    }
    set_lift(lift_of_hull(body, water.density_kgpm3, added_mass), shape);
    host_shapes_.push_back(shape);
  }
  vertices_ = owners.size();
  shapes_ = ocl::Buffer<BodyShape>(device, host_shapes_, "bodies");
  hull_ = ocl::Buffer<float>(device, hull, "hull vertices");
  // Devices have no buffers without elements.
  moorings.resize(std::max<std::size_t>(moorings.size(), 1));
  moorings_ = ocl::Buffer<BodyMooring>(device, moorings, "moorings of bodies");
  memories.resize(std::max<std::size_t>(memories.size(), 1));
  memory_ = ocl::Buffer<float>(device, memories, "memories of hulls");
  velocities_ = ocl::Buffer<float>(device, std::max<std::size_t>(velocities, 1), "velocities of hulls");
  wave_tables.resize(std::max<std::size_t>(wave_tables.size(), 1));
  wave_tables_ = ocl::Buffer<float>(device, wave_tables, "waves on hulls");
  excitation_ = ocl::Buffer<float>(device, size() * BODY_MOTIONS, "excitation of bodies");
  excitation_.fill(0.0f);
  waves_ = ocl::Buffer<BodyWave>(device, 1, "waves");
  owners_ = ocl::Buffer<std::uint32_t>(device, owners, "owners of hull vertices");
  faces_ = ocl::Buffer<std::uint32_t>(device, faces, "hull faces");
  points_ = ocl::Buffer<SurfaceQueryPoint>(device, vertices_, "points of hulls");
  samples_ = ocl::Buffer<SurfaceQueryShifted>(device, vertices_, "water at hulls");
  drives_ = ocl::Buffer<BodyDrive>(device, size() * steps_a_question, "drives of bodies");
  now_ = ocl::Buffer<BodyState>(device, size(), "states of bodies");
  before_ = ocl::Buffer<BodyState>(device, size(), "last states of bodies");
  path_ = ocl::Buffer<BodyState>(device, size() * steps_a_question, "steps of bodies");
  reports_ = ocl::Buffer<BodyReport>(device, size(), "forces on bodies");

  ocl::Defines defines;
  defines.set("GROUP", static_cast<long long>(group_));
  points_kernel_ = ocl::Program::build(device, "bodies/hull_points.cl").kernel("hull_points");
  waves_kernel_ = ocl::Program::build(device, "bodies/body_waves.cl", defines).kernel("body_waves");
  advance_kernel_ = ocl::Program::build(device, "bodies/body_advance.cl", defines).kernel("body_advance");
  reset(0.0);
}

FloatingBodies::~FloatingBodies() {
  // The device may still write to, or read from, host memory of ours.
  try {
    fetch_.done.wait();
    for (const Drives& drives : drives_ahead_) drives.sent.wait();
  } catch (const std::exception&) {
    // Whoever asks for results hears of it.
  }
}

double FloatingBodies::question_s(std::int64_t question) const {
  return reset_s_ + static_cast<double>(question * steps_a_question) / steps_per_s;
}

double FloatingBodies::stepped_to_s() const {
  return question_s(questions_);
}

void FloatingBodies::reset(double time_s) {
  require_within("bodies.time_s", time_s, -largest_time_s, largest_time_s);
  fetch_.done.wait();
  fetch_ = {};
  std::vector<BodyState> states;
  late_poses_.clear();
  for (const FloatingBody& body : bodies_) {
    states.push_back(device_state(body.start));
    late_poses_.push_back(body.start);
  }
  now_.write(states);
  before_.write(states);
  for (int step = 0; step < steps_a_question; ++step) {
    path_.write(states, static_cast<std::size_t>(step) * size());
  }
  reports_.write(std::vector<BodyReport>(size()));
  // A hull that starts at a speed has had it for long: its waves are steady, and do nothing to it.
  std::vector<float> had(velocities_.size());
  for (std::size_t body = 0; body < size(); ++body) {
    const BodyPose& start = bodies_[body].start;
    const glm::dvec3 velocity_mps = glm::conjugate(start.turn) * start.velocity_mps;
    for (int sample = 0; sample < host_shapes_[body].memory_samples; ++sample) {
      float* const kept = had.data() + host_shapes_[body].first_velocity_float + BODY_MOTIONS * sample;
      kept[0] = static_cast<float>(velocity_mps.x);
      kept[2] = static_cast<float>(velocity_mps.z);
    }
  }
  velocities_.write(had);
  reset_s_ = time_s_ = time_s;
  questions_ = 0;
  upload_waves();
}

void FloatingBodies::put(std::size_t body, const BodyPose& pose) {
  const BodyState state = device_state(pose);
  now_.write(std::span(&state, 1), body);
}

bool FloatingBodies::feels_waves() const {
  return std::any_of(bodies_.begin(), bodies_.end(),
                     [](const FloatingBody& body) { return body.hydrodynamics != nullptr; });
}

void FloatingBodies::set_wind(const glm::dvec2& wind_mps) {
  water_.wind_x_mps = static_cast<float>(wind_mps.x);
  water_.wind_z_mps = static_cast<float>(wind_mps.y);
}

void FloatingBodies::set_waves(const ModalSea& sea) {
  modes_ = leading_modes(sea);
  upload_waves();
}

void FloatingBodies::upload_waves() {
  if (modes_.empty() || !feels_waves()) {
    excitation_.fill(0.0f);
    return;
  }
  const std::vector<BodyWave> waves =
      device_waves(modes_, reset_s_ + middle_s, steps_a_question / steps_per_s, water_.gravity_mps2);
  if (waves_.size() < waves.size()) waves_ = ocl::Buffer<BodyWave>(device_, waves.size(), "waves");
  waves_.write(waves);
}

void FloatingBodies::advance_to(double time_s, const WaterSurface& water, const Drive& drive) {
  require_within("bodies.time_s", time_s, -largest_time_s, largest_time_s);
  const double asked = (time_s - reset_s_) * steps_per_s / steps_a_question;
  if (asked < std::max(0.0, static_cast<double>(questions_ - 1)) - time_tolerance) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("floating bodies: expected a time from {:.6g} s on, found {:.6g} s",
                            question_s(std::max<std::int64_t>(0, questions_ - 1)), time_s),
                "reset() starts again");
  }
  const auto needed = static_cast<std::int64_t>(std::ceil(asked - time_tolerance));
  while (questions_ < needed) ask_and_step(water, drive);
  time_s_ = time_s;
  fetch();
}

std::vector<BodyDrive> FloatingBodies::drives_from(const Drive& drive) const {
  std::vector<BodyDrive> drives(size() * steps_a_question, BodyDrive{});
  if (!drive) return drives;
  for (std::size_t body = 0; body < size(); ++body) {
    for (std::size_t step = 0; step < steps_a_question; ++step) {
      drives[body * steps_a_question + step] =
          drive(body, question_s(questions_) + static_cast<double>(step) / steps_per_s);
    }
  }
  return drives;
}

void FloatingBodies::send_drives(const Drive& drive) {
  std::vector<BodyDrive> values = drives_from(drive);
  // Most bodies drift, or run at one thrust: what the device has already is not sent again.
  const std::vector<BodyDrive>& last =
      drives_ahead_[(drives_sent_ + drives_ahead_.size() - 1) % drives_ahead_.size()].values;
  const bool is_there = values.size() == last.size() &&
                        std::memcmp(values.data(), last.data(), values.size() * sizeof(BodyDrive)) == 0;
  if (is_there) return;
  Drives& ahead = drives_ahead_[drives_sent_++ % drives_ahead_.size()];
  ahead.sent.wait();
  ahead.values = std::move(values);
  ahead.sent = drives_.begin_write(ahead.values.data());
}

void FloatingBodies::ask_and_step(const WaterSurface& water, const Drive& drive) {
  send_drives(drive);
  points_kernel_.launch({{vertices_}}, now_, hull_, owners_, points_);
  water(question_s(questions_), points_, vertices_, samples_);
  if (!modes_.empty() && feels_waves()) {
    const BodySea sea{.waves = static_cast<int>(modes_.size()),
                      .question = static_cast<int>(questions_),
                      .middle_s = static_cast<float>(middle_s)};
    waves_kernel_.launch({{size() * group_}, {group_}}, shapes_, now_, waves_, wave_tables_, sea,
                         excitation_);
  }
  BodyWater water_now = water_;
  water_now.first_step = static_cast<int>(steps());
  advance_kernel_.launch({{size() * group_}, {group_}}, shapes_, drives_, now_, hull_, faces_, points_,
                         samples_, moorings_, memory_, excitation_, water_now, velocities_, path_, before_,
                         reports_);
  std::swap(now_, before_);
  ++questions_;
}

void FloatingBodies::fetch() {
  if (fetch_.questions >= 0) {
    fetch_.done.wait();
    late_poses_ = poses_of(fetch_);
  }
  fetch_.before.resize(before_.size());
  fetch_.path.resize(path_.size());
  before_.begin_read(fetch_.before.data());
  fetch_.done = path_.begin_read(fetch_.path.data());
  fetch_.questions = questions_;
  fetch_.time_s = time_s_;
}

std::vector<BodyPose> FloatingBodies::read_poses() {
  if (fetch_.questions < 0) return late_poses_;
  fetch_.done.wait();
  return poses_of(fetch_);
}

std::vector<BodyPose> FloatingBodies::poses_of(const Fetch& fetch) const {
  const double steps =
      fetch.questions == 0 ? 0.0 : (fetch.time_s - question_s(fetch.questions - 1)) * steps_per_s;
  const double clamped = std::min(std::max(steps, 0.0), static_cast<double>(steps_a_question));
  const auto whole = std::min(static_cast<int>(clamped), steps_a_question - 1);
  std::vector<BodyPose> poses;
  for (std::size_t body = 0; body < size(); ++body) {
    const auto state = [&](int step) {
      return pose_of(step == 0 ? fetch.before[body]
                               : fetch.path[static_cast<std::size_t>(step - 1) * size() + body]);
    };
    poses.push_back(pose_between(state(whole), state(whole + 1), clamped - whole));
  }
  return poses;
}

}  // namespace offing::bodies
