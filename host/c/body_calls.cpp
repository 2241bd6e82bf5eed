#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "host/bodies/body_forces.h"
#include "host/c/arrays.h"
#include "host/c/handles.h"

using offing::c::require;
using offing::c::require_count;
using offing::c::run;
using offing::c::Use;
using offing::c::write_values;
using offing::c::write_vector;

namespace {

std::size_t count_of_bodies(const OffingWorld& world) {
  const offing::world::WorldBodies* bodies = world.world.bodies();
  return bodies == nullptr ? 0 : bodies->size();
}

void write_pose(const OffingBodyPoses& poses, std::size_t index, const offing::bodies::BodyPose& pose) {
  write_vector(poses.mass_centre_m, index, pose.mass_centre_m);
  write_values(poses.turn, index, {pose.turn.w, pose.turn.x, pose.turn.y, pose.turn.z});
  write_vector(poses.velocity_mps, index, pose.velocity_mps);
  write_vector(poses.spin_radps, index, pose.spin_radps);
  write_values(poses.displaced_m3, index, {pose.displaced_m3});
}

void write_report(const OffingBodyForces& forces, std::size_t index, const BodyReport& report) {
  using offing::bodies::force_of;
  using offing::bodies::moment_of;
  write_vector(forces.pressure_n, index, force_of(report, BODY_PRESSURE));
  write_vector(forces.pressure_moment_nm, index, moment_of(report, BODY_PRESSURE));
  write_vector(forces.drag_n, index, force_of(report, BODY_DRAG));
  write_vector(forces.drag_moment_nm, index, moment_of(report, BODY_DRAG));
  write_values(forces.displaced_m3, index, {report.displaced_m3});
  write_values(forces.wetted_m2, index, {report.wetted_m2});
  if (forces.forces != nullptr) {
    std::copy(std::begin(report.forces), std::end(report.forces),
              forces.forces + index * std::size(report.forces));
  }
}

static_assert(static_cast<int>(OFFING_FORCE_KINDS) == static_cast<int>(BODY_FORCE_KINDS));

}  // namespace

size_t offing_body_count(const OffingWorld* world) {
  return world == nullptr ? 0 : count_of_bodies(*world);
}

const char* offing_body_name(const OffingWorld* world, size_t body) {
  return body < offing_body_count(world) ? world->scene.bodies[body].name.c_str() : "";
}

const char* offing_body_force_name(int kind) {
  return kind >= 0 && kind < BODY_FORCE_KINDS
             ? offing::bodies::force_kinds[static_cast<std::size_t>(kind)].name
             : "";
}

OffingStatus offing_read_body_poses(OffingWorld* world, size_t count, const OffingBodyPoses* poses) {
  return run([&] {
    const Use use(world, "world");
    require_count("count", count, count_of_bodies(*world));
    if (count == 0) return;
    require(poses, "poses");
    const OffingBodyPoses wanted = offing::c::read_struct(poses, "poses");
    for (std::size_t body = 0; body < count; ++body)
      write_pose(wanted, body, world->world.bodies()->pose(body, world->world.time_s()));
  });
}

OffingStatus offing_read_body_forces(OffingWorld* world, size_t count, const OffingBodyForces* forces) {
  return run([&] {
    const Use use(world, "world");
    require_count("count", count, count_of_bodies(*world));
    if (count == 0) return;
    require(forces, "forces");
    const OffingBodyForces wanted = offing::c::read_struct(forces, "forces");
    const offing::world::WorldBodies& bodies = *world->world.bodies();
    const std::vector<BodyReport> reports = bodies.read_reports();
    for (std::size_t body = 0; body < count; ++body) write_report(wanted, body, reports[body]);
    write_values(wanted.time_s, 0, {bodies.reported_s()});
  });
}
