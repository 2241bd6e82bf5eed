/** @file
 * Offing for programs in C and whatever can call C: a device, a scene, the world that it describes at any
 * time, the water at points of it, and its maps.
 *
 * Axes: x east, y up, z south, right-handed; metres, seconds, radians.
 *
 * Every call that can fail returns an OffingStatus. When it is OFFING_BAD_INPUT, OFFING_BUSY or
 * OFFING_CANCELLED nothing was changed, and after any failure offing_last_error() says what was wrong and
 * offing_last_hint() how to fix it. No exception leaves a call. Settings of a scene that have no effect, or
 * less than asked, produce warnings in the log.
 *
 * Structs that programs fill or read begin with `size`: set it to sizeof the struct. Later versions add
 * members at the end; zero stands for what a struct of an older version lacks.
 *
 * Threads: devices, scenes, spectra and meshes may be used by several threads at once. A world or a terrain
 * may be used by any thread, but by one at a time: a call that finds another thread in a call with the same
 * handle returns OFFING_BUSY. Different worlds run on different threads at the same time, also on one device.
 * Do not free a handle while another thread uses it. */
#ifndef OFFING_H
#define OFFING_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Counted up when a call changes; what a program was compiled with. */
#define OFFING_INTERFACE 1

/** How a call ended. */
typedef enum OffingStatus {
  OFFING_OK = 0,        /**< done */
  OFFING_FAILED = 1,    /**< memory, a driver, a file that cannot be read */
  OFFING_BAD_INPUT = 2, /**< an argument, a scene, a value out of range */
  OFFING_NO_DEVICE = 3, /**< no OpenCL device of this name, or none at all */
  OFFING_CANCELLED = 4, /**< a callback of the program asked to stop */
  OFFING_BUSY = 5       /**< another thread is in a call with the same handle */
} OffingStatus;

/** An OpenCL device that is in use. */
typedef struct OffingDevice OffingDevice;
/** The settings of a scene file. */
typedef struct OffingScene OffingScene;
/** The world of a scene on a device, at one time. */
typedef struct OffingWorld OffingWorld;
/** A height map on a device: the surface of bilinear patches between its posts. */
typedef struct OffingTerrain OffingTerrain;
/** Triangles of a surface; it does not change. */
typedef struct OffingMesh OffingMesh;

/** The version of the library, as "1.2.3". */
const char* offing_version(void);
/** OFFING_INTERFACE of the library: a program checks that it is its own. */
int offing_interface(void);

/** What went wrong in the last call of this thread that failed: one line, valid until the next one fails; ""
 * if none has failed. */
const char* offing_last_error(void);
/** How to fix it: one line, valid as long as offing_last_error(). */
const char* offing_last_hint(void);

/** What a line of the log is. */
typedef enum OffingLogLevel {
  OFFING_LOG_ERROR = 0,
  OFFING_LOG_WARNING = 1,
  OFFING_LOG_INFO = 2,
  OFFING_LOG_DEBUG = 3
} OffingLogLevel;
/** Takes one line, without its end; valid during the call. May be called by any thread, one at a time, and
 * must not call Offing. */
typedef void (*OffingLog)(void* user, OffingLogLevel level, const char* line);
/** From now on the log of the whole process goes to this callback; for NULL warnings and errors go to stderr,
 * as at first. */
OffingStatus offing_set_log(OffingLog log, void* user);

/** What a device reports. Texts end with 0 and are cut to fit. */
typedef struct OffingDeviceInfo {
  size_t size;           /**< sizeof(OffingDeviceInfo) */
  int index;             /**< as offing_open_device() takes it */
  int compute_units;     /**< cores, or what the driver calls so */
  uint64_t memory_bytes; /**< that Offing uses at most */
  char type[16];         /**< "cpu", "gpu", "accelerator" or "other" */
  char name[128], vendor[128], platform[128], driver[128];
} OffingDeviceInfo;
/** Fills the first `capacity` devices, each of whose sizes is set, and says in `count` how many there are.
 * OFFING_NO_DEVICE where there is none. */
OffingStatus offing_list_devices(OffingDeviceInfo* devices, size_t capacity, size_t* count);

/** An OpenCL device by index, "cpu", "gpu" or a part of its name, as `offing devices` lists them; NULL or ""
 * for $OFFING_DEVICE, else the first GPU, else the CPU. */
OffingStatus offing_open_device(const char* selector, OffingDevice** device);
/** A device of the program's own: its cl_context and an in-order cl_command_queue of that context, which
 * Offing retains. Commands of both are then in one order. */
OffingStatus offing_adopt_device(void* context, void* queue, OffingDevice** device);
/** What the device reports. */
OffingStatus offing_get_device_info(const OffingDevice* device, OffingDeviceInfo* info);
/** The cl_context and the cl_command_queue of a device, which live as long as it does; NULL for NULL. */
void* offing_device_context(const OffingDevice* device);
void* offing_device_queue(const OffingDevice* device);
/** Waits until everything that was enqueued on the device is done. */
OffingStatus offing_finish_device(const OffingDevice* device);
/** As `offing devices` lists it; "" for NULL. Valid until the device is closed. */
const char* offing_device_name(const OffingDevice* device);
/** Worlds made on it stay whole. NULL does nothing, here and below. */
void offing_close_device(OffingDevice* device);

