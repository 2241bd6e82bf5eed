// Rigid bodies on water for some sub-steps: a work-group a body, of GROUP work-items, a power of two.
// In:  shapes [bodies], drives [bodies][steps], states [bodies] at the first sub-step, water, all of shared/bodies.h;
//      vertices [vertices][3] m in body axes; faces [faces][3]: vertices, anticlockwise seen from outside;
//      points, samples [vertices]: the water under the vertices at the first sub-step (ocean/surface_query.cl);
//      moorings: lines of bodies, as BodyShape says;
//      memory: added mass and retardation, as BodyShape says; excitation [bodies][BODY_MOTIONS]: of body_waves.cl.
// Inout: velocities: those that bodies have had, [memory_samples][BODY_MOTIONS] of each, a ring.
// Out: path [steps][bodies]: the states after each sub-step; ends [bodies]: those after the last one; reports [bodies] of
//      that one.
// The water at a later sub-step is that of the first one, moved on along its slope and by the speed of its surface:
// height' = v_y - v_x slope_x - v_z slope_z. Each wetted part of a face has
//  - the pressure of the water above it, density * gravity * depth, integrated in closed form;
//  - friction along it (ITTC 1957), drag of its speed across it, which is less where it moves away from the water;
//  - (of the whole hull) a sway force and a yaw moment while it runs ahead, as those of a wing (Clarke et al. 1983);
//  - damping by the waves that what faces downward makes, in proportion to its vertical speed.
// Each dry part has the pressure of the wind on walls.
// A body with a memory moves by Cummins' equation: (M + A) a + C(v) v + sum of K v' = force, in body axes, C being the
// Coriolis terms of the mass and, in surge, sway and yaw, of added mass (Fossen 2011, sections 6.3 and 7.3), by Cayley's
// step, which keeps energy. Those of added mass in pitch would lift the bow of a fast hull, with no free surface and no
// water that parts from its stern to hold it. Added mass and
// retardation fade from half its displacement on, so that they are not those of a body in the air. So does what waves do
// to it besides the pressure below their surface.
// Semi-implicit Euler: velocities first, then places by the new ones. Drag, wind, the rudder's lift and lines are each
// weakened as an implicit step would, so that none turns a motion around. Speed and spin have bounds far above those of
// any hull (shared/bodies.h): what no step of this length can follow, such as a thrust of 1e9 N on a toy, stays a motion.
#include "bodies/turn.clh"
#include "shared/bodies.h"
#include "shared/query_params.h"

// Of a rudder behind a hull and a propeller (Yasukawa & Yoshimura 2015, table 4: kappa, eta, gamma).
#define RUDDER_RACE_GROWTH 0.5f
#define RUDDER_RACE_SHARE 0.63f
#define RUDDER_STRAIGHTENED 0.65f

// Of walls in wind, by the speed of the air across them (EN 1991-1-4, table 7.1, zones D and E of a cube).
#define WIND_ON_FACE 0.8f
#define WIND_BEHIND 0.5f
// Wind grows as this power of height over waves (DNV-RP-C205, section 2.3), from a tenth of a metre on.
#define WIND_GROWTH 0.12f
#define WIND_FROM_M 0.1f

// The part of a triangle that is under water, where depth is linear over the triangle: integrals in closed form.
typedef struct {
  float area;           // m^2
  float3 area_moment;   // integral of place over area, m^3
  float depth_area;     // of depth, m^3
  float3 depth_moment;  // of place times depth, m^4
} WettedPart;

static void set_whole_part(float area, const float3* place, const float* depth, WettedPart* part) {
  const float3 places = place[0] + place[1] + place[2];
  const float depths = depth[0] + depth[1] + depth[2];
  part->area = area;
  part->area_moment = area / 3.0f * places;
  part->depth_area = area / 3.0f * depths;
  part->depth_moment =
      area / 12.0f * (depth[0] * place[0] + depth[1] * place[1] + depth[2] * place[2] + depths * places);
}

// The part at corner `odd`, whose depth has another sign than the others: it is cut off where depth is 0.
static void set_corner_part(float area, const float3* place, const float* depth, int odd, WettedPart* part) {
  const int next = (odd + 1) % 3, last = (odd + 2) % 3;
  const float along = depth[odd] / (depth[odd] - depth[next]), across = depth[odd] / (depth[odd] - depth[last]);
  const float3 places[3] = {place[odd], mix(place[odd], place[next], along), mix(place[odd], place[last], across)};
  const float depths[3] = {depth[odd], 0.0f, 0.0f};
  set_whole_part(area * along * across, places, depths, part);
}

