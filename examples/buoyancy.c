/* Shows the C interface in a loop with fixed steps: a box hull floats in a sea at 100 Hz, and each step is
 * timed.
 *
 * Build: see README.md beside this file. Use: buoyancy [SCENE.toml] [SECONDS]
 *
 * The hull heaves, pitches and rolls; surge, sway and yaw are held. Columns of it are pushed up by the weight
 * of the water that they displace, and resisted in proportion to their vertical speed through the water.
 * Added mass and the waves that the hull itself makes are left out.
 *
 * Axes: x forward, y up, z to starboard. Pitch is positive bow up, roll is positive starboard down. */
#define _POSIX_C_SOURCE 199309L /* clock_gettime */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include <offing.h>

#define COLUMNS_X 6
#define COLUMNS_Z 3
#define COLUMNS (COLUMNS_X * COLUMNS_Z)

static const double pi = 3.14159265358979323846;
static const double length_m = 12.0, beam_m = 4.0, depth_m = 2.5; /* of the box */
static const double mass_kg = 49200.0, keel_to_centre_m = 1.0;    /* keel to centre of mass */
static const double density_kgpm3 = 1025.0, gravity_mps2 = 9.81;  /* as in Offing's pressures */
static const double damping_ratio = 0.2;                          /* of heave; 1 would be critical */
static const double step_s = 0.01;
static const double settle_s = 30.0; /* damps the first motion to exp(-0.2 * 3.13 * 30) = 7e-9 */

typedef struct Hull {
  double height_m, pitch_rad, roll_rad; /* height of the centre of mass above sea level */
  double height_mps, pitch_radps, roll_radps;
} Hull;

typedef struct Range {
  double lowest, highest, sum, sum_of_squares;
} Range;

static const Range no_values = {DBL_MAX, -DBL_MAX, 0.0, 0.0};

static void include(Range* range, double value) {
  range->lowest = fmin(range->lowest, value);
  range->highest = fmax(range->highest, value);
  range->sum += value;
  range->sum_of_squares += value * value;
}

static double deviation(const Range* range, int count) {
  const double mean = range->sum / count;
  return sqrt(fmax(range->sum_of_squares / count - mean * mean, 0.0));
}

static double expected_draught_m(void) {
  return mass_kg / (density_kgpm3 * length_m * beam_m);
}

static double column_x_m(int column) {
  return ((column % COLUMNS_X + 0.5) / COLUMNS_X - 0.5) * length_m;
}

static double column_z_m(int column) {
  return ((column / COLUMNS_X + 0.5) / COLUMNS_Z - 0.5) * beam_m;
}

/* One step by the semi-implicit Euler method: speeds first, then places by the new speeds. */
static void advance(Hull* hull, const OffingSample* water) {
  const double area_m2 = length_m * beam_m / COLUMNS;
  /* N s/m a column: together damping_ratio of twice the root of mass times stiffness. */
  const double drag =
      2.0 * damping_ratio * sqrt(mass_kg * density_kgpm3 * gravity_mps2 * length_m * beam_m) / COLUMNS;
  const double pitch_inertia_kgm2 = mass_kg * (length_m * length_m + depth_m * depth_m) / 12.0;
  const double roll_inertia_kgm2 = mass_kg * (beam_m * beam_m + depth_m * depth_m) / 12.0;
  double force_n = -mass_kg * gravity_mps2, pitch_nm = 0.0, roll_nm = 0.0;
  int i;
  for (i = 0; i < COLUMNS; ++i) {
    const double x_m = column_x_m(i), z_m = column_z_m(i);
    const double keel_m = hull->height_m + x_m * sin(hull->pitch_rad) - z_m * sin(hull->roll_rad) -
                          keel_to_centre_m * cos(hull->pitch_rad) * cos(hull->roll_rad);
    const double wet_m = fmin(fmax(water[i].height_m - keel_m, 0.0), depth_m);
    if (wet_m > 0.0) {
      const double speed_mps = hull->height_mps + x_m * hull->pitch_radps - z_m * hull->roll_radps;
      const double lift_n =
          density_kgpm3 * gravity_mps2 * area_m2 * wet_m - drag * (speed_mps - water[i].velocity_mps[1]);
      /* It acts at the middle of the wet part, which lies this far above the centre of mass. */
      const double above_m = 0.5 * wet_m - keel_to_centre_m;
      force_n += lift_n;
      pitch_nm += lift_n * (x_m * cos(hull->pitch_rad) - above_m * sin(hull->pitch_rad));
      roll_nm -= lift_n * (z_m * cos(hull->roll_rad) + above_m * sin(hull->roll_rad));
    }
  }
  hull->height_mps += step_s * force_n / mass_kg;
  hull->pitch_radps += step_s * pitch_nm / pitch_inertia_kgm2;
  hull->roll_radps += step_s * roll_nm / roll_inertia_kgm2;
  hull->height_m += step_s * hull->height_mps;
  hull->pitch_rad += step_s * hull->pitch_radps;
  hull->roll_rad += step_s * hull->roll_radps;
}

static double now_ms(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return 1e3 * (double)now.tv_sec + 1e-6 * (double)now.tv_nsec;
}

static int ascending(const void* left, const void* right) {
  const double a = *(const double*)left, b = *(const double*)right;
  return (a > b) - (a < b);
}

/* Prints what failed and how to fix it; the status is the program's exit code. */
static int report(OffingStatus status) {
  fprintf(stderr, "error: %s\nhint: %s\n", offing_last_error(), offing_last_hint());
  return (int)status;
}