/** How a program watches a call that takes long, and stops it. NULL for the struct or the callback: nobody
 * watches. The callback is called in the thread of the call, with the share that is done, from 0 to 1, never
 * less than before. It returns 0 to go on. For another number the call returns OFFING_CANCELLED. It must not
 * free handles that the call uses. */
typedef struct OffingProgress {
  size_t size;                               /**< sizeof(OffingProgress) */
  int (*callback)(void* user, double share); /**< 0: go on */
  void* user;                                /**< what the callback gets */
} OffingProgress;

/** Reads a scene file (docs/scenes.md). */
OffingStatus offing_load_scene(const char* file, OffingScene** scene);
/** The same from text; file names in it are relative to `folder`, or to the working folder for NULL. */
OffingStatus offing_parse_scene(const char* text, const char* folder, OffingScene** scene);
/** Worlds made of it stay whole. */
void offing_free_scene(OffingScene* scene);

/** Wave spectra, one or many. */
typedef struct OffingSpectra OffingSpectra;

/** A wave spectrum. Between the frequencies energy is linear, outside them there is none. */
typedef struct OffingSpectrum {
  size_t size;                  /**< sizeof(OffingSpectrum) */
  size_t frequency_count;       /**< 2 or more */
  size_t direction_count;       /**< 0: the sea takes the spreading of the scene */
  const double* frequencies_hz; /**< [frequency_count], above 0, increasing */
  const double* energy_m2phz;   /**< [frequency_count], variance density over frequency */
  const double* directions_rad; /**< [direction_count], of travel, from +x (east) toward +z (south) */
  const double* density;        /**< [frequency_count][direction_count], m^2/Hz/rad */
  double latitude_deg, longitude_deg, depth_m; /**< NaN where not known */
  const char* station;                         /**< name of the place, "" where not known */
  const char* time_utc;                        /**< such as "2020-06-08T03:50Z", "" where not known */
} OffingSpectrum;

/** All spectra of a file: NDBC, WAVEWATCH III, SWAN, Datawell or NetCDF. */
OffingStatus offing_read_spectra(const char* file, OffingSpectra** spectra);
/** One spectrum from arrays, which are copied. With directions, of any order and at least two, energy is not
 * read; a part of the circle or uneven ones are laid on 360 directions. Where a density is negative, as
 * truncated Fourier series have it, each frequency keeps its energy and its first two circular moments, and
 * gets the spreading of maximum entropy. NULL for texts, and 0 for a depth,
 * stand for not known. */
OffingStatus offing_make_spectrum(const OffingSpectrum* spectrum, OffingSpectra** spectra);
/** The spectrum of a scene's sea, without its swells, at these frequencies and at evenly spaced directions.
 */
OffingStatus offing_tabulate_spectrum(const OffingScene* scene, const double* frequencies_hz,
                                      size_t frequency_count, size_t direction_count,
                                      OffingSpectra** spectra);
/** How many there are; 0 for NULL. */
size_t offing_spectrum_count(const OffingSpectra* spectra);
/** One of them; its arrays and texts live as long as `spectra`. */
OffingStatus offing_get_spectrum(const OffingSpectra* spectra, size_t index, OffingSpectrum* spectrum);
void offing_free_spectra(OffingSpectra* spectra);
/** From now on the sea of worlds made of this scene has this spectrum, in place of a model or a file. */
OffingStatus offing_set_spectrum(OffingScene* scene, const OffingSpectra* spectra, size_t index);

/** Figures of a sea state. */
typedef struct OffingSeaState {
  size_t size;               /**< sizeof(OffingSeaState) */
  double hs_m;               /**< 4 sqrt(m0) */
  double tp_s;               /**< integral of E^4 df / integral of f E^4 df */
  double tm01_s, tm02_s;     /**< m0 / m1, sqrt(m0 / m2) */
  double mean_direction_rad; /**< of travel, 0 to 2 pi */
  double mss;                /**< mean square slope */
} OffingSeaState;
/** What the spectrum of a scene's sea asks for, without swells. */
OffingStatus offing_get_sea_state(const OffingScene* scene, OffingSeaState* state);

/** What `offing ocean stats` finds (docs/ocean.md). Directions are of travel, 0 to 2 pi; mss is the mean
 * square slope. */
typedef struct OffingSeaStatistics {
  size_t size; /**< sizeof(OffingSeaStatistics) */
  /** What the spectrum asks for, without swells: offing_get_sea_state(). */
  double asked_hs_m, asked_tp_s, asked_tm01_s, asked_tm02_s, asked_mean_direction_rad, asked_mss;
  /** What is expected of the waves that the maps can hold, and of swells. */
  double resolved_hs_m, resolved_tp_s, resolved_tm01_s, resolved_tm02_s, resolved_mean_direction_rad,
      resolved_mss;
  /** Measured on the surface, means over the seeds. */
  double hs_m, tp_s, tm01_s, tm02_s, mean_direction_rad, mss;
  double skewness, kurtosis; /**< measured, of the height at rest labels; 0 and 3 for a Gaussian one */
  double max_ka;             /**< measured, steepness k A that one wave in 90 exceeds */
  double folded_share;       /**< measured, share of the surface that folds over itself */
  /** Of measured means from resolved values, one standard deviation. */
  double hs_standard_error_m, tm02_standard_error_s, mean_direction_standard_error_rad;
} OffingSeaStatistics;
/** Measures the sea of a scene on its surface, with so many seeds, 1 to 100000, from the scene's own upward.
 * Takes time in proportion; 8 seeds are a good start. */