static void set_wetted_part(float area, const float3* place, const float* depth, WettedPart* part) {
  const int wet = (depth[0] > 0.0f) + (depth[1] > 0.0f) + (depth[2] > 0.0f);
  if (wet == 3) {
    set_whole_part(area, place, depth, part);
    return;
  }
  part->area = part->depth_area = 0.0f;
  part->area_moment = part->depth_moment = (float3)(0.0f);
  if (wet == 0) return;
  const bool is_odd_wet = wet == 1;
  int odd = 0;
  if ((depth[1] > 0.0f) == is_odd_wet) odd = 1;
  if ((depth[2] > 0.0f) == is_odd_wet) odd = 2;
  if (is_odd_wet) {
    set_corner_part(area, place, depth, odd, part);
    return;
  }
  WettedPart dry;
  set_corner_part(area, place, depth, odd, &dry);
  set_whole_part(area, place, depth, part);
  part->area -= dry.area;
  part->area_moment -= dry.area_moment;
  part->depth_area -= dry.depth_area;
  part->depth_moment -= dry.depth_moment;
}

typedef struct {
  float3 place, velocity, spin;  // velocity in world axes, spin in body axes
  float4 turn;
} Motion;

typedef struct {
  float3 pressure, pressure_moment, drag, drag_moment;
  float wetted;
  float2 shift;  // of the water from its place at rest along x and z, times the wetted area
  float3 flow;  // velocity of the water, times the wetted area
  float3 wind, wind_moment;
} Wrench;

typedef struct {
  float3 force, moment;
} Push;

static float3 symmetric_product(float xx, float yy, float zz, float xy, float xz, float yz, float3 v) {
  return (float3)(xx * v.x + xy * v.y + xz * v.z, xy * v.x + yy * v.y + yz * v.z, xz * v.x + yz * v.y + zz * v.z);
}

static float3 inverse_inertia_times(const BodyShape* shape, float3 v) {
  return symmetric_product(shape->inverse_xx, shape->inverse_yy, shape->inverse_zz, shape->inverse_xy,
                           shape->inverse_xz, shape->inverse_yz, v);
}

static float3 no_longer_than(float most, float3 v) {
  const float size = length(v);
  return size > most ? v * (most / size) : v;
}

static float3 surface_velocity(const SurfaceQuerySample* sample) {
  return (float3)(sample->velocity_x_mps, sample->velocity_y_mps, sample->velocity_z_mps);
}

// How deep a vertex at `arm` from the mass centre is below the surface `time_s` after the sample.
static float depth_of(const BodyState* origin, float3 place, float3 arm, SurfaceQueryPoint point,
                      const SurfaceQuerySample* sample, float time_s) {
  const float x = SURFACE_QUERY_TILE_M * (float)(origin->tile_x - point.tile_x) + (place.x + arm.x - point.x_m);
  const float z = SURFACE_QUERY_TILE_M * (float)(origin->tile_z - point.tile_z) + (place.z + arm.z - point.z_m);
  const float rise = sample->velocity_y_mps - sample->velocity_x_mps * sample->slope_x - sample->velocity_z_mps * sample->slope_z;
  return sample->height_m + sample->slope_x * x + sample->slope_z * z + rise * time_s - (place.y + arm.y);
}

static void clear(Wrench* wrench) {
  wrench->pressure = wrench->pressure_moment = wrench->drag = wrench->drag_moment = (float3)(0.0f);
  wrench->flow = wrench->wind = wrench->wind_moment = (float3)(0.0f);
  wrench->wetted = 0.0f;
  wrench->shift = (float2)(0.0f);
}

// Friction of a plate along the flow, ITTC 1957: 0.075 / (log10 Re - 2)^2; below Re = 10^5 as there.
static float friction_coefficient(float reynolds) {
  const float digits = log10(fmax(reynolds, 1e5f)) - 2.0f;
  return 0.075f / (digits * digits);
}

// Drag of a face by its speed across, per density * area.
static float form_drag(const BodyShape* shape, float across) {
  return 0.5f * (across > 0.0f ? shape->face_drag : shape->wake_drag) * fabs(across) * across;
}

// What the wind does to the part of a face that is dry, added to `sum`.
static void add_wind(const BodyShape* shape, const BodyWater* water, float3 velocity, float3 spin, float3 normal,
                     const WettedPart* dry, Wrench* sum) {
  const float3 middle = dry->area_moment / dry->area;
  const float height = fmax(-dry->depth_area / dry->area, WIND_FROM_M);
  const float3 wind = pow(height / 10.0f, WIND_GROWTH) * (float3)(water->wind_x_mps, 0.0f, water->wind_z_mps);
  const float across = dot(velocity + cross(spin, middle) - wind, normal);
  const float3 push = -0.5f * shape->windage * water->air_density_kgpm3 * dry->area *
                      (across > 0.0f ? WIND_ON_FACE : WIND_BEHIND) * fabs(across) * across * normal;
  sum->wind += push;
  sum->wind_moment += cross(middle, push);
}

