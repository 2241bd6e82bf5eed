/** @file
 * Offing for programs in C and whatever can call C: a device, a scene, the world that it describes at any
 * time, the water at points of it, and its maps.
 *
 * Axes: x east, y up, z south, right-handed; metres, seconds, radians.
 *
 * Every call that can fail returns an OffingStatus. When it is OFFING_BAD_INPUT or OFFING_BUSY nothing was
 * changed, and after any failure offing_last_error() says what was wrong and offing_last_hint() how to fix
 * it. No exception leaves a call. Settings of a scene that have no effect, or less than asked, produce
 * warnings in the log.
 *
 * Structs that programs fill or read begin with `size`: set it to sizeof the struct. Later versions add
 * members at the end; zero stands for what a struct of an older version lacks.
 *
 * Threads: devices, scenes and spectra may be used by several threads at once. A world may be used by any
 * thread, but by one at a time: a call that finds another thread in a call with the same handle returns
 * OFFING_BUSY. Different worlds run on different threads at the same time, also on one device. Do not free
 * a handle while another thread uses it. */
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
/** The sea of a scene on a device, at one time. */
typedef struct OffingWorld OffingWorld;

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

/** The world of a scene, at the scene's start; it keeps nothing of the handles. */
OffingStatus offing_make_world(const OffingDevice* device, const OffingScene* scene, OffingWorld** world);
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