OffingStatus offing_measure_sea(const OffingDevice* device, const OffingScene* scene, int seeds,
                                const OffingProgress* progress, OffingSeaStatistics* statistics);

/** The world of a scene, at the scene's start; it keeps nothing of the handles. */
OffingStatus offing_make_world(const OffingDevice* device, const OffingScene* scene, OffingWorld** world);
/** How a world is made; NULL and zeros: as by offing_make_world(). */
typedef struct OffingWorldOptions {
  size_t size;                    /**< sizeof(OffingWorldOptions) */
  const OffingProgress* progress; /**< NULL: nobody watches */
} OffingWorldOptions;
/** As offing_make_world(), for worlds that take long. The callback is called while clouds grow; terrain and
 * sea are made without a call between. */
OffingStatus offing_make_world_with(const OffingDevice* device, const OffingScene* scene,
                                    const OffingWorldOptions* options, OffingWorld** world);
/** Frees what the world holds on host and device. */
void offing_free_world(OffingWorld* world);

/** One frame: brings the world to this time, -1e8 to 1e8 s, any order of times. What is sampled and read
 * below is of the last frame. */
OffingStatus offing_frame(OffingWorld* world, double time_s);

/** A vertical of the world. */
typedef struct OffingPoint {
  double x_m, z_m; /**< within 2e7 m of the origin */
} OffingPoint;

/** What is asked at points. NULL stands for all zeros: velocity and pressure at the surface, every wave
 * counts. */
typedef struct OffingQuery {
  double depth_m;          /**< of velocity and pressure, below the moving surface */
  double min_wavelength_m; /**< shorter waves do not count, as for a large hull */
} OffingQuery;

/** The water at a point. */
typedef struct OffingSample {
  float height_m;        /**< of the surface */
  float normal[3];       /**< of the surface, unit, upward */
  float velocity_mps[3]; /**< of the water at the query's depth; rings of raindrops add nothing */
  float pressure_pa;     /**< there, above that of the air */
  float residual_m;      /**< by how much the point was missed sideways; large where the surface folds */
} OffingSample;

/** The water at `count` points, the composed sea of all cascades and Gerstner waves. */
OffingStatus offing_sample(OffingWorld* world, const OffingQuery* query, const OffingPoint* points,
                           size_t count, OffingSample* samples);

/** What offing_sample_water() is asked. NULL and zeros: velocity and pressure at the surface, every wave
 * counts. */
typedef struct OffingWaterQuery {
  size_t size;             /**< sizeof(OffingWaterQuery) */
  double depth_m;          /**< of velocity and pressure, below the moving surface */
  double min_wavelength_m; /**< shorter waves do not count, as for a large hull */
} OffingWaterQuery;

/** Where offing_sample_water() writes, an array for each quantity; NULL: not wanted. */
typedef struct OffingWater {
  size_t size;         /**< sizeof(OffingWater) */
  float* height_m;     /**< [count], of the surface */
  float* normal;       /**< [count][3], of the surface, unit, upward */
  float* velocity_mps; /**< [count][3], of the water at the query's depth */
  float* pressure_pa;  /**< [count], there, above that of the air */
  float* residual_m;   /**< [count], as in OffingSample */
} OffingWater;

/** As offing_sample(), with points [count][2] of x and z in m, and arrays of the caller's. Velocity and
 * pressure cost nothing where neither is wanted. */
OffingStatus offing_sample_water(OffingWorld* world, const OffingWaterQuery* query, const double* points_m,
                                 size_t count, const OffingWater* water);

/** The same with cl_mem buffers of the device's context, without a transfer or a wait. In: `points`
 * [count] of two int32 tiles (x, z) and two floats (x, z): a place is 64 tile + float, m. Out: `samples`
 * [count] of eight floats: height m, slopes dh/dx and dh/dz, residual m, velocity x, y, z m/s, pressure Pa.
 */
OffingStatus offing_sample_water_on_device(OffingWorld* world, const OffingWaterQuery* query, void* points,
                                           size_t count, void* samples);

/** Maps of one cascade: a periodic patch of sea, without the waves that its scene's Gerstner waves carry. */
typedef enum OffingField {
  OFFING_DISPLACEMENT_X,          /**< m */
  OFFING_DISPLACEMENT_Y,          /**< m, the height */
  OFFING_DISPLACEMENT_Z,          /**< m */
  OFFING_SLOPE_X,                 /**< dh/dx at rest labels */
  OFFING_SLOPE_Z,                 /**< dh/dz at rest labels */
  OFFING_JACOBIAN,                /**< below 0 the surface folds */
  OFFING_FOAM,                    /**< 0 to 1 */
  OFFING_GRADIENT_XX,             /**< d displacement_x / dx at rest labels */
  OFFING_GRADIENT_XZ,             /**< d displacement_x / dz = d displacement_z / dx */
  OFFING_GRADIENT_ZZ,             /**< d displacement_z / dz */
  OFFING_JACOBIAN_MIN_EIGENVALUE, /**< the smaller eigenvalue of I + gradient */
  OFFING_VELOCITY_X,              /**< m/s, of the water at the surface */
  OFFING_VELOCITY_Y,              /**< m/s */
  OFFING_VELOCITY_Z               /**< m/s */
} OffingField;