// What water and wind do to a face, added to `sum`.
static void add_face(const BodyShape* shape, const BodyWater* water, float3 velocity, float3 spin, float3 forward, float friction,
                     const float3* arm, const float* depth, float3 flow, float2 shift, Wrench* sum) {
  const float3 twice = cross(arm[1] - arm[0], arm[2] - arm[0]);
  const float area = 0.5f * length(twice);
  if (!(area > 0.0f)) return;
  const float3 normal = twice / (2.0f * area);
  WettedPart part, dry;
  set_wetted_part(area, arm, depth, &part);
  set_whole_part(area, arm, depth, &dry);
  dry.area -= part.area;
  dry.area_moment -= part.area_moment;
  dry.depth_area -= part.depth_area;
  if (dry.area > 1e-5f * area) add_wind(shape, water, velocity, spin, normal, &dry, sum);
  if (!(part.area > 0.0f)) return;
  const float weight = water->density_kgpm3 * water->gravity_mps2;
  sum->pressure -= weight * part.depth_area * normal;
  sum->pressure_moment -= weight * cross(part.depth_moment, normal);

  const float3 middle = part.area_moment / part.area;
  const float3 speed = velocity + cross(spin, middle) - flow;
  const float across = dot(speed, normal);
  const float3 along = speed - across * normal;
  const float density_area = water->density_kgpm3 * part.area;
  // Squares of a sum have a side force in proportion to drift. A long hull has that of add_lift() instead, so that its
  // cross-flow drags as if it did not run ahead: (a|a| + b|b|)(a + b) >= 0 does no work on it either.
  const float ahead = dot(speed, forward) * dot(forward, normal);
  const float form = mix(form_drag(shape, across), form_drag(shape, ahead) + form_drag(shape, across - ahead),
                         shape->lift_share);
  float3 drag = -density_area * (form * normal + 0.5f * friction * length(along) * along);
  drag.y -= density_area * fmax(0.0f, -normal.y) * shape->wave_damping * sqrt(water->gravity_mps2 * shape->length_m) *
            speed.y;
  sum->drag += drag;
  sum->drag_moment += cross(middle, drag);
  sum->wetted += part.area;
  sum->flow += part.area * flow;
  sum->shift += part.area * shift;
}

// Of the water around the hull.
static float3 mean_flow(const Wrench* wrench) {
  return wrench->wetted > 0.0f ? wrench->flow / wrench->wetted : (float3)(0.0f);
}

// Of water, by the force that it lifts with.
static float displaced_by(const BodyWater* water, const Wrench* wrench) {
  return fmax(0.0f, wrench->pressure.y / (water->density_kgpm3 * water->gravity_mps2));
}

// Of what water does to a body at rest: less from half of its displacement on.
static float wetted_share(const BodyShape* shape, const BodyWater* water, const Wrench* wrench) {
  return clamp(2.0f * water->density_kgpm3 * displaced_by(water, wrench) / shape->mass_kg, 0.0f, 1.0f);
}

// Sway force and yaw moment of a hull that runs ahead, added to the drag of `sum`; they fade like added mass.
static void add_lift(const BodyShape* shape, const BodyWater* water, const Motion* motion, Wrench* sum) {
  if (!(sum->wetted > 0.0f)) return;
  const float3 forward = turned(motion->turn, (float3)(1.0f, 0.0f, 0.0f));
  const float3 starboard = turned(motion->turn, (float3)(0.0f, 0.0f, 1.0f));
  const float3 arm = turned(motion->turn, (float3)(shape->lift_x_m, shape->lift_y_m, 0.0f));
  const float3 speed =
      motion->velocity + cross(turned(motion->turn, motion->spin), arm) - sum->flow / sum->wetted;
  const float ahead = dot(speed, forward), sway = dot(speed, starboard), yaw = motion->spin.y;
  const float density = water->density_kgpm3 * wetted_share(shape, water, sum);
  const float3 side =
      -density * (fabs(ahead) * shape->lift_force_by_sway * sway + ahead * shape->lift_force_by_yaw * yaw) * starboard;
  const float turning =
      -density * (ahead * shape->lift_moment_by_sway * sway + fabs(ahead) * shape->lift_moment_by_yaw * yaw);
  sum->drag += side;
  sum->drag_moment += cross(arm, side) + turned(motion->turn, (float3)(0.0f, turning, 0.0f));
}

// Velocity that a push along a direction gives to a place on the body: 1 / kg.
static float yielding(const BodyShape* shape, const Motion* motion, float3 place, float3 direction) {
  const float3 lever = turned_back(motion->turn, cross(place, direction));
  return 1.0f / shape->mass_kg + dot(lever, inverse_inertia_times(shape, lever));
}

