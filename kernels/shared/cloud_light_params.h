// What the kernels of cloud light read, one layout for host and device: 4-byte scalars only.
#ifndef OFFING_KERNELS_SHARED_CLOUD_LIGHT_H
#define OFFING_KERNELS_SHARED_CLOUD_LIGHT_H

// Most suns at a time.
#define CLOUD_SUNS 4

// Fewest cells along each axis of a cloud's grid, so that a row is as long as the widest vector. Light
// changes most across the thinnest side: with 8 cells from top to bottom, a layer of depth 32 lets a quarter
// too much through, and shapes 8 cells thick are up to 18 % too bright.
#define CLOUD_LEAST_CELLS 16
// Room for the cells of a cloud at most.
#define CLOUD_MOST_CELLS 32768

// Arrays of clouds with room for so many cells each (kernels/clouds/light_grid.clh): a plane of cells at most
// before the first; with a plane more behind; with levels, each a quarter of the one before but for short
// rows, and what is read beyond; a plane with a rim around it.
#define CLOUD_PLANE_CELLS(room) ((room) / CLOUD_LEAST_CELLS)
#define CLOUD_MEDIUM_CELLS(room) ((room) + 2 * CLOUD_PLANE_CELLS(room))
#define CLOUD_LEVEL_CELLS(room) (CLOUD_PLANE_CELLS(room) + (room) / 3 * 4 + 1024)
#define CLOUD_RIMMED_CELLS(room) (CLOUD_PLANE_CELLS(room) / 4 * 5)

// Floats before the first beam and after the last, so that whole vectors may be read around each cell.
#define CLOUD_BEAM_MARGIN 16

// Texels a side of the map of clouds/light_recurrence.cl.
#define CLOUD_HARRIS_SIZE 128

// Texels a side of what is known of the light that reaches a cloud past others.
#define CLOUD_ENTRY_SIZE 16

// Tables of phases: [look][CLOUD_PHASE_DEPTHS][CLOUD_PHASE_ANGLES], 1/sr. Angles go with the square of their
// place, so that the forward peak is fine: angle = pi (i / (CLOUD_PHASE_ANGLES - 1))^2. Depths: depth =
// CLOUD_PHASE_DEPTH_SCALE * u / (1 - u), u = i / CLOUD_PHASE_DEPTHS.
#define CLOUD_PHASE_ANGLES 128
#define CLOUD_PHASE_DEPTHS 24
#define CLOUD_PHASE_DEPTH_SCALE 4.0f

// The grid of a cloud, made on the device: cells are boxes.
typedef struct {
  float low_x, low_y, low_z;     // m, its least corner
  float cell_x, cell_y, cell_z;  // m
  int first, end;                // particles of the cloud
  int size_x, size_y, size_z;    // cells along each axis, powers of two; 16 at least
  int room;                      // for cells in arrays of all clouds, CLOUD_MOST_CELLS at most
} CloudGrid;

// What a cloud scatters with.
typedef struct {
  float absorbed_share;      // 1 - albedo, of clouds that are all of one grey
  float forward_share;       // f: of scattered light that counts as going on unscattered
  float scaled_mean_cosine;  // g' of the rest
  unsigned int phase_table;  // which of the tables
} CloudScattering;

// A distant light.
typedef struct {
  float x, y, z;           // unit, toward the sun
  float red, green, blue;  // klx
} CloudLightSource;

// What falls on a cloud. All clouds have as many suns.
typedef struct {
  CloudLightSource suns[CLOUD_SUNS];
  int sun_count;
  float sky_red, sky_green, sky_blue;           // kcd/m^2
  float ground_red, ground_green, ground_blue;  // kcd/m^2
  float above_red, above_green, above_blue;     // kcd/m^2: the sky with other clouds before it
  float below_red, below_green, below_blue;     // kcd/m^2: the ground with these
} CloudLightParams;

#ifndef __OPENCL_VERSION__
static_assert(sizeof(CloudGrid) == 48, "no padding");
static_assert(sizeof(CloudScattering) == 16, "no padding");
static_assert(sizeof(CloudLightSource) == 24, "no padding");
static_assert(sizeof(CloudLightParams) == 4 * 24 + 52, "no padding");
#endif

#endif