/** How many cascades the sea has, 1 to 4. */
int offing_cascade_count(const OffingWorld* world);
/** n: a map has n x n values. */
int offing_map_size(const OffingWorld* world);
/** Length of a cascade's patch, m; 0 for a cascade that there is not. */
double offing_patch_length_m(const OffingWorld* world, int cascade);
/** Values [n][n], row-major, row = z, column = x, the first one at label (0, 0). `count` must be n * n. */
OffingStatus offing_read(OffingWorld* world, int cascade, OffingField field, float* values, size_t count);
/** The same of several fields, values[i] of fields[i], each of `count` = n * n values: cheaper than one by
 * one. */
OffingStatus offing_read_fields(OffingWorld* world, int cascade, const OffingField* fields,
                                size_t field_count, float* const* values, size_t count);
/** Enqueues the copy of a map of n * n floats to a cl_mem of the device's context, from the float of index
 * `first` on: no transfer, no wait. */
OffingStatus offing_copy_field(OffingWorld* world, int cascade, OffingField field, void* buffer,
                               size_t first);

/* Terrain. The north-west post of a map is at x = z = 0; x is east of it, z south, heights are the map's own.
 * Where no accuracy is stated, answers are in double precision. */

/** How heights are packed into the samples of a file. */
typedef enum OffingHeightEncoding {
  OFFING_HEIGHTS_PLAIN = 0, /**< one band holds heights */
  OFFING_HEIGHTS_MAPBOX,    /**< 8-bit RGB: -10000 + 0.1 (65536 R + 256 G + B) m */
  OFFING_HEIGHTS_TERRARIUM  /**< 8-bit RGB: 256 R + G + B / 256 - 32768 m */
} OffingHeightEncoding;
/** Samples of a file without a header. */
typedef enum OffingRawType {
  OFFING_RAW_BY_NAME = 0, /**< unsigned 16 bits for .r16, floats for .r32 */
  OFFING_RAW_UNSIGNED_16,
  OFFING_RAW_SIGNED_16,
  OFFING_RAW_FLOAT_32
} OffingRawType;
/** What coordinates count in. */
typedef enum OffingHorizontalUnit {
  OFFING_UNIT_OF_FILE = 0,
  OFFING_UNIT_METRE,
  OFFING_UNIT_DEGREE
} OffingHorizontalUnit;

/** How to read a height map. NULL and zeros stand for what the file says. */
typedef struct OffingTerrainOptions {
  size_t size;                     /**< sizeof(OffingTerrainOptions) */
  double spacing_x_m, spacing_z_m; /**< between neighbouring posts */
  double vertical_scale;           /**< metres a unit of the file; 0: 1 */
  double offset_m;                 /**< added to the scaled height */
  const double* nodata;            /**< a value, before any scale, that marks voids too; may be NaN */
  const double* void_height_m;     /**< of voids; NULL: filled from their surroundings */
  const char* reproject_to;        /**< resample to metres in this system: "utm", "EPSG:32719" */
  int is_untrusted;                /**< 1: the file may lead to files in its folder and below alone */
  int band;                        /**< of files with several, from 1 on; 0: the first */
  OffingHeightEncoding encoding;
  OffingHorizontalUnit horizontal_unit; /**< of files that name no coordinate system */
  const char* exr_channel;              /**< NULL: the only one, or one of height, Y, Z, R */
  int raw_columns, raw_rows;            /**< of files without a header (.r16, .r32, .raw, .bin) */
  OffingRawType raw_type;
  int is_raw_big_endian;
} OffingTerrainOptions;

/** Reads a height map (docs/terrain.md lists the formats) and keeps it in memory and on the device. A map
 * that does not say how far apart its posts are produces a warning in the log. */
OffingStatus offing_open_terrain(const OffingDevice* device, const char* file,
                                 const OffingTerrainOptions* options, OffingTerrain** terrain);
/** The same from heights [rows][columns] m, finite and within 1e6 m, which are copied. Row 0 is the north
 * edge, and there are 2 posts or more along both axes. */
OffingStatus offing_make_terrain(const OffingDevice* device, const float* heights_m, int columns, int rows,
                                 double spacing_x_m, double spacing_z_m, OffingTerrain** terrain);
/** Frees what the terrain holds on host and device. */
void offing_free_terrain(OffingTerrain* terrain);