// What resists the motion in something that flows, weakened as an implicit step would.
static void set_weakened(const BodyShape* shape, const BodyWater* water, const Motion* motion, float3 flow, float3 force,
                         float3 moment, Push* push) {
  const float reach = 0.5f * shape->length_m;
  const float pace = length(motion->velocity - flow) + (reach * length(motion->spin) + 1e-6f);
  const float least_inertia = fmin(shape->inertia_xx, fmin(shape->inertia_yy, shape->inertia_zz));
  push->force = force / (1.0f + water->step_s * length(force) / (shape->mass_kg * pace));
  push->moment = moment / (1.0f + water->step_s * length(moment) * reach / (least_inertia * pace));
}

static void set_push(float3 force, float3 place, Push* push) {
  push->force = force;
  push->moment = cross(place, force);
}

// Thrust and rudder, in world axes.
static void set_drive(const BodyShape* shape, const BodyWater* water, const BodyDrive* drive, const Motion* motion,
                      float3 flow, float3 propeller, float propeller_depth, Push* pushes) {
  const float3 forward = turned(motion->turn, (float3)(1.0f, 0.0f, 0.0f));
  const float3 starboard = turned(motion->turn, (float3)(0.0f, 0.0f, 1.0f));
  const float diameter = shape->propeller_diameter_m;
  const float thrust = drive->thrust_n * clamp(0.5f + propeller_depth / diameter, 0.0f, 1.0f);
  set_push(thrust * forward, propeller, &pushes[BODY_PROPELLER]);

  const float3 rudder = turned(motion->turn, (float3)(shape->rudder_x_m, shape->rudder_y_m, shape->rudder_z_m));
  const float3 speed = motion->velocity + cross(turned(motion->turn, motion->spin), rudder) - flow;
  const float ahead = dot(speed, forward);
  // The propeller's race, by the theory of momentum: half of its growth at the rudder, over 0.63 of it (Yasukawa &
  // Yoshimura 2015).
  const float fast = sqrt(ahead * ahead + 8.0f * fmax(thrust, 0.0f) / (M_PI_F * diameter * diameter * water->density_kgpm3));
  const float race = fabs(ahead) + RUDDER_RACE_GROWTH * (fast - fabs(ahead));
  const float along = sqrt(mix(ahead * ahead, race * race, RUDDER_RACE_SHARE));
  const float immersed = clamp(0.5f + propeller_depth / diameter, 0.0f, 1.0f);
  const float lift_by_speed =
      0.5f * water->density_kgpm3 * shape->rudder_area_m2 * shape->rudder_lift * along * immersed;
  const float3 across = cos(drive->rudder_rad) * starboard + sin(drive->rudder_rad) * forward;
  // The hull straightens the flow to the rudder. Its force stands across the blade.
  const float ahead_sign = ahead + fast > 0.0f ? 1.0f : -1.0f;
  const float attack = ahead_sign * along * sin(drive->rudder_rad) +
                       RUDDER_STRAIGHTENED * dot(speed, starboard) * cos(drive->rudder_rad);
  const float held = 1.0f + water->step_s * lift_by_speed * yielding(shape, motion, rudder, across);
  set_push(-lift_by_speed * attack / held * across, rudder, &pushes[BODY_RUDDER]);
}

static void set_mooring(const BodyShape* shape, const BodyWater* water, __global const BodyMooring* moorings,
                        const BodyState* origin, const Motion* motion, Push* sum) {
  sum->force = sum->moment = (float3)(0.0f);
  const float step = water->step_s;
  for (int i = 0; i < shape->moorings; ++i) {
    const BodyMooring line = moorings[shape->first_mooring + i];
    const float3 arm = turned(motion->turn, (float3)(line.x_m, line.y_m, line.z_m));
    const float3 anchor =
        (float3)(SURFACE_QUERY_TILE_M * (float)(line.anchor_tile_x - origin->tile_x) + line.anchor_x_m, line.anchor_y_m,
                 SURFACE_QUERY_TILE_M * (float)(line.anchor_tile_z - origin->tile_z) + line.anchor_z_m);
    const float3 way = anchor - motion->place - arm;
    const float distance = length(way), stretch = distance - line.length_m;
    if (!(stretch > 0.0f)) continue;
    const float3 toward = way / distance;
    const float nearing = dot(motion->velocity + cross(turned(motion->turn, motion->spin), arm), toward);
    // At the end of the step.
    const float held = 1.0f + step * step * line.stiffness_npm * yielding(shape, motion, arm, toward);
    const float tension = fmax(0.0f, line.stiffness_npm * (stretch - step * nearing) / held);
    sum->force += tension * toward;
    sum->moment += cross(arm, tension * toward);
  }
}