/* Water under all columns. Waves shorter than `min_wavelength_m` do not count. */
static OffingStatus sample_columns(OffingWorld* world, double min_wavelength_m, OffingSample* water) {
  const OffingQuery query = {0.0, min_wavelength_m};
  OffingPoint points[COLUMNS];
  int i;
  for (i = 0; i < COLUMNS; ++i) {
    points[i].x_m = column_x_m(i);
    points[i].z_m = column_z_m(i);
  }
  return offing_sample(world, &query, points, COLUMNS, water);
}

/* Drops the hull from 0.3 m above its equilibrium, heeled, on water without waves; it must come to rest at
 * the draught by which it displaces its own weight, upright. */
static int float_at_rest(OffingWorld* world, Hull* hull) {
  const double no_waves_m = 1e6; /* all waves are shorter */
  OffingSample water[COLUMNS];
  double draught_m;
  int step;
  const OffingStatus status = sample_columns(world, no_waves_m, water);
  if (status != OFFING_OK) return report(status);
  hull->height_m = keel_to_centre_m - expected_draught_m() + 0.3;
  hull->pitch_rad = 0.02;
  hull->roll_rad = 0.1;
  for (step = 0; step < (int)(settle_s / step_s); ++step) advance(hull, water);
  draught_m = keel_to_centre_m - hull->height_m;
  printf("at rest: draught %.4f m, mass / (density * area) %.4f m; pitch %.3f deg, roll %.3f deg\n",
         draught_m, expected_draught_m(), hull->pitch_rad * 180.0 / pi, hull->roll_rad * 180.0 / pi);
  return fabs(draught_m - expected_draught_m()) < 1e-4 ? 0 : 1;
}

/* Steps the sea and the hull, and prints the motions and the time that the steps took. */
static int float_in_waves(OffingWorld* world, Hull* hull, int steps, double* latency_ms) {
  const double spacing_m = fmax(length_m / COLUMNS_X, beam_m / COLUMNS_Z);
  const double rest_m = hull->height_m;
  Range sea_m = no_values, heave_m = no_values, pitch_deg = no_values, roll_deg = no_values;
  OffingSample water[COLUMNS];
  int step;
  for (step = 0; step < steps; ++step) {
    const double start_ms = now_ms();
    OffingStatus status = offing_frame(world, step_s * step);
    /* Columns cannot tell waves shorter than two spacings from longer ones. */
    if (status == OFFING_OK) status = sample_columns(world, 2.0 * spacing_m, water);
    if (status != OFFING_OK) return report(status);
    advance(hull, water);
    latency_ms[step] = now_ms() - start_ms;
    include(&sea_m, water[COLUMNS / 2].height_m);
    include(&heave_m, hull->height_m - rest_m);
    include(&pitch_deg, hull->pitch_rad * 180.0 / pi);
    include(&roll_deg, hull->roll_rad * 180.0 / pi);
  }
  qsort(latency_ms, (size_t)steps, sizeof *latency_ms, ascending);
  printf("in waves: %d steps of %.0f ms, significant wave height at the hull %.2f m\n", steps, 1e3 * step_s,
         4.0 * deviation(&sea_m, steps));
  printf("heave: %.2f m to %.2f m\n", heave_m.lowest, heave_m.highest);
  printf("pitch: %.1f deg to %.1f deg\n", pitch_deg.lowest, pitch_deg.highest);
  printf("roll: %.1f deg to %.1f deg\n", roll_deg.lowest, roll_deg.highest);
  printf("latency: median %.2f ms, 99th percentile %.2f ms, worst %.2f ms\n", latency_ms[steps / 2],
         latency_ms[(int)(0.99 * (steps - 1))], latency_ms[steps - 1]);
  return 0;
}

static int float_hull(OffingWorld* world, int steps) {
  Hull hull = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  double* latency_ms = malloc((size_t)steps * sizeof *latency_ms);
  int result;
  if (latency_ms == NULL) {
    fprintf(stderr, "error: no memory for the times of %d steps\nhint: ask for fewer seconds\n", steps);
    return 1;
  }
  result = float_at_rest(world, &hull);
  if (result == 0) result = float_in_waves(world, &hull, steps, latency_ms);
  free(latency_ms);
  return result;
}

int main(int argc, char** argv) {
  /* Gerstner waves carry the long waves, so that the maps can be small. */
  const char* wind_sea =
      "version = 1\n[wind]\nspeed_mps = 9\ndirection_deg = 30\n[ocean]\nsize = 128\ngerstner.count = 32\n";
  const double seconds = argc > 2 ? strtod(argv[2], NULL) : 60.0;
  OffingDevice* device = NULL;
  OffingScene* scene = NULL;
  OffingWorld* world = NULL;
  OffingStatus status;
  int result;
  if (argc > 3 || !(seconds >= step_s && seconds <= 86400.0)) {
    fprintf(stderr, "usage: buoyancy [SCENE.toml] [SECONDS, %.2f to 86400]\n", step_s);
    return 2;
  }
  if (offing_interface() != OFFING_INTERFACE) {
    fprintf(stderr, "error: compiled for interface %d of Offing, got %d\nhint: compile this program again\n",
            OFFING_INTERFACE, offing_interface());
    return 1;
  }
  status = offing_open_device(NULL, &device);
  if (status == OFFING_OK && argc > 1) status = offing_load_scene(argv[1], &scene);
  if (status == OFFING_OK && argc == 1) status = offing_parse_scene(wind_sea, NULL, &scene);
  if (status == OFFING_OK) status = offing_make_world(device, scene, &world);
  if (status == OFFING_OK) {
    printf("Offing %s on %s\n", offing_version(), offing_device_name(device));
    result = float_hull(world, (int)(seconds / step_s + 0.5));
  } else {
    result = report(status);
  }
  offing_free_world(world);
  offing_free_scene(scene);
  offing_close_device(device);
  return result;
}