/** What a terrain is. */
typedef struct OffingTerrainInfo {
  size_t size;                     /**< sizeof(OffingTerrainInfo) */
  int columns, rows;               /**< of posts */
  double spacing_x_m, spacing_z_m; /**< between neighbouring posts */
  double lowest_m, highest_m;      /**< of all posts, also of voids that were filled */
  uint64_t void_posts;             /**< that had no height in the file */
  /** Post (column, row) is at (origin_x + column step_x, origin_y + row step_y) of the map's own coordinate
   * system, in its units. step_y is negative where rows go south. NaN where not known. */
  double origin_x, origin_y, step_x, step_y;
  double centre_latitude_deg, centre_longitude_deg; /**< WGS 84; NaN where not known */
  const char* coordinate_system;     /**< its name, "" where not known; lives as long as the terrain */
  const char* coordinate_system_wkt; /**< as WKT, "" where not known; lives as long as the terrain */
  const char* format;                /**< of the file, such as "GeoTIFF"; lives as long as the terrain */
  int is_spacing_assumed;            /**< 1: nothing gives the spacing, so 1 m is assumed */
} OffingTerrainInfo;
/** What it is. */
OffingStatus offing_get_terrain_info(OffingTerrain* terrain, OffingTerrainInfo* info);

/** Reads all posts: heights [rows][columns] m, and is_void [rows][columns], 1 where the file had no height
 * and one was filled in. NULL: not wanted. `count` must be rows * columns. */
OffingStatus offing_read_terrain(OffingTerrain* terrain, float* heights_m, uint8_t* is_void, size_t count);

/** How questions about terrain are meant. NULL and zeros: normals of patches, flat ground. */
typedef struct OffingTerrainQuery {
  size_t size;            /**< sizeof(OffingTerrainQuery) */
  int has_smooth_normals; /**< 1: from the posts around, without creases; 0: of the bilinear patch itself */
  /** Ground falls away below the start of a ray or a line of sight by (1 - refraction) d^2 / (2
   * earth_radius_m) at a distance d in plan. 0: flat ground; 6371008.8 is the Earth's mean radius. */
  double earth_radius_m;
  double refraction; /**< how light bends after it, 0 to 1; 0.13 is usual near the ground */
} OffingTerrainQuery;

/** Where offing_sample_terrain() writes; NULL: not wanted. */
typedef struct OffingTerrainSamples {
  size_t size;          /**< sizeof(OffingTerrainSamples) */
  double* height_m;     /**< [count]; NaN beyond the map */
  double* normal;       /**< [count][3], unit; NaN beyond the map */
  uint8_t* is_measured; /**< [count]; 0 beyond the map, and where the height is made of filled voids */
} OffingTerrainSamples;
/** The ground at points [count][2] of x and z in m. */
OffingStatus offing_sample_terrain(OffingTerrain* terrain, const OffingTerrainQuery* query,
                                   const double* points_m, size_t count, const OffingTerrainSamples* samples);

/** What a ray hit. */
typedef enum OffingHitKind {
  OFFING_HIT_NONE = 0,
  OFFING_HIT_SURFACE, /**< the surface, from above */
  OFFING_HIT_SIDE,    /**< the map's edge, below the surface: ground is solid */
  OFFING_HIT_INSIDE   /**< nothing: the ray starts on or below the surface */
} OffingHitKind;

/** Where offing_cast_rays() writes; NULL: not wanted. */
typedef struct OffingHits {
  size_t size;        /**< sizeof(OffingHits) */
  double* distance_m; /**< [count], along the ray; infinity: it hits nothing */
  double* point_m;    /**< [count][3], as the map has heights; NaN where nothing is hit */
  float* normal;      /**< [count][3], unit; NaN where nothing is hit */
  uint8_t* kind;      /**< [count], an OffingHitKind */
} OffingHits;
/** What rays hit first: from origins [count][3] m along unit directions [count][3]. What lies beyond
 * limits_m [count] is not hit; NULL: no limits. An origin may be 2^22 cells from the map at most. Rays are
 * cast on the device: hits are right to 1e-3 cells across the surface and to 2^-23 of the way over the map.
 * Rays that touch the ground to less than 1e-4 cells may hit or miss it. */
OffingStatus offing_cast_rays(OffingTerrain* terrain, const OffingTerrainQuery* query,
                              const double* origins_m, const double* directions, const double* limits_m,
                              size_t count, const OffingHits* hits);

/** Where offing_trace_sight_lines() writes; NULL: not wanted. */
typedef struct OffingSightLines {
  size_t size;         /**< sizeof(OffingSightLines) */
  uint8_t* is_visible; /**< [count], 1 or 0 */
  double* distance_m;  /**< [count], from end to end */
  double* hidden_at_m; /**< [count], from the first end to what hides the other; NaN where visible */
  double* hidden_by_m; /**< [count][3], the place of the ground there; NaN where visible */
} OffingSightLines;
/** Lines of sight between ends [count][3]: x, z and the height above ground, each in m. Both lie on the map,
 * apart, and may lie on the ground. Ground within 2e-3 cells of an end hides nothing. As exact as
 * offing_cast_rays(). */
OffingStatus offing_trace_sight_lines(OffingTerrain* terrain, const OffingTerrainQuery* query,
                                      const double* from_m, const double* to_m, size_t count,
                                      const OffingSightLines* lines);

/** Who looks, and at what. */
typedef struct OffingViewshed {
  size_t size;                       /**< sizeof(OffingViewshed) */
  double observer_x_m, observer_z_m; /**< on the map */
  double observer_height_m;          /**< of the eye above the ground, 0 to 1e6 */
  double target_height_m;            /**< of what is to be seen above the ground, 0 to 1e6 */
  double radius_m;                   /**< in plan; what is beyond is not seen; 0: no limit */
  double earth_radius_m, refraction; /**< as in OffingTerrainQuery, from the observer on */
} OffingViewshed;
/** Which posts are seen: seen [rows][columns] becomes 255 where a post is visible, 0 where it is hidden, also
 * at voids that were filled. `count` must be rows * columns. Lines of sight follow the surface between
 * posts; 1e-5 of the posts, whose lines touch it to rounding, may differ from double precision. */