static void follow_path(const BodyDrive* drive, const BodyState* origin, Motion* motion) {
  motion->place.x = SURFACE_QUERY_TILE_M * (float)(drive->tile_x - origin->tile_x) + drive->x_m;
  motion->place.z = SURFACE_QUERY_TILE_M * (float)(drive->tile_z - origin->tile_z) + drive->z_m;
  motion->velocity.x = drive->velocity_x_mps;
  motion->velocity.z = drive->velocity_z_mps;
  const float3 forward = turned(motion->turn, (float3)(1.0f, 0.0f, 0.0f));
  // A turn about +y takes +x toward -z.
  const float excess = atan2(forward.z, forward.x) - drive->heading_rad;
  motion->turn = normalize(turn_product(turn_by((float3)(0.0f, excess, 0.0f)), motion->turn));
  float3 spin = turned(motion->turn, motion->spin);
  spin.y = -drive->heading_rate_radps;
  motion->spin = turned_back(motion->turn, spin);
}

typedef struct {
  float at[BODY_MATRIX];
} Matrix;

// Velocity or momentum along and about the axes.
typedef struct {
  float at[BODY_MOTIONS];
} Motions;

// Results by pointer: Oclgrind does not run structs that are returned.
static void set_motions(float3 along, float3 about, Motions* made) {
  vstore3(along, 0, made->at);
  vstore3(about, 1, made->at);
}

static float3 along_of(const Motions* motions) {
  return (float3)(motions->at[0], motions->at[1], motions->at[2]);
}

static float3 about_of(const Motions* motions) {
  return (float3)(motions->at[3], motions->at[4], motions->at[5]);
}

static void set_product(const Matrix* matrix, const Motions* motions, Motions* made) {
  for (int i = 0; i < BODY_MOTIONS; ++i) {
    made->at[i] = 0.0f;
    for (int j = 0; j < BODY_MOTIONS; ++j) made->at[i] += matrix->at[BODY_MOTIONS * i + j] * motions->at[j];
  }
}

// Adds -S(v), the matrix of u -> u x v, in rows and columns from these on.
static void add_cross(float3 v, float scale, int row, int column, Matrix* matrix) {
  __private float* at = matrix->at + BODY_MOTIONS * row + column;
  at[1] += scale * v.z;
  at[2] -= scale * v.y;
  at[BODY_MOTIONS] -= scale * v.z;
  at[BODY_MOTIONS + 2] += scale * v.x;
  at[2 * BODY_MOTIONS] += scale * v.y;
  at[2 * BODY_MOTIONS + 1] -= scale * v.x;
}

// Adds C, times a scale, of a body with these momenta along and about its axes, and of the water that it moves.
static void add_coriolis(float3 own, float3 own_spin, float3 added, float scale, Matrix* matrix) {
  add_cross(own, scale, 0, 3, matrix);
  add_cross(own, scale, 3, 0, matrix);
  add_cross(own_spin, scale, 3, 3, matrix);
  matrix->at[4] += scale * added.z;
  matrix->at[2 * BODY_MOTIONS + 4] -= scale * added.x;
  matrix->at[4 * BODY_MOTIONS] -= scale * added.z;
  matrix->at[4 * BODY_MOTIONS + 2] += scale * added.x;
}

// Elimination without exchange: the symmetric part is positive definite.
static void solve(Matrix* matrix, Motions* right) {
  for (int pivot = 0; pivot < BODY_MOTIONS; ++pivot) {
    for (int row = pivot + 1; row < BODY_MOTIONS; ++row) {
      const float times = matrix->at[BODY_MOTIONS * row + pivot] / matrix->at[(BODY_MOTIONS + 1) * pivot];
      for (int column = pivot; column < BODY_MOTIONS; ++column) {
        matrix->at[BODY_MOTIONS * row + column] -= times * matrix->at[BODY_MOTIONS * pivot + column];
      }
      right->at[row] -= times * right->at[pivot];
    }
  }
  for (int row = BODY_MOTIONS - 1; row >= 0; --row) {
    for (int column = row + 1; column < BODY_MOTIONS; ++column) {
      right->at[row] -= matrix->at[BODY_MOTIONS * row + column] * right->at[column];
    }
    right->at[row] /= matrix->at[(BODY_MOTIONS + 1) * row];
  }
}

