// Arrays of floating bodies, one layout for host and device: 4-byte scalars only. Body axes: x forward, y up,
// z to starboard, their origin in the mass centre; world axes: y up from the water plane.
#ifndef OFFING_KERNELS_SHARED_BODIES_H
#define OFFING_KERNELS_SHARED_BODIES_H

// Places are whole tiles of SURFACE_QUERY_TILE_M (shared/query_params.h) along x and z and a rest, as those
// of queries.

// Bounds of what forces make of a body's motion: ten times the fastest hulls, and half a radian a sub-step of
// 1/120 s.
#define BODY_LARGEST_SPEED_MPS 1500.0f
#define BODY_LARGEST_SPIN_RADPS 60.0f

// Kinds of forces on a body.
typedef enum {
  BODY_PRESSURE,    // of still water below the surface of the moment
  BODY_DRAG,        // of the water: friction, drag across faces, lift of a hull that runs ahead
  BODY_RADIATION,   // of the waves that it has made; without the water that it accelerates
  BODY_EXCITATION,  // of waves, besides BODY_PRESSURE: what pressures lose with depth, and what it scatters
  BODY_PROPELLER,
  BODY_RUDDER,
  BODY_GRAVITY,
  BODY_WIND,     // on what is dry
  BODY_MOORING,  // of its lines
  BODY_FORCE_KINDS
} BodyForce;

#define BODY_MOTIONS 6  // along x, y, z, then about x, y, z, in body axes
#define BODY_MATRIX 36

// Tables of what waves do to a hull, [directions][frequencies][floats]: real parts of each motion's, then
// imaginary ones.
#define BODY_WAVE_DIRECTIONS 48
#define BODY_WAVE_FREQUENCIES 64
#define BODY_WAVE_FLOATS 12

// A body at one time.
typedef struct {
  int tile_x, tile_z;
  float x_m, y_m, z_m;                                   // mass centre
  float turn_x, turn_y, turn_z, turn_w;                  // unit quaternion from body axes to the world's
  float velocity_x_mps, velocity_y_mps, velocity_z_mps;  // of the mass centre, in world axes
  float spin_x_radps, spin_y_radps, spin_z_radps;        // in body axes
  // In the sub-step that led here: the volume of water, the mean velocity of the water around the hull, and
  // how far that water is from its place at rest.
  float displaced_m3, flow_x_mps, flow_z_mps, shift_x_m, shift_z_m;
} BodyState;

// What a body is.
typedef struct {
  int propeller_vertex;        // which of the vertices of all bodies stands for its propeller
  int first_face, face_count;  // of its hull, among those of all bodies
  float mass_kg;
  float inertia_xx, inertia_yy, inertia_zz, inertia_xy, inertia_xz,
      inertia_yz;  // kg m^2, about the mass centre
  // 1 / (kg m^2), of the inertia with that of the water that turns with the body.
  float inverse_xx, inverse_yy, inverse_zz, inverse_xy, inverse_xz, inverse_yz;
  // Water that is moved with the body: shares of what it displaces at the moment.
  float added_along, added_up;
  float length_m;      // along x: Reynolds' number and waves are of this length
  float face_drag;     // of half density speed^2 area, where a face moves against the water
  float wake_drag;     // and where it moves away from it
  float wave_damping;  // of density area sqrt(gravity length) speed, on what faces downward
  float propeller_diameter_m;
  float rudder_x_m, rudder_y_m, rudder_z_m, rudder_area_m2;
  float rudder_lift;  // lift coefficient's rise with the angle, 1/rad
  // Sway force and yaw moment of a hull that runs ahead (host/bodies/hull_lift.h), at a place from the mass
  // centre. Faces drag by their speed across with and without that ahead: this share of it apart.
  float lift_share, lift_x_m, lift_y_m, lift_force_by_sway, lift_force_by_yaw, lift_moment_by_sway,
      lift_moment_by_yaw;
  // What the waves that it has made do to it: BODY_MATRIX floats of added mass, then as many for each of
  // memory_samples samples of its velocity, steps_a_sample sub-steps apart, the first one now. No samples:
  // none.
  int first_memory_float, memory_samples, steps_a_sample;
  int first_velocity_float;  // of the velocities that it has had
  // What waves do to it besides the pressure below their surface (host/bodies/excitation.h): its table, and
  // the step from one of its frequencies to the next, the first one being this.
  int first_wave_float;
  float wave_step_radps;
  float windage;  // share of the force of wind on dry faces
  int first_mooring, moorings;
} BodyShape;