OffingStatus offing_compute_viewshed(OffingTerrain* terrain, const OffingViewshed* viewshed, uint8_t* seen,
                                     size_t count);

/* Floating bodies of a world: the [[body]] sections of its scene, in their order. Body axes: x forward, y up,
 * z to starboard, their origin in the mass centre. */

/** How many there are; 0 for NULL. */
size_t offing_body_count(const OffingWorld* world);
/** The name of one in its scene; "" where it has none. Valid as long as the world. */
const char* offing_body_name(const OffingWorld* world, size_t body);

/** Where offing_read_body_poses() writes; NULL: not wanted. */
typedef struct OffingBodyPoses {
  size_t size;           /**< sizeof(OffingBodyPoses) */
  double* mass_centre_m; /**< [count][3], y above the water plane */
  double* turn;          /**< [count][4], unit quaternion w, x, y, z from body axes to the world's */
  double* velocity_mps;  /**< [count][3], of the mass centre, in world axes */
  double* spin_radps;    /**< [count][3], in body axes */
  double* displaced_m3;  /**< [count], of water, a sub-step before */
} OffingBodyPoses;
/** Poses of all bodies at the time of the last frame. `count` must be offing_body_count(). Bodies are
 * simulated in sub-steps of 1/120 s; between states 1/30 s apart poses are interpolated. The same scene gives
 * the same poses, whatever frames were asked for. */
OffingStatus offing_read_body_poses(OffingWorld* world, size_t count, const OffingBodyPoses* poses);

/** Where offing_read_body_forces() writes; NULL: not wanted. Forces and moments are in world axes, moments
 * about the mass centre. */
typedef struct OffingBodyForces {
  size_t size;               /**< sizeof(OffingBodyForces) */
  double* time_s;            /**< [1], the end of the sub-step that all are of */
  float* pressure_n;         /**< [count][3], of the water's pressure */
  float* pressure_moment_nm; /**< [count][3] */
  float* drag_n;             /**< [count][3], of friction, drag and the waves that the hull makes */
  float* drag_moment_nm;     /**< [count][3] */
  float* displaced_m3;       /**< [count], of water */
  float* wetted_m2;          /**< [count], of the hull */
} OffingBodyForces;
/** What the water does to all bodies in the last sub-step that was simulated. Bodies are simulated ahead of
 * frames: `time_s` is up to 0.14 s after the latest frame so far. `count` must be offing_body_count(). */
OffingStatus offing_read_body_forces(OffingWorld* world, size_t count, const OffingBodyForces* forces);

/* Clouds of a world, as they are at its last frame. A world without clouds has no particles, and its pictures
 * of clouds are empty. */

/** How many there are: those of [[cloud]] in their order, then those of the layers; 0 for NULL. */
size_t offing_cloud_count(const OffingWorld* world);
/** How many particles all of them have; 0 for NULL. */
size_t offing_cloud_particle_count(const OffingWorld* world);

/** Where offing_read_cloud_particles() writes; NULL: not wanted. */
typedef struct OffingCloudParticles {
  size_t size;            /**< sizeof(OffingCloudParticles) */
  double* place_m;        /**< [count][3], of the middle, to 1e-3 m within 8 km of the sky's origin */
  float* radius_m;        /**< [count] */
  float* optical_mass_m2; /**< [count], its extinction (1/m) over its volume */
  float* albedo;          /**< [count][3], of single scattering, linear Rec.709, 0 to 1 */
  uint32_t* cloud;        /**< [count], which cloud it belongs to */
  uint32_t* id;           /**< [count], unique within its cloud, the same in every frame */
} OffingCloudParticles;
/** The particles of all clouds. `count` must be offing_cloud_particle_count(). */
OffingStatus offing_read_cloud_particles(OffingWorld* world, size_t count,
                                         const OffingCloudParticles* particles);

/** The extinction of the particles at points [count][3] m: extinction_per_m [count], 1/m. They are laid on a
 * grid of cells of cell_m, 0.001 to 1e5 m, whose cells keep their optical mass; between the middles of cells
 * it is trilinear. A particle smaller than a cell spreads over one. The grid is kept for calls about the same
 * frame. */
OffingStatus offing_sample_clouds(OffingWorld* world, double cell_m, const double* points_m, size_t count,
                                  double* extinction_per_m);

/** An eye and what it sees. */
typedef struct OffingCamera {
  size_t size;                       /**< sizeof(OffingCamera) */
  double eye_m[3];                   /**< in the world */
  double yaw_rad;                    /**< 0 along -z (north), growing toward +x (east) */
  double pitch_rad;                  /**< upward, -pi/2 to pi/2 */
  double roll_rad;                   /**< of the head, clockwise */
  double vertical_field_of_view_rad; /**< above 0, below pi */
  int width_px, height_px;           /**< of the picture, 1 or more */
} OffingCamera;
/** The camera of the world's scene at the last frame. */
OffingStatus offing_get_camera(OffingWorld* world, OffingCamera* camera);