// New velocities by Cummins' equation; `force` and `moment` in world axes, `past` what earlier velocities do. Sets
// `radiation`, what radiation does.
static void move_by_memory(const BodyShape* shape, const BodyWater* water, __global const float* memory,
                           const Motions* past, float share, float3 force, float3 moment, Motion* motion,
                           Motions* next, Motions* radiation) {
  const float step = water->step_s;
  Motions before, momentum, push;
  set_motions(turned_back(motion->turn, motion->velocity), motion->spin, &before);
  Matrix mass;
  for (int i = 0; i < BODY_MATRIX; ++i) mass.at[i] = share * memory[i];
  set_product(&mass, &before, &momentum);
  const float3 added_momentum = along_of(&momentum);
  const float3 own_momentum = shape->mass_kg * along_of(&before);
  const float3 own_spin_momentum =
      symmetric_product(shape->inertia_xx, shape->inertia_yy, shape->inertia_zz, shape->inertia_xy,
                        shape->inertia_xz, shape->inertia_yz, about_of(&before));
  mass.at[0] += shape->mass_kg;
  mass.at[7] += shape->mass_kg;
  mass.at[14] += shape->mass_kg;
  mass.at[21] += shape->inertia_xx;
  mass.at[28] += shape->inertia_yy;
  mass.at[35] += shape->inertia_zz;
  mass.at[22] += shape->inertia_xy;
  mass.at[27] += shape->inertia_xy;
  mass.at[23] += shape->inertia_xz;
  mass.at[33] += shape->inertia_xz;
  mass.at[29] += shape->inertia_yz;
  mass.at[34] += shape->inertia_yz;
  // C v = (spin x p, v x p + spin x q): skew, so that C does no work.
  Matrix left = mass;
  Matrix right = mass;
  const float half_step = 0.5f * step;
  add_coriolis(own_momentum, own_spin_momentum, added_momentum, half_step, &left);
  add_coriolis(own_momentum, own_spin_momentum, added_momentum, -half_step, &right);
  for (int i = 0; i < BODY_MATRIX; ++i) left.at[i] += share * step * memory[BODY_MATRIX + i];
  set_motions(turned_back(motion->turn, force), turned_back(motion->turn, moment), &push);
  set_product(&right, &before, next);
  for (int i = 0; i < BODY_MOTIONS; ++i) next->at[i] += step * (push.at[i] + share * past->at[i]);
  solve(&left, next);
  for (int i = 0; i < BODY_MOTIONS; ++i) {
    radiation->at[i] = past->at[i];
    for (int j = 0; j < BODY_MOTIONS; ++j) {
      radiation->at[i] -= memory[BODY_MATRIX + BODY_MOTIONS * i + j] * next->at[j];
    }
    radiation->at[i] *= share;
  }
}

// What velocities before this sub-step do, by samples lane, lane + GROUP, ...: between the sample `now` and the next
// one, which needs no velocity that is still to come, in proportion.
static void set_part_of_past(const BodyShape* shape, __global const float* memory, __global const float* velocities,
                            int sample, float share, int lane,
                             Motions* sum) {
  for (int n = lane + 1; n < shape->memory_samples; n += GROUP) {
    const int later = (sample + 1 - n + shape->memory_samples) % shape->memory_samples;
    const int earlier = (sample - n + shape->memory_samples) % shape->memory_samples;
    float velocity[BODY_MOTIONS];
    for (int j = 0; j < BODY_MOTIONS; ++j) {
      velocity[j] = mix(velocities[BODY_MOTIONS * earlier + j], velocities[BODY_MOTIONS * later + j], share);
    }
    __global const float* kept = memory + BODY_MATRIX * (n + 1);
    for (int i = 0; i < BODY_MOTIONS; ++i) {
      for (int j = 0; j < BODY_MOTIONS; ++j) sum->at[i] -= kept[BODY_MOTIONS * i + j] * velocity[j];
    }
  }
}

