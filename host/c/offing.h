/** @file
 * Offing for programs in C and whatever can call C: a device, a scene, the world that it describes at any
 * time, the water at points of it, and its maps.
 *
 * Axes: x east, y up, z south, right-handed; metres, seconds, radians. Handles belong to the thread that made
 * them. Every call that can fail returns an OffingStatus; when it is OFFING_BAD_INPUT nothing was changed,
 * and after any failure offing_last_error() says what was wrong and offing_last_hint() how to fix it. No
 * exception leaves a call. Settings of a scene that have no effect, or less than asked, produce warnings on
 * stderr. */
#ifndef OFFING_H
#define OFFING_H

#include <stddef.h>

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
  OFFING_NO_DEVICE = 3  /**< no OpenCL device of this name, or none at all */
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

/** An OpenCL device by index, "cpu", "gpu" or a part of its name, as `offing devices` lists them; NULL or ""
 * for $OFFING_DEVICE, else the first GPU, else the CPU. */
OffingStatus offing_open_device(const char* selector, OffingDevice** device);
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

/** Maps of one cascade: a periodic patch of sea, without the waves that its scene's Gerstner waves carry. */
typedef enum OffingField {
  OFFING_DISPLACEMENT_X, /**< m */
  OFFING_DISPLACEMENT_Y, /**< m, the height */
  OFFING_DISPLACEMENT_Z, /**< m */
  OFFING_SLOPE_X,        /**< dh/dx at rest labels */
  OFFING_SLOPE_Z,        /**< dh/dz at rest labels */
  OFFING_JACOBIAN,       /**< below 0 the surface folds */
  OFFING_FOAM            /**< 0 to 1 */
} OffingField;

/** How many cascades the sea has, 1 to 4. */
int offing_cascade_count(const OffingWorld* world);
/** n: a map has n x n values. */
int offing_map_size(const OffingWorld* world);
/** Length of a cascade's patch, m; 0 for a cascade that there is not. */
double offing_patch_length_m(const OffingWorld* world, int cascade);
/** Values [n][n], row-major, row = z, column = x, the first one at label (0, 0). `count` must be n * n. */
OffingStatus offing_read(OffingWorld* world, int cascade, OffingField field, float* values, size_t count);

#ifdef __cplusplus
}
#endif

#endif