/** What a camera sees of the clouds, as if nothing else were there: rgba_kcdpm2 [height][width][4], linear
 * Rec.709 in kcd/m^2, premultiplied, and opacity 0 to 1; distance_m [height][width], the mean distance of the
 * light, 0 where there is none. Row 0 is at the top. NULL: not wanted. `count` must be width * height.
 * `offing-view --compare-reference` holds such pictures against traced paths. */
OffingStatus offing_draw_clouds(OffingWorld* world, const OffingCamera* camera, float* rgba_kcdpm2,
                                float* distance_m, size_t count);

/* Meshes of a world, the [[mesh]] sections of its scene in their order, and their highlights. */

/** How many there are; 0 for NULL. */
size_t offing_mesh_count(const OffingWorld* world);
/** The name of one in its scene; "" where it has none. Valid as long as the world. */
const char* offing_mesh_name(const OffingWorld* world, size_t mesh);

/** Where a mesh is: world = turn * mesh + position_m. */
typedef struct OffingMeshPose {
  size_t size;          /**< sizeof(OffingMeshPose) */
  double position_m[3]; /**< of the mesh's origin, in the world */
  double turn[4];       /**< unit quaternion w, x, y, z from the mesh's axes to the world's */
} OffingMeshPose;
/** Where a mesh is at the last frame. */
OffingStatus offing_get_mesh_pose(OffingWorld* world, size_t mesh, OffingMeshPose* pose);

/** What a highlight's projector casts. */
typedef enum OffingTexture {
  OFFING_TEXTURE_DOT = 0,
  OFFING_TEXTURE_WINDOW,
  OFFING_TEXTURE_STAR,
  OFFING_TEXTURE_RING,
  OFFING_TEXTURE_STREAK,
  OFFING_TEXTURE_HEART,
  OFFING_TEXTURE_IMAGE,     /**< the picture of its rule */
  OFFING_TEXTURE_NORMAL_MAP /**< the picture of its rule */
} OffingTexture;

/** Where offing_read_highlights() writes; NULL: not wanted. A projector is a box that casts its texture along
 * -normal onto its mesh. The texture reaches from -1 to 1 along right and up over width and height. Vectors
 * are in the mesh's axes (offing_get_mesh_pose()). */
typedef struct OffingHighlights {
  size_t size;        /**< sizeof(OffingHighlights) */
  uint64_t* id;       /**< [count], the same through a sequence; copies of one highlight share it */
  int32_t* rule;      /**< [count], which [[mesh.highlight]] it is drawn by; -1: none */
  int32_t* copy;      /**< [count], of those that a rule splits it into */
  int32_t* light;     /**< [count], which [[light]]; the one after the last is the sun; -1: a pin */
  double* position_m; /**< [count][3], middle of the box */
  double* right;      /**< [count][3], unit; right x up = normal */
  double* up;         /**< [count][3], unit */
  double* normal;     /**< [count][3], unit, out of the surface */
  double* width_m;    /**< [count], full, along right */
  double* height_m;   /**< [count], full, along up */
  double* opacity;    /**< [count], above 0, at most 1 */
  int32_t* texture;   /**< [count], an OffingTexture */
  double* softness;   /**< [count], of a shape's rim, in half widths */
  double* colour;     /**< [count][3], linear Rec.709, times that of the light */
} OffingHighlights;
/** Finds the highlights of all meshes at the last frame, for the eye of the scene. They depend on that time
 * and on first_s alone: the time of the first frame of the sequence, not after it. Frames of one sequence
 * share a past, in which highlights keep their ids and nothing jumps. */
OffingStatus offing_find_highlights(OffingWorld* world, double first_s);
/** How many a mesh has by the last offing_find_highlights(); 0 before one. */
OffingStatus offing_count_highlights(OffingWorld* world, size_t mesh, size_t* count);
/** The projectors of a mesh's highlights. `count` must be that of
 * offing_count_highlights(). */
OffingStatus offing_read_highlights(OffingWorld* world, size_t mesh, size_t count,
                                    const OffingHighlights* highlights);

/* Meshes of files and arrays. The corners of a triangle are anticlockwise seen from outside. Triangles
 * without an area, repeated ones, borders and edges of three triangles are kept. */

/** How to read a mesh. NULL stands for zeros. */
typedef struct OffingMeshOptions {
  size_t size;      /**< sizeof(OffingMeshOptions) */
  int is_untrusted; /**< 1: the file may lead to files in its folder and below alone */
} OffingMeshOptions;
/** Reads a mesh: OBJ, PLY, OFF, STL or glTF. Vertices and triangles are in the order of the file, polygons
 * are cut into triangles, and corners of an STL at one place become one vertex. What a mesh cannot hold
 * produces a warning in the log. */
OffingStatus offing_open_mesh(const char* file, const OffingMeshOptions* options, OffingMesh** mesh);
/** The same from vertices [vertex_count][3] m, finite and within 1e30 m, and triangles [triangle_count][3] of
 * vertices counted from 0 on, at least one. Both are copied. */
OffingStatus offing_make_mesh(const double* vertices_m, size_t vertex_count, const uint32_t* triangles,
                              size_t triangle_count, OffingMesh** mesh);
void offing_free_mesh(OffingMesh* mesh);