// Moves the body, and sets what moved it.
static void advance(const BodyShape* shape, const BodyWater* water, const BodyDrive* drive, const BodyState* origin,
                    const Wrench* wrench, float3 propeller, float propeller_depth,
                    __global const BodyMooring* moorings, __global const float* memory, const Motions* past,
                    const Motions* excitation, Motion* motion, Push* pushes) {
  const float moved = water->density_kgpm3 * displaced_by(water, wrench);
  const float mass_along = shape->mass_kg + shape->added_along * moved, mass_up = shape->mass_kg + shape->added_up * moved;
  const float3 flow = mean_flow(wrench);
  pushes[BODY_PRESSURE].force = wrench->pressure;
  pushes[BODY_PRESSURE].moment = wrench->pressure_moment;
  set_weakened(shape, water, motion, flow, wrench->drag, wrench->drag_moment, &pushes[BODY_DRAG]);
  const float3 wind = (float3)(water->wind_x_mps, 0.0f, water->wind_z_mps);
  set_weakened(shape, water, motion, wind, wrench->wind, wrench->wind_moment, &pushes[BODY_WIND]);
  set_drive(shape, water, drive, motion, flow, propeller, propeller_depth, pushes);
  set_mooring(shape, water, moorings, origin, motion, &pushes[BODY_MOORING]);
  set_push((float3)(0.0f, -shape->mass_kg * water->gravity_mps2, 0.0f), (float3)(0.0f), &pushes[BODY_GRAVITY]);
  const bool has_memory = shape->memory_samples > 0;
  pushes[BODY_EXCITATION].force = has_memory ? along_of(excitation) : (float3)(0.0f);
  pushes[BODY_EXCITATION].moment = has_memory ? about_of(excitation) : (float3)(0.0f);
  pushes[BODY_RADIATION].force = pushes[BODY_RADIATION].moment = (float3)(0.0f);
  float3 force = (float3)(0.0f), moment = (float3)(0.0f);
  for (int kind = 0; kind < BODY_FORCE_KINDS; ++kind) {
    force += pushes[kind].force;
    moment += pushes[kind].moment;
  }

  if (has_memory) {
    Motions next, radiation;
    move_by_memory(shape, water, memory, past, wetted_share(shape, water, wrench), force, moment, motion, &next,
                   &radiation);
    pushes[BODY_RADIATION].force = turned(motion->turn, along_of(&radiation));
    pushes[BODY_RADIATION].moment = turned(motion->turn, about_of(&radiation));
    motion->spin = no_longer_than(BODY_LARGEST_SPIN_RADPS, about_of(&next));
    const float4 turn = normalize(turn_product(motion->turn, turn_by(water->step_s * motion->spin)));
    motion->velocity = turned(turn, along_of(&next));
  } else {
    motion->velocity += water->step_s * force / (float3)(mass_along, mass_up, mass_along);
    const float3 spin = motion->spin;
    const float3 momentum = symmetric_product(shape->inertia_xx, shape->inertia_yy, shape->inertia_zz,
                                              shape->inertia_xy, shape->inertia_xz, shape->inertia_yz, spin);
    const float3 rest = turned_back(motion->turn, moment) - cross(spin, momentum);
    motion->spin += water->step_s * inverse_inertia_times(shape, rest);
  }
  motion->velocity = no_longer_than(BODY_LARGEST_SPEED_MPS, motion->velocity);
  motion->spin = no_longer_than(BODY_LARGEST_SPIN_RADPS, motion->spin);
  motion->place += water->step_s * motion->velocity;
  motion->turn = normalize(turn_product(motion->turn, turn_by(water->step_s * motion->spin)));
  if (drive->follows_path) follow_path(drive, origin, motion);
}

// The place in the tile that it is in.
static void write_state(const BodyWater* water, const BodyState* origin, const Motion* motion, const Wrench* sum,
                        __global BodyState* written) {
  const float east = rint(motion->place.x / SURFACE_QUERY_TILE_M), south = rint(motion->place.z / SURFACE_QUERY_TILE_M);
  const float3 flow = mean_flow(sum);
  const float2 shift = sum->wetted > 0.0f ? sum->shift / sum->wetted : (float2)(0.0f);
  const BodyState state = {origin->tile_x + (int)east,
                           origin->tile_z + (int)south,
                           motion->place.x - SURFACE_QUERY_TILE_M * east,
                           motion->place.y,
                           motion->place.z - SURFACE_QUERY_TILE_M * south,
                           motion->turn.x,
                           motion->turn.y,
                           motion->turn.z,
                           motion->turn.w,
                           motion->velocity.x,
                           motion->velocity.y,
                           motion->velocity.z,
                           motion->spin.x,
                           motion->spin.y,
                           motion->spin.z,
                           displaced_by(water, sum),
                           flow.x,
                           flow.z,
                           shift.x,
                           shift.y};
  *written = state;
}

static void write_report(const BodyWater* water, const Wrench* sum, const Push* pushes, __global BodyReport* written) {
  written->displaced_m3 = displaced_by(water, sum);
  written->wetted_m2 = sum->wetted;
  for (int kind = 0; kind < BODY_FORCE_KINDS; ++kind) {
    vstore3(pushes[kind].force, 2 * kind, written->forces);
    vstore3(pushes[kind].moment, 2 * kind + 1, written->forces);
  }
}