// A line from a place on a hull to an anchor: a spring where it is longer than at rest, else slack.
typedef struct {
  float x_m, y_m, z_m;  // from the mass centre, in body axes
  int anchor_tile_x, anchor_tile_z;
  float anchor_x_m, anchor_y_m, anchor_z_m;
  float length_m, stiffness_npm;
} BodyMooring;

// What drives a body in one sub-step.
typedef struct {
  float thrust_n;
  float rudder_rad;  // above 0: the heading grows
  // 1: the place along x and z and the heading are those of a path, whatever forces are.
  int follows_path;
  int tile_x, tile_z;
  float x_m, z_m;
  float heading_rad;  // of body x in the world, from +x toward +z
  float velocity_x_mps, velocity_z_mps, heading_rate_radps;
  float lost_wave_share;  // of what waves do besides the pressure below their surface: 0 in the open sea
} BodyDrive;

// What acted on a body in its last sub-step.
typedef struct {
  float displaced_m3;
  float wetted_m2;
  // [BODY_FORCE_KINDS][BODY_MOTIONS]: force N and moment N m about the mass centre, in world axes.
  float forces[BODY_FORCE_KINDS * BODY_MOTIONS];
} BodyReport;

// A wave of the sea, A cos p: phases at label (0, 0) of tile (0, 0) and question 0, in 2^-32 turns.
typedef struct {
  unsigned int phase, phase_by_question, phase_by_tile_x, phase_by_tile_z;
  float amplitude_m;
  float kx_radpm, kz_radpm;
  float frequency_radps;  // of a wave of this length on deep water
  float direction_rad;    // of travel, from +x toward +z
} BodyWave;

// Those waves, for bodies/body_waves.cl.
typedef struct {
  int waves;
  int question;    // since the start
  float middle_s;  // of the sub-steps of a question
} BodySea;

// The water, the air and the steps.
typedef struct {
  float density_kgpm3;
  float gravity_mps2;
  float viscosity_m2ps;  // kinematic
  float air_density_kgpm3;
  float wind_x_mps, wind_z_mps;  // 10 m above it
  float step_s;
  int steps;       // between two questions about the water
  int first_step;  // of these, since the start
} BodyWater;

// A hull on a wake window (shared/wake.h), for bodies/hull_press.cl. Places in the hull's map are counted in
// its columns and rows.
typedef struct {
  int first_column, first_row;          // of the world, of the first cell that is looked at
  int columns, rows;                    // of such cells
  int size;                             // n of the window
  float along, across;                  // place in the map of that cell's middle
  float along_by_column, along_by_row;  // and how it changes from cell to cell
  float across_by_column, across_by_row;
  int map_columns, map_rows;
  float level_m;  // of the water, in the map's axes
  float factor;   // of its depth
} HullPress;

#ifndef __OPENCL_VERSION__
static_assert(sizeof(HullPress) == 60, "no padding");
static_assert(sizeof(BodyState) == 80, "no padding");
static_assert(sizeof(BodyShape) == 176, "no padding");
static_assert(sizeof(BodyDrive) == 48, "no padding");
static_assert(sizeof(BodyMooring) == 40, "no padding");
static_assert(sizeof(BodyReport) == 224, "no padding");
static_assert(sizeof(BodyWave) == 36, "no padding");
static_assert(sizeof(BodySea) == 12, "no padding");
static_assert(sizeof(BodyWater) == 36, "no padding");
#endif

#endif