/** What a mesh is. */
typedef struct OffingMeshInfo {
  size_t size; /**< sizeof(OffingMeshInfo) */
  size_t vertex_count, triangle_count;
  double lowest_m[3], highest_m[3]; /**< the box around all vertices */
  const char* format; /**< of the file, such as "OBJ"; "" of arrays; lives as long as the mesh */
} OffingMeshInfo;
/** What it is. */
OffingStatus offing_get_mesh_info(const OffingMesh* mesh, OffingMeshInfo* info);
/** Reads vertices [vertex_count][3] m and triangles [triangle_count][3]. NULL: not wanted. Counts must be
 * those of offing_get_mesh_info(), or 0 where the array is not wanted. */
OffingStatus offing_read_mesh(const OffingMesh* mesh, double* vertices_m, size_t vertex_count,
                              uint32_t* triangles, size_t triangle_count);
/** Writes what the name says: .ply, .obj, .off or .stl, with the normals of the file that was read, but for
 * .off and .stl. An existing file is kept, and the call returns OFFING_BAD_INPUT, unless `replace` is 1. */
OffingStatus offing_save_mesh(const OffingMesh* mesh, const char* file, int replace);

/** How offing_compute_curvatures() works. NULL and zeros: 3 rounds. */
typedef struct OffingCurvatureOptions {
  size_t size; /**< sizeof(OffingCurvatureOptions) */
  int rounds;  /**< of averages with neighbours, 1 to 1000; more smooth a noisy surface */
} OffingCurvatureOptions;
/** Where offing_compute_curvatures() writes; NULL: not wanted. Curvatures are positive where the surface is
 * convex seen from outside: both are 1/r on a sphere of radius r. Directions are lines: their sign means
 * nothing. Curvatures, vectors and confidence are 0 where a vertex has no triangle with an area. */
typedef struct OffingCurvatures {
  size_t size;         /**< sizeof(OffingCurvatures) */
  double* k_max_per_m; /**< [count], the largest curvature, 1/m */
  double* k_min_per_m; /**< [count], the smallest, 1/m */
  double* e_max;       /**< [count][3], unit direction of the largest */
  double* e_min;       /**< [count][3], unit direction of the smallest */
  double* normal;      /**< [count][3], unit, outward: e_max x e_min */
  double* area_m2;     /**< [count], a third of the triangles around */
  double* confidence;  /**< [count], 0 to 1: how far to trust directions; near 0 on spheres */
} OffingCurvatures;
/** Curvatures at all vertices. `count` must be the mesh's vertex_count. Vertices at exactly the same place
 * count as one. Angles at edges are averaged with those of neighbours, as method `diffused` of `offing-mesh
 * curvature` does, on the device in single precision.
 *
 * Measured errors with 3 rounds, mean and largest. Those of curvatures are in % of the larger one at a
 * vertex. Those of e_max are where both differ by a tenth or more. "Moved" vertices lie up to a quarter of an
 * edge along the surface from where an icosphere, stretched to half axes of 1 : 0.75 : 0.5 for ellipsoids,
 * has them.
 *
 *     mesh                        vertices   curvatures %   e_max, deg   normal, deg
 *     sphere                        10,242     0.1,  1.4                   0.04, 0.2
 *     sphere, moved                 10,242     0.4,  3.6                    0.5, 1.4
 *     ellipsoid, moved              10,242     0.5,  4.8      0.6,  6.5      0.5, 2.2
 *     ellipsoid, moved                 642     3.4, 18        2.1, 15        2.0, 7.1
 *     ellipsoid, moved             655,362     0.2,  3.8      0.2,  6.8      0.06, 0.3
 *
 * Noise off the surface of 0.02 edges (standard deviation) raises the third row to 5 and 46 %; 10 rounds
 * lower that to 1.4 and 8.6 %. Where edges are 1/400 of a sphere's radius, rounding adds 0.03 %, and four
 * times as much for edges half as long. */
OffingStatus offing_compute_curvatures(const OffingDevice* device, const OffingMesh* mesh,
                                       const OffingCurvatureOptions* options, size_t count,
                                       const OffingCurvatures* curvatures);

/** What draws pictures of a scene, with a world of its own. */
typedef struct OffingRenderer OffingRenderer;

/** A picture that is asked for, and where it goes; NULL: not wanted. */
typedef struct OffingPicture {
  size_t size;             /**< sizeof(OffingPicture) */
  int width_px, height_px; /**< 1 to 16384 */
  double time_s;           /**< -1e8 to 1e8, any order of times */
  unsigned char* rgb;      /**< [height][width][3], sRGB, row 0 at the top */
  float* light;            /**< [height][width][3], linear Rec.709 in kcd/m^2, row 0 at the top */
} OffingPicture;

/** Needs OpenGL, but no display: OFFING_NO_DEVICE without it. The camera is the scene's. */
OffingStatus offing_make_renderer(const OffingDevice* device, const OffingScene* scene,
                                  OffingRenderer** renderer);
/** Draws the picture, as `offing-view --headless` does. Any thread may call, one at a time. */
OffingStatus offing_render(OffingRenderer* renderer, const OffingPicture* picture);
void offing_free_renderer(OffingRenderer* renderer);

#ifdef __cplusplus
}
#endif

#endif