__kernel __attribute__((reqd_work_group_size(GROUP, 1, 1))) void body_advance(
    __global const BodyShape* restrict shapes, __global const BodyDrive* restrict drives,
    __global const BodyState* restrict states, __global const float* restrict vertices,
    __global const uint* restrict faces, __global const SurfaceQueryPoint* restrict points,
    __global const SurfaceQueryShifted* restrict samples, __global const BodyMooring* restrict moorings,
    __global const float* restrict memory, __global const float* restrict excitation, const BodyWater water,
    __global float* restrict velocities, __global BodyState* restrict path,
    __global BodyState* restrict ends, __global BodyReport* restrict reports) {
  __local Wrench sums[GROUP];
  __local Motions pasts[GROUP];
  __local Motion now;
  const int lane = get_local_id(0);
  const size_t body = get_group_id(0), bodies = get_num_groups(0);
  const BodyShape shape = shapes[body];
  const BodyState origin = states[body];
  if (lane == 0) {
    now.place = (float3)(origin.x_m, origin.y_m, origin.z_m);
    now.velocity = (float3)(origin.velocity_x_mps, origin.velocity_y_mps, origin.velocity_z_mps);
    now.spin = (float3)(origin.spin_x_radps, origin.spin_y_radps, origin.spin_z_radps);
    now.turn = (float4)(origin.turn_x, origin.turn_y, origin.turn_z, origin.turn_w);
  }
  for (int step = 0; step < water.steps; ++step) {
    barrier(CLK_LOCAL_MEM_FENCE);
    Motion motion = now;
    Motions past_part;
    set_motions((float3)(0.0f), (float3)(0.0f), &past_part);
    if (shape.memory_samples > 0) {
      const int all_steps = water.first_step + step, sample = all_steps / shape.steps_a_sample % shape.memory_samples;
      const int steps_since = all_steps % shape.steps_a_sample;
      if (lane == 0 && steps_since == 0) {
        vstore3(turned_back(motion.turn, motion.velocity), 2 * (size_t)sample, velocities + shape.first_velocity_float);
        vstore3(motion.spin, 2 * (size_t)sample + 1, velocities + shape.first_velocity_float);
      }
      barrier(CLK_GLOBAL_MEM_FENCE);
      set_part_of_past(&shape, memory + shape.first_memory_float, velocities + shape.first_velocity_float,
                                 sample, (float)(steps_since + 1) / (float)shape.steps_a_sample, lane, &past_part);
    }
    pasts[lane] = past_part;
    const float time_s = (float)step * water.step_s;
    const float3 spin = turned(motion.turn, motion.spin), forward = turned(motion.turn, (float3)(1.0f, 0.0f, 0.0f));
    const float friction = friction_coefficient(length(motion.velocity) * shape.length_m / water.viscosity_m2ps);
    Wrench sum;
    clear(&sum);
    for (int face = lane; face < shape.face_count; face += GROUP) {
      float3 arm[3], flow = (float3)(0.0f);
      float2 shift = (float2)(0.0f);
      float depth[3];
      for (int corner = 0; corner < 3; ++corner) {
        const uint vertex = faces[3 * (shape.first_face + face) + corner];
        const SurfaceQuerySample sample = samples[vertex].water;
        arm[corner] = turned(motion.turn, vload3(vertex, vertices));
        depth[corner] = depth_of(&origin, motion.place, arm[corner], points[vertex], &sample, time_s);
        flow += surface_velocity(&sample) / 3.0f;
        shift += (float2)(samples[vertex].shift_x_m, samples[vertex].shift_z_m) / 3.0f;
      }
      add_face(&shape, &water, motion.velocity, spin, forward, friction, arm, depth, flow, shift, &sum);
    }
    sums[lane] = sum;
    for (int kept = GROUP / 2; kept > 0; kept /= 2) {
      barrier(CLK_LOCAL_MEM_FENCE);
      if (lane < kept) {
        sums[lane].pressure += sums[lane + kept].pressure;
        sums[lane].pressure_moment += sums[lane + kept].pressure_moment;
        sums[lane].drag += sums[lane + kept].drag;
        sums[lane].drag_moment += sums[lane + kept].drag_moment;
        sums[lane].wetted += sums[lane + kept].wetted;
        sums[lane].flow += sums[lane + kept].flow;
        sums[lane].shift += sums[lane + kept].shift;
        sums[lane].wind += sums[lane + kept].wind;
        sums[lane].wind_moment += sums[lane + kept].wind_moment;
        for (int i = 0; i < BODY_MOTIONS; ++i) pasts[lane].at[i] += pasts[lane + kept].at[i];
      }
    }
    if (lane == 0) {
      Wrench total = sums[0];
      add_lift(&shape, &water, &motion, &total);
      const Motions past = pasts[0];
      const BodyDrive drive = drives[body * water.steps + step];
      const float share = wetted_share(&shape, &water, &total) * (1.0f - drive.lost_wave_share);
      Motions waves;
      for (int i = 0; i < BODY_MOTIONS; ++i) waves.at[i] = share * excitation[BODY_MOTIONS * body + i];
      const SurfaceQuerySample sample = samples[shape.propeller_vertex].water;
      const float3 propeller = turned(motion.turn, vload3((size_t)shape.propeller_vertex, vertices));
      const float depth =
          depth_of(&origin, motion.place, propeller, points[shape.propeller_vertex], &sample, time_s);
      Push pushes[BODY_FORCE_KINDS];
      advance(&shape, &water, &drive, &origin, &total, propeller, depth, moorings, memory + shape.first_memory_float,
              &past, &waves, &motion, pushes);
      now = motion;
      write_state(&water, &origin, &motion, &total, &path[step * bodies + body]);
      if (step == water.steps - 1) {
        write_state(&water, &origin, &motion, &total, &ends[body]);
        write_report(&water, &total, pushes, &reports[body]);
      }
    }
  }
}
