/** @file
 * Offing for C and for languages that call C. Open a device, load a scene and make its world. Then ask for
 * water, terrain, bodies, clouds, highlights and pictures at any time.
 *
 * Axes: x east, y up, z south, right-handed; metres, seconds, radians.
 *
 * Every call that can fail returns an OffingStatus. After a failure, offing_last_error() says what was wrong
 * and offing_last_hint() how to fix it. OFFING_BAD_INPUT, OFFING_BUSY and OFFING_CANCELLED mean that nothing
 * has changed. No exception leaves a call. Settings of a scene that have no effect produce warnings in the
 * log.
 *
 * Structs begin with `size`, except OffingPoint, OffingQuery and OffingSample. Set it to sizeof the struct
 * before each call. Later versions add members at the end. For a struct of an older version, the missing
 * members are zero.
 *
 * Arrays belong to the caller. [count][3] means `count` rows of three values, one row after the other. In a
 * struct that says where a call writes, NULL means that you do not want this quantity.
 *
 * Threads: several threads may use a device, a scene, spectra or a mesh at once. A world, a terrain or a
 * renderer takes calls from any thread, one at a time. If another thread is in a call with it, a call returns
 * OFFING_BUSY. Worlds on one device may run in different threads. If one thread gives a scene another
 * spectrum (offing_set_spectrum()), a call of another thread takes either the old or the new one. Do not free
 * a handle while another thread uses it. */
#ifndef OFFING_H
#define OFFING_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Version of this header's calls. It grows when a released call changes. */
#define OFFING_INTERFACE 1

/** How a call ended. */
typedef enum OffingStatus {
  OFFING_OK = 0,        /**< done */
  OFFING_FAILED = 1,    /**< out of memory, a driver's error, a file that cannot be read */
  OFFING_BAD_INPUT = 2, /**< a wrong argument or scene, or a value out of range */
  OFFING_NO_DEVICE = 3, /**< no such OpenCL device, or no OpenGL for a renderer */
  OFFING_CANCELLED = 4, /**< a callback of the program asked to stop */
  OFFING_BUSY = 5       /**< another thread is in a call with the same handle */
} OffingStatus;

/** An open OpenCL device. */
typedef struct OffingDevice OffingDevice;
/** The settings of a scene file. */
typedef struct OffingScene OffingScene;
/** The world of a scene on a device, at one time. */
typedef struct OffingWorld OffingWorld;
/** A height map on a device: the surface of bilinear patches between its posts. */
typedef struct OffingTerrain OffingTerrain;
/** The points of a GIS file. They do not change. */
typedef struct OffingPointFile OffingPointFile;
/** A triangle mesh. It does not change. */
typedef struct OffingMesh OffingMesh;

/** The version of the library, as "1.2.3". */
const char* offing_version(void);
/** OFFING_INTERFACE of the library. Compare it with that of the header you compiled with. */
int offing_interface(void);

/** What was wrong in this thread's last call that failed, in one line; "" if none has failed. Valid until
 * another call of this thread fails. */
const char* offing_last_error(void);
/** How to fix it, in one line, or "". Valid as long as offing_last_error(). */
const char* offing_last_hint(void);

/** How severe a line of the log is. */
typedef enum OffingLogLevel {
  OFFING_LOG_ERROR = 0,
  OFFING_LOG_WARNING = 1,
  OFFING_LOG_INFO = 2,
  OFFING_LOG_DEBUG = 3
} OffingLogLevel;
/** Takes one line of the log, without a line break. The line is valid during the call. Any thread may call,
 * one at a time. The callback must not call Offing. */
typedef void (*OffingLog)(void* user, OffingLogLevel level, const char* line);
/** Sends the log of the whole process to this callback from now on. NULL restores the default: warnings and
 * errors go to stderr. Call it while no other thread uses Offing. */
OffingStatus offing_set_log(OffingLog log, void* user);

/** What a device reports. Texts are cut to fit and end with 0. */
typedef struct OffingDeviceInfo {
  size_t size;           /**< sizeof(OffingDeviceInfo) */
  int index;             /**< a selector for offing_open_device() */
  int compute_units;     /**< as OpenCL counts them: the cores of a CPU */
  uint64_t memory_bytes; /**< global memory that Offing can use */
  char type[16];         /**< "cpu", "gpu", "accelerator" or "other" */
  char name[128], vendor[128], platform[128], driver[128];
} OffingDeviceInfo;
/** Writes at most `capacity` devices, and in `count` how many there are. Set `size` of each element first.
 * Returns OFFING_NO_DEVICE if there is none. */
OffingStatus offing_list_devices(OffingDeviceInfo* devices, size_t capacity, size_t* count);

/** Opens a device by its index, "cpu", "gpu" or a part of its name; `offing devices` lists them. NULL or ""
 * takes $OFFING_DEVICE, else the first GPU, else the CPU. */
OffingStatus offing_open_device(const char* selector, OffingDevice** device);
/** Uses your own cl_context and an in-order cl_command_queue of it. Offing retains both, and enqueues its
 * commands in your queue, so that they run in order with yours. */
OffingStatus offing_adopt_device(void* context, void* queue, OffingDevice** device);
/** What the device reports. */
OffingStatus offing_get_device_info(const OffingDevice* device, OffingDeviceInfo* info);
/** The device's cl_context, valid until the device is closed; NULL for NULL. */
void* offing_device_context(const OffingDevice* device);
/** The device's cl_command_queue, valid until the device is closed; NULL for NULL. */
void* offing_device_queue(const OffingDevice* device);
/** Waits until the device has done all enqueued commands. */
OffingStatus offing_finish_device(const OffingDevice* device);
/** The device's name; "" for NULL. Valid until the device is closed. */
const char* offing_device_name(const OffingDevice* device);
/** Closes the device. Worlds, terrains and renderers made on it stay valid. All calls that close or free
 * accept NULL and then do nothing. */
void offing_close_device(OffingDevice* device);

/** Reports the progress of a long call, and can stop it. The struct or the callback may be NULL.
 *
 * The callback runs in the thread of the call. It gets the share that is done, from 0 to 1, which never
 * decreases. It returns 0 to go on; after any other number the call returns OFFING_CANCELLED. It must not
 * free handles that the call uses. */
typedef struct OffingProgress {
  size_t size;                               /**< sizeof(OffingProgress) */
  int (*callback)(void* user, double share); /**< 0: go on */
  void* user;                                /**< passed to the callback */
} OffingProgress;

/** Reads a scene file (docs/scenes.md). */
OffingStatus offing_load_scene(const char* file, OffingScene** scene);
/** Reads a scene from text. File names in it are relative to `folder`; NULL is the working folder. */
OffingStatus offing_parse_scene(const char* text, const char* folder, OffingScene** scene);
/** Reads a scene from text that a program made of values. It is offing_parse_scene(), but errors and warnings
 * name keys alone, because nobody sees the lines. */
OffingStatus offing_parse_values(const char* text, const char* folder, OffingScene** scene);
/** Frees the scene. Worlds and renderers made of it stay valid. */
void offing_free_scene(OffingScene* scene);

/** Wave spectra, one or many. */
typedef struct OffingSpectra OffingSpectra;

/** A wave spectrum. Energy is linear between the frequencies and zero outside them. */
typedef struct OffingSpectrum {
  size_t size;                  /**< sizeof(OffingSpectrum) */
  size_t frequency_count;       /**< 2 or more */
  size_t direction_count;       /**< 0: the scene gives the spreading */
  const double* frequencies_hz; /**< [frequency_count], above 0, increasing */
  const double* energy_m2phz;   /**< [frequency_count], variance density, m^2/Hz */
  const double* directions_rad; /**< [direction_count], of travel, from +x (east) toward +z (south) */
  const double* density;        /**< [frequency_count][direction_count], m^2/Hz/rad */
  double latitude_deg, longitude_deg, depth_m; /**< NaN: not known */
  const char* station;                         /**< name of the place; "": not known */
  const char* time_utc;                        /**< such as "2020-06-08T03:50Z"; "": not known */
} OffingSpectrum;

/** Reads all spectra of a file: NDBC, WAVEWATCH III, SWAN, Datawell, TRIAXYS, Octopus, Spotter or NetCDF,
 * plain or compressed with gzip. */
OffingStatus offing_read_spectra(const char* file, OffingSpectra** spectra);
/** Makes one spectrum from arrays, which are copied. With directions, at least two in any order, `density` is
 * read and `energy_m2phz` is not. Uneven directions, or those of a part of the circle, are resampled to 360
 * directions. Truncated Fourier series have negative densities. Then each frequency keeps its energy and its
 * first two circular moments, and takes the spreading of maximum entropy. A text of NULL or a depth of 0
 * means not known. */
OffingStatus offing_make_spectrum(const OffingSpectrum* spectrum, OffingSpectra** spectra);
/** Tabulates the spectrum of a scene's sea, without swells that are one wave, at these frequencies and at
 * `direction_count` evenly spaced directions. With 0 directions it has energies alone. */
OffingStatus offing_tabulate_spectrum(const OffingScene* scene, const double* frequencies_hz,
                                      size_t frequency_count, size_t direction_count,
                                      OffingSpectra** spectra);
/** The number of spectra; 0 for NULL. */
size_t offing_spectrum_count(const OffingSpectra* spectra);
/** Describes one spectrum. Its arrays and texts are valid until `spectra` is freed. */
OffingStatus offing_get_spectrum(const OffingSpectra* spectra, size_t index, OffingSpectrum* spectrum);
/** Scenes that use one of the spectra stay valid. */
void offing_free_spectra(OffingSpectra* spectra);
/** Gives the scene's sea this spectrum in place of its model or file. Worlds that were made before keep
 * theirs, and so do calls that other threads have begun. */
OffingStatus offing_set_spectrum(OffingScene* scene, const OffingSpectra* spectra, size_t index);

/** Parameters of a sea state, from the spectral moments m0, m1, m2. */
typedef struct OffingSeaState {
  size_t size;               /**< sizeof(OffingSeaState) */
  double hs_m;               /**< 4 sqrt(m0) */
  double tp_s;               /**< integral of E^4 df / integral of f E^4 df */
  double tm01_s, tm02_s;     /**< m0 / m1 and sqrt(m0 / m2) */
  double mean_direction_rad; /**< of travel, 0 to 2 pi */
  double mss;                /**< mean square slope */
  double peak_period_s;      /**< 1 / f where the density E(f) is largest */
  double peak_direction_rad; /**< of travel, of the waves at the peak period */
  double spread_rad;         /**< sqrt(2 (1 - r)), r the length of the mean direction vector */
} OffingSeaState;
/** The sea state of the spectrum of a scene's sea, without swells that are one wave. Scenes give a sea by
 * height and period: `[ocean] hs_m = 2.5, tp_s = 8`, and irregular swells: `[[ocean.swell]] hs_m = 1, tp_s =
 * 14`. */
OffingStatus offing_get_sea_state(const OffingScene* scene, OffingSeaState* state);

/** Statistics of a sea, as `offing ocean stats` prints them (docs/ocean.md). Directions are of travel, 0 to
 * 2 pi; mss is the mean square slope. */
typedef struct OffingSeaStatistics {
  size_t size; /**< sizeof(OffingSeaStatistics) */
  /** Of the spectrum, without swells, as from offing_get_sea_state(). */
  double asked_hs_m, asked_tp_s, asked_tm01_s, asked_tm02_s, asked_mean_direction_rad, asked_mss;
  /** Expected of the waves that the maps can hold and of swells. */
  double resolved_hs_m, resolved_tp_s, resolved_tm01_s, resolved_tm02_s, resolved_mean_direction_rad,
      resolved_mss;
  /** Measured on the surface, averaged over the seeds. */
  double hs_m, tp_s, tm01_s, tm02_s, mean_direction_rad, mss;
  double skewness, kurtosis; /**< measured, of heights at rest labels; 0 and 3 if Gaussian */
  double max_ka;             /**< measured, steepness k A exceeded by one wave in 90 */
  double folded_share;       /**< measured, share of the surface that folds over itself */
  /** Standard errors of measured from resolved values. */
  double hs_standard_error_m, tm02_standard_error_s, mean_direction_standard_error_rad;
  /** As in OffingSeaState: of the spectrum, expected of the maps, measured. */
  double asked_peak_period_s, asked_peak_direction_rad, asked_spread_rad;
  double resolved_peak_period_s, resolved_peak_direction_rad, resolved_spread_rad;
  double peak_period_s, peak_direction_rad, spread_rad;
  double peak_period_standard_error_s;
  /** Share of the sea that foam covers on average, asked for and measured. */
  double asked_foam_fraction, foam_fraction;
} OffingSeaStatistics;
/** Measures a scene's sea on its surface, averaged over seeds: `seeds` of them, 1 to 100000, counted up from
 * the scene's seed. The time is in proportion to `seeds`; start with 8. `progress` may be NULL. */
OffingStatus offing_measure_sea(const OffingDevice* device, const OffingScene* scene, int seeds,
                                const OffingProgress* progress, OffingSeaStatistics* statistics);

/** Makes the world of a scene at the scene's start. You may then close the device and free the scene. Returns
 * OFFING_BAD_INPUT for clouds that would take longer than 45 s, or than $OFFING_LONGEST_WAIT_S. */
OffingStatus offing_make_world(const OffingDevice* device, const OffingScene* scene, OffingWorld** world);
/** Settings of offing_make_world_with(). NULL and zeros are those of offing_make_world(). */
typedef struct OffingWorldOptions {
  size_t size;                    /**< sizeof(OffingWorldOptions) */
  const OffingProgress* progress; /**< may be NULL */
} OffingWorldOptions;
/** Makes a world as offing_make_world() does, with progress. The callback runs while clouds grow, but not
 * while terrain and sea are made. */
OffingStatus offing_make_world_with(const OffingDevice* device, const OffingScene* scene,
                                    const OffingWorldOptions* options, OffingWorld** world);
/** Frees the world and its memory on the device. */
void offing_free_world(OffingWorld* world);

/** Computes one frame: the world at this time, -1e8 to 1e8 s. Times may come in any order. All calls below
 * are about the last frame. */
OffingStatus offing_frame(OffingWorld* world, double time_s);
/** The time of the last frame, s; that of the scene's start before the first. */
OffingStatus offing_get_time(OffingWorld* world, double* time_s);

/** A point in the horizontal plane, where water is sampled. */
typedef struct OffingPoint {
  double x_m, z_m; /**< east and south of the origin, within 2e7 m */
} OffingPoint;

/** Settings of offing_sample(). NULL stands for zeros: velocity and pressure at the surface, all waves. */
typedef struct OffingQuery {
  double depth_m;          /**< of velocity and pressure, below the moving surface */
  double min_wavelength_m; /**< shorter waves are left out, as for a large hull */
} OffingQuery;

/** The water at a point. */
typedef struct OffingSample {
  float height_m;        /**< of the surface, above the mean sea level */
  float normal[3];       /**< unit normal of the surface, upward */
  float velocity_mps[3]; /**< of the water at the query's depth; rings of raindrops add nothing */
  float pressure_pa;     /**< at the query's depth, relative to the air */
  float residual_m; /**< horizontal distance of the sample from the point; large where the surface folds */
} OffingSample;

/** Samples the water at `count` points, where the moving surface meets their verticals: cascades, Gerstner
 * waves, rings of raindrops and wakes together, with the effect of shores. For acceleration and the expected
 * error call offing_sample_water(). */
OffingStatus offing_sample(OffingWorld* world, const OffingQuery* query, const OffingPoint* points,
                           size_t count, OffingSample* samples);

/** How offing_sample_water() finds the waves of the cascades at a point. Gerstner waves are exact in all. */
typedef enum OffingAccuracy {
  OFFING_ACCURACY_AUTOMATIC, /**< exact for up to 16 points, else maps */
  OFFING_ACCURACY_EXACT,     /**< the sum over all modes, for each point */
  OFFING_ACCURACY_MAPS,      /**< splines on fine maps, which are made once for each time */
  OFFING_ACCURACY_FRAME_MAPS /**< linear interpolation of the maps of offing_read(): the fastest. Short waves
                                  lose a quarter of their slopes, and the acceleration is 0. */
} OffingAccuracy;

/** Settings of offing_sample_water(). NULL stands for zeros: velocity and pressure at the surface, all waves.
 */
typedef struct OffingWaterQuery {
  size_t size;             /**< sizeof(OffingWaterQuery) */
  double depth_m;          /**< of velocity, pressure and acceleration, below the moving surface */
  double min_wavelength_m; /**< shorter waves are left out, as for a large hull */
  int is_surface_only; /**< 1: leaves out velocity, pressure and acceleration, which are 0 in samples then */
  int accuracy;        /**< an OffingAccuracy */
  int is_full;         /**< 1: offing_sample_water_on_device() writes full samples, of twelve floats */
} OffingWaterQuery;

/** Where offing_sample_water() writes, an array for each quantity. */
typedef struct OffingWater {
  size_t size;              /**< sizeof(OffingWater) */
  float* height_m;          /**< [count], as in OffingSample */
  float* normal;            /**< [count][3], as in OffingSample */
  float* velocity_mps;      /**< [count][3], of the water at the query's depth */
  float* pressure_pa;       /**< [count], at the query's depth, relative to the air */
  float* residual_m;        /**< [count], as in OffingSample */
  float* samples;           /**< [count][8], as offing_sample_water_on_device() writes them */
  float* acceleration_mps2; /**< [count][3], of the water at the query's depth */
  float* error_rms_m;  /**< [count], expected root mean square error of the height, without what residual_m
                          adds */
  float* full_samples; /**< [count][12], the eight of samples, acceleration and error_rms_m: the cheapest */
} OffingWater;

/** Samples the water as offing_sample() does, at points [count][2] of x and z in m. It is faster if you want
 * neither velocity nor pressure nor acceleration. */
OffingStatus offing_sample_water(OffingWorld* world, const OffingWaterQuery* query, const double* points_m,
                                 size_t count, const OffingWater* water);

/** Does the same with cl_mem buffers of the device's context: it enqueues commands, without a transfer or a
 * wait.
 *
 * `points` [count] has two int32 tiles (x, z) and two floats (x, z); a coordinate in m is 64 * tile + float.
 * `samples` [count] gets eight floats: height m, slopes dh/dx and dh/dz, residual m, velocity x, y, z m/s,
 * pressure Pa. With `is_full` of the query it gets four more: acceleration x, y, z m/s^2, and the expected
 * root mean square error of the height, m. */
OffingStatus offing_sample_water_on_device(OffingWorld* world, const OffingWaterQuery* query, void* points,
                                           size_t count, void* samples);

/** Maps of one cascade, a periodic patch of sea. The scene's Gerstner waves are not in them. "At rest labels"
 * means at the places where the water is at rest. */
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

/** The number of the sea's cascades, 1 to 4; 0 for NULL. */
int offing_cascade_count(const OffingWorld* world);
/** n, where a map has n x n values; 0 for NULL. */
int offing_map_size(const OffingWorld* world);
/** The side of a cascade's patch, m; 0 if there is no such cascade. */
double offing_patch_length_m(const OffingWorld* world, int cascade);
/** Reads a map: values [n][n], row = z, column = x, the first at label (0, 0). `count` must be n * n. */
OffingStatus offing_read(OffingWorld* world, int cascade, OffingField field, float* values, size_t count);
/** Reads several maps at once, which is faster: values[i] gets fields[i], each of `count` = n * n values. */
OffingStatus offing_read_fields(OffingWorld* world, int cascade, const OffingField* fields,
                                size_t field_count, float* const* values, size_t count);
/** Enqueues the copy of a map to a cl_mem of the device's context, without a transfer or a wait. The buffer
 * gets n * n floats from index `first` on. Foam and velocity cannot be copied so: use offing_read(). */
OffingStatus offing_copy_field(OffingWorld* world, int cascade, OffingField field, void* buffer,
                               size_t first);
/** Writes all single waves of the sea, as `offing ocean modes` does: NetCDF if the file's name ends in .nc,
 * else CSV. An existing file is replaced. The scene key ocean.modes_file reads it again. */
OffingStatus offing_write_modes(OffingWorld* world, const char* file);

/* Terrain. The north-west post of a map is at x = z = 0. Heights are those of the map. Results are in double
 * precision unless a call states its accuracy. */

/** How a file encodes heights. */
typedef enum OffingHeightEncoding {
  OFFING_HEIGHTS_PLAIN = 0, /**< heights in one band */
  OFFING_HEIGHTS_MAPBOX,    /**< 8-bit RGB: -10000 + 0.1 (65536 R + 256 G + B) m */
  OFFING_HEIGHTS_TERRARIUM  /**< 8-bit RGB: 256 R + G + B / 256 - 32768 m */
} OffingHeightEncoding;
/** The type of the samples in a file without a header. */
typedef enum OffingRawType {
  OFFING_RAW_BY_NAME = 0, /**< from the name: .r16 is unsigned 16-bit, .r32 float */
  OFFING_RAW_UNSIGNED_16,
  OFFING_RAW_SIGNED_16,
  OFFING_RAW_FLOAT_32
} OffingRawType;
/** The unit of horizontal coordinates. */
typedef enum OffingHorizontalUnit {
  OFFING_UNIT_OF_FILE = 0,
  OFFING_UNIT_METRE,
  OFFING_UNIT_DEGREE
} OffingHorizontalUnit;

/** How to read a height map. NULL and zeros leave each setting to the file. */
typedef struct OffingTerrainOptions {
  size_t size;                     /**< sizeof(OffingTerrainOptions) */
  double spacing_x_m, spacing_z_m; /**< between neighbouring posts */
  double vertical_scale;           /**< metres per unit of the file's heights; 0 stands for 1 */
  double offset_m;                 /**< added to the scaled height */
  const double* nodata;            /**< another value that marks voids, before scaling; may be NaN */
  const double* void_height_m;     /**< height of voids; NULL: filled from around */
  const char* reproject_to;        /**< system to resample to, in metres: "utm", "EPSG:32719" */
  int is_untrusted;                /**< 1: the file may only refer to files in and below its folder */
  int band;                        /**< counted from 1; 0: the first */
  OffingHeightEncoding encoding;
  OffingHorizontalUnit horizontal_unit; /**< for files without a coordinate system */
  const char* exr_channel;              /**< NULL: the only one, or one of height, Y, Z, R */
  int raw_columns, raw_rows;            /**< for files without a header (.r16, .r32, .raw, .bin) */
  OffingRawType raw_type;
  int is_raw_big_endian;
} OffingTerrainOptions;

/** Reads a height map and uploads it to the device. docs/terrain.md lists the formats. If nothing gives the
 * spacing of the posts, it is taken as 1 m, with a warning in the log. */
OffingStatus offing_open_terrain(const OffingDevice* device, const char* file,
                                 const OffingTerrainOptions* options, OffingTerrain** terrain);
/** Makes a terrain from heights [rows][columns] m, which are copied. Heights are finite and within +-1e6 m.
 * Row 0 is the north edge. There are at least 2 rows and 2 columns. */
OffingStatus offing_make_terrain(const OffingDevice* device, const float* heights_m, int columns, int rows,
                                 double spacing_x_m, double spacing_z_m, OffingTerrain** terrain);
/** Frees the terrain and its memory on the device. */
void offing_free_terrain(OffingTerrain* terrain);

/** What is known about a terrain. */
typedef struct OffingTerrainInfo {
  size_t size;                     /**< sizeof(OffingTerrainInfo) */
  int columns, rows;               /**< of posts */
  double spacing_x_m, spacing_z_m; /**< between neighbouring posts */
  double lowest_m, highest_m;      /**< of all posts, with filled voids */
  uint64_t void_posts;             /**< posts without a height in the file */
  /** Post (column, row) is at (origin_x + column * step_x, origin_y + row * step_y) in the map's coordinate
   * system and its units. step_y is negative if rows go south. NaN: not known. */
  double origin_x, origin_y, step_x, step_y;
  double centre_latitude_deg, centre_longitude_deg; /**< WGS 84; NaN: not known */
  const char* coordinate_system;     /**< name; "": not known; valid until the terrain is freed */
  const char* coordinate_system_wkt; /**< WKT; "": not known; valid until the terrain is freed */
  const char* format;                /**< of the file, "GeoTIFF"; valid until the terrain is freed */
  int is_spacing_assumed;            /**< 1: nothing gives the spacing; 1 m is assumed */
} OffingTerrainInfo;
/** Describes the terrain. */
OffingStatus offing_get_terrain_info(OffingTerrain* terrain, OffingTerrainInfo* info);

/** Reads all posts. Heights [rows][columns] are in m, with voids filled. is_void [rows][columns] is 1 for
 * posts without a height in the file. Either may be NULL. `count` must be rows * columns. */
OffingStatus offing_read_terrain(OffingTerrain* terrain, float* heights_m, uint8_t* is_void, size_t count);

/** Converts places [count][2] of a coordinate system to x and z in m on the terrain. `system` is "map" (the
 * map's own coordinates), "lonlat" (degrees on WGS 84), "local" (m from the north-west post), or a name such
 * as "EPSG:32719". East comes before north in every system, and so longitude before latitude. Places beyond
 * an edge by less than 1e-6 of a post are on it; NaN: the map's system has no such place. The terrain must be
 * a file that says where it lies, except for "local". `places` and `places_m` may be the same array. */
OffingStatus offing_places_to_terrain(OffingTerrain* terrain, const char* system, const double* places,
                                      double* places_m, size_t count);
/** Converts x and z in m on the terrain [count][2] to places of a coordinate system, the other way. */
OffingStatus offing_places_from_terrain(OffingTerrain* terrain, const char* system, const double* places_m,
                                        double* places, size_t count);

/** Settings of terrain queries. NULL and zeros mean normals of patches and no curvature of the Earth. */
typedef struct OffingTerrainQuery {
  size_t size;            /**< sizeof(OffingTerrainQuery) */
  int has_smooth_normals; /**< 1: interpolated from the posts around, without creases; 0: of the patch */
  /** At a distance d in plan from the start of a ray or line of sight, the ground is lower by
   * (1 - refraction) d^2 / (2 earth_radius_m). 0: a flat Earth. The Earth's mean radius is 6371008.8 m. */
  double earth_radius_m;
  double refraction; /**< refraction coefficient, 0 to 1; 0.13 is usual near the ground */
} OffingTerrainQuery;

/** Where offing_sample_terrain() writes. */
typedef struct OffingTerrainSamples {
  size_t size;          /**< sizeof(OffingTerrainSamples) */
  double* height_m;     /**< [count]; NaN beyond the map */
  double* normal;       /**< [count][3], unit; NaN beyond the map */
  uint8_t* is_measured; /**< [count]; 0 beyond the map, and where filled voids share in the height */
} OffingTerrainSamples;
/** Samples the terrain at points [count][2] of x and z in m. */
OffingStatus offing_sample_terrain(OffingTerrain* terrain, const OffingTerrainQuery* query,
                                   const double* points_m, size_t count, const OffingTerrainSamples* samples);

/** What a ray hit. */
typedef enum OffingHitKind {
  OFFING_HIT_NONE = 0,
  OFFING_HIT_SURFACE, /**< the surface, from above */
  OFFING_HIT_SIDE,    /**< the map's edge, below the surface: the terrain is solid */
  OFFING_HIT_INSIDE   /**< nothing: the ray starts on or below the surface */
} OffingHitKind;

/** Where offing_cast_rays() writes. */
typedef struct OffingHits {
  size_t size;        /**< sizeof(OffingHits) */
  double* distance_m; /**< [count], along the ray; infinity: nothing hit */
  double* point_m;    /**< [count][3], y in heights of the map; NaN: nothing hit */
  float* normal;      /**< [count][3], unit; NaN: nothing hit */
  uint8_t* kind;      /**< [count], an OffingHitKind */
} OffingHits;
/** Finds what rays hit first. They go from origins [count][3] m along unit directions [count][3], at most
 * limits_m [count]; NULL: no limits. Origins are within 2^22 cells of the map.
 *
 * The device casts the rays. A hit is within 1e-3 cells of the surface, and within 2^-23 of the ray's length
 * over the map. Rays that pass the ground within 1e-4 cells may hit or miss it. */
OffingStatus offing_cast_rays(OffingTerrain* terrain, const OffingTerrainQuery* query,
                              const double* origins_m, const double* directions, const double* limits_m,
                              size_t count, const OffingHits* hits);

/** Where offing_trace_sight_lines() writes. */
typedef struct OffingSightLines {
  size_t size;         /**< sizeof(OffingSightLines) */
  uint8_t* is_visible; /**< [count], 1 or 0 */
  double* distance_m;  /**< [count], from end to end */
  double* hidden_at_m; /**< [count], from the first end to the ground that hides the other; NaN: visible */
  double* hidden_by_m; /**< [count][3], the place of that ground; NaN: visible */
} OffingSightLines;
/** Tests lines of sight between two ends. Each end of [count][3] is x, z and the height above ground, in m.
 * Both ends are on the map, at different places, and may lie on the ground: ground within 2e-3 cells of an
 * end hides nothing. The accuracy is that of offing_cast_rays(). */
OffingStatus offing_trace_sight_lines(OffingTerrain* terrain, const OffingTerrainQuery* query,
                                      const double* from_m, const double* to_m, size_t count,
                                      const OffingSightLines* lines);

/** Settings of a viewshed. */
typedef struct OffingViewshed {
  size_t size;                       /**< sizeof(OffingViewshed) */
  double observer_x_m, observer_z_m; /**< on the map */
  double observer_height_m;          /**< of the eye above ground, 0 to 1e6 */
  double target_height_m;            /**< of targets above ground, 0 to 1e6 */
  double radius_m;                   /**< in plan; nothing beyond is seen; 0: no limit */
  double earth_radius_m, refraction; /**< as in OffingTerrainQuery */
  double azimuth_from_rad;           /**< where the sector begins, clockwise from north, -2 pi to 2 pi */
  double azimuth_to_rad;             /**< where it ends, clockwise from its start; both 0: the whole turn */
  double lowest_rad, highest_rad;    /**< of lines of sight, up from level, within +-pi/2; both 0: all */
} OffingViewshed;
/** Computes which posts an observer sees: seen [rows][columns] is 255 for visible posts, 0 for hidden ones.
 * Filled voids count as posts. `count` must be rows * columns. Lines of sight are tested against the surface
 * between posts. For 1e-5 of the posts, rounding may give another result than double precision. */
OffingStatus offing_compute_viewshed(OffingTerrain* terrain, const OffingViewshed* viewshed, uint8_t* seen,
                                     size_t count);

/** Several observers of a terrain. NULL stands for what the OffingViewshed beside it says. */
typedef struct OffingObservers {
  size_t size;                     /**< sizeof(OffingObservers) */
  size_t count;                    /**< of observers, at most 65000 */
  const double* points_m;          /**< [count][2], x and z on the map */
  const double* observer_height_m; /**< [count] or NULL */
  const double* target_height_m;   /**< [count] or NULL */
  const double* radius_m;          /**< [count] or NULL; 0: no limit */
  const double* azimuth_rad;       /**< [count][2] or NULL, as in OffingViewshed; both 0: the whole turn */
  const double* elevation_rad;     /**< [count][2] or NULL, as in OffingViewshed; both 0: all */
} OffingObservers;
/** Where offing_count_viewsheds() writes. */
typedef struct OffingSightCounts {
  size_t size;             /**< sizeof(OffingSightCounts) */
  uint16_t* counts;        /**< [rows][columns], observers that see the post */
  uint8_t* is_reached;     /**< [rows][columns], 1 within the radius and angles of any observer, else 0 */
  uint64_t* seen_posts;    /**< [observers], posts that each sees */
  uint64_t* reached_posts; /**< [observers], posts within its radius and angles */
  uint64_t* only_posts;    /**< [observers], posts that no other observer sees */
  size_t best_count;       /**< observers to choose that together see the most, at most all; 0: none */
  size_t* best;            /**< [best_count], indices of observers; each adds the most to those before it */
  uint64_t* best_posts;    /**< [best_count], posts seen by the first, the first two, ... */
  int* is_best_exhaustive; /**< 1: all choices were compared; 0: the next best one was added each time */
} OffingSightCounts;
/** Counts which posts several observers see. An observer alone sees what offing_compute_viewshed() writes.
 * `viewshed` has what the observers share; its own place is not used. `count` must be rows * columns.
 * `progress` may be NULL. `only_posts` and `best` take a bit for each post and observer, 8 GiB at most. */
OffingStatus offing_count_viewsheds(OffingTerrain* terrain, const OffingViewshed* viewshed,
                                    const OffingObservers* observers, const OffingSightCounts* counts,
                                    size_t count, const OffingProgress* progress);

/** What is known about the points of a GIS file. Texts are valid until the points are freed. */
typedef struct OffingPointFileInfo {
  size_t size;                   /**< sizeof(OffingPointFileInfo) */
  size_t count;                  /**< of points */
  size_t attribute_count;        /**< of each point */
  const char* coordinate_system; /**< as offing_places_to_terrain() takes it; "" if the layer names none */
  const char* layer;             /**< its name */
} OffingPointFileInfo;
/** Reads the points of a GeoPackage (.gpkg) or GeoJSON (.geojson, .json). NULL or "": the layer,
 * if there is only one. Fails if the layer has no points, or other geometry. */
OffingStatus offing_open_point_file(const char* file, const char* layer, OffingPointFile** points);
/** Frees the points. */
void offing_free_point_file(OffingPointFile* points);
/** Writes what is known about the points. */
OffingStatus offing_get_point_file_info(const OffingPointFile* points, OffingPointFileInfo* info);
/** The name of an attribute; "" if there is none. Valid until the points are freed. */
const char* offing_point_attribute_name(const OffingPointFile* points, size_t attribute);
/** Reads the places [count][2] of all points, east before north, in the units of their coordinate system, and
 * their heights z [count], as in the file; NaN: no height. Either may be NULL. `count` must be that of the
 * points. offing_places_to_terrain() converts the places. */
OffingStatus offing_read_point_file(const OffingPointFile* points, double* places, double* z, size_t count);
/** Reads an attribute of all points as numbers [count]; NaN: none, or a text. */
OffingStatus offing_read_point_attribute(const OffingPointFile* points, const char* name, double* values,
                                         size_t count);

/** Water in a basin, as offing_fill_lake() finds it. */
typedef struct OffingLake {
  size_t size;                 /**< sizeof(OffingLake) */
  double level_m;              /**< height of the water */
  double spill_level_m;        /**< above this level water runs off the map */
  double spill_x_m, spill_z_m; /**< place where it does */
  double area_m2;              /**< of the surface */
  double volume_m3, greatest_depth_m;
  uint64_t outline_count; /**< number of places of the outline: room to give to the next call */
} OffingLake;
/** Fills the basin around (x_m, z_m) with water up to a level; with NULL, up to its spill level. `lake`
 * describes the result.
 *
 * depth_m [count] gets the depth at each post, 0 outside the lake; count is rows * columns, or 0 with NULL.
 * outline_m [outline_count][2] gets x and z of the shore in m: closed rings, the outer one first, then
 * islands. A pair of NaN separates rings. To ask only for the number of places, pass NULL and 0. */
OffingStatus offing_fill_lake(OffingTerrain* terrain, double x_m, double z_m, const double* level_m,
                              OffingLake* lake, float* depth_m, size_t count, double* outline_m,
                              size_t outline_count);

/** Settings of sky views; zeros are the usual ones. */
typedef struct OffingSkyView {
  size_t size;                       /**< sizeof(OffingSkyView) */
  int azimuths;                      /**< in which horizons are found, from the map's north; 0: 64 */
  double earth_radius_m, refraction; /**< as in OffingTerrainQuery */
} OffingSkyView;
/** Computes the sky-view factor of each post, factors [rows][columns], and its horizons, rises
 * [azimuths][rows][columns]: tangents of the angles up from level, never below 0. Azimuths go clockwise from
 * north. Either may be NULL. A factor is the light of an evenly bright sky on the ground as it slopes, as a
 * share of that on level ground in the open. Horizons are up to 0.001 too low. `sky` may be NULL. `count`
 * must be rows * columns. */
OffingStatus offing_compute_sky_view(OffingTerrain* terrain, const OffingSkyView* sky, float* factors,
                                     float* rises, size_t count);

/** When the sun is looked at, and through which air. */
typedef struct OffingSunHours {
  size_t size;                        /**< sizeof(OffingSunHours) */
  int64_t from_s, to_s;               /**< since 1970-01-01T00:00Z, within 1900 to 2100 */
  int64_t step_s;                     /**< 0: 3600; at most 100000 steps */
  double turbidity;                   /**< of Linke, 1 to 20; 0: 3 */
  int has_place;                      /**< 1: the place below is that of the whole map, instead of its own */
  double latitude_rad, longitude_rad; /**< WGS 84, north and east positive */
  int azimuths;                       /**< as in OffingSkyView */
  double earth_radius_m, refraction;  /**< as in OffingTerrainQuery */
} OffingSunHours;
/** Computes the hours of sun of each post, and the direct sunlight there under a clear sky; both
 * [rows][columns]. The latter is in kWh for each square metre of ground as it slopes. docs/terrain.md has the
 * definitions. `count` must be rows * columns. */
OffingStatus offing_compute_sun_hours(OffingTerrain* terrain, const OffingSunHours* when, float* hours,
                                      float* energy_kwh, size_t count);

/* Floating bodies of a world: the [[body]] sections of its scene, in order. Body axes are x forward, y up,
 * z to starboard, with the origin in the mass centre. */

/** The number of bodies; 0 for NULL. */
size_t offing_body_count(const OffingWorld* world);
/** A body's name in its scene; "" if it has none. Valid until the world is freed. */
const char* offing_body_name(const OffingWorld* world, size_t body);

/** Where offing_read_body_poses() writes. */
typedef struct OffingBodyPoses {
  size_t size;           /**< sizeof(OffingBodyPoses) */
  double* mass_centre_m; /**< [count][3], y above the water plane */
  double* turn;          /**< [count][4], unit quaternion w, x, y, z from body to world axes */
  double* velocity_mps;  /**< [count][3], of the mass centre, in world axes */
  double* spin_radps;    /**< [count][3], in body axes */
  double* displaced_m3;  /**< [count], volume of displaced water, one sub-step before */
} OffingBodyPoses;
/** Reads the poses of all bodies at the last frame. `count` must be offing_body_count(). Bodies are simulated
 * in sub-steps of 1/120 s, and poses are interpolated between states 1/30 s apart. They do not depend on the
 * frames that you asked for before. */
OffingStatus offing_read_body_poses(OffingWorld* world, size_t count, const OffingBodyPoses* poses);

/** Kinds of forces on bodies. */
typedef enum OffingForceKind {
  OFFING_FORCE_PRESSURE = 0,   /**< pressure of the water below its moving surface */
  OFFING_FORCE_DRAG = 1,       /**< friction and drag of the water, and lift of a hull that runs ahead */
  OFFING_FORCE_RADIATION = 2,  /**< waves that the hull has made */
  OFFING_FORCE_EXCITATION = 3, /**< waves, besides the pressure below their surface */
  OFFING_FORCE_PROPELLER = 4,
  OFFING_FORCE_RUDDER = 5,
  OFFING_FORCE_GRAVITY = 6,
  OFFING_FORCE_WIND = 7,    /**< wind on the dry part of the hull */
  OFFING_FORCE_MOORING = 8, /**< mooring lines */
  OFFING_FORCE_KINDS = 9
} OffingForceKind;
/** "pressure", "drag" and so on; "" for other numbers. */
const char* offing_body_force_name(int kind);

/** Where offing_read_body_forces() writes. Forces and moments are in world axes, moments about the mass
 * centre. `forces` has all kinds. */
typedef struct OffingBodyForces {
  size_t size;               /**< sizeof(OffingBodyForces) */
  double* time_s;            /**< [1], the end of the sub-step */
  float* pressure_n;         /**< [count][3], force of pressure */
  float* pressure_moment_nm; /**< [count][3] */
  float* drag_n;             /**< [count][3], force of friction and drag */
  float* drag_moment_nm;     /**< [count][3] */
  float* displaced_m3;       /**< [count], volume of displaced water */
  float* wetted_m2;          /**< [count], wetted area of the hull */
  float* forces; /**< [count][OFFING_FORCE_KINDS][6], of each kind: force x, y, z N, moment x, y, z N m */
} OffingBodyForces;
/** Reads the forces on all bodies in the last simulated sub-step. Bodies are simulated ahead of
 * frames: `time_s` is up to 0.14 s after the latest frame so far. `count` must be offing_body_count(). */
OffingStatus offing_read_body_forces(OffingWorld* world, size_t count, const OffingBodyForces* forces);

/* Clouds of a world at its last frame. Without clouds there are no particles, and pictures of clouds are
 * empty. */

/** The number of clouds: those of [[cloud]] in order, then those of layers. 0 for NULL. */
size_t offing_cloud_count(const OffingWorld* world);
/** The number of particles of all clouds; 0 for NULL. */
size_t offing_cloud_particle_count(const OffingWorld* world);

/** Where offing_read_cloud_particles() writes. */
typedef struct OffingCloudParticles {
  size_t size;            /**< sizeof(OffingCloudParticles) */
  double* place_m;        /**< [count][3], centres, to 1e-3 m within 8 km of the sky's origin */
  float* radius_m;        /**< [count] */
  float* optical_mass_m2; /**< [count], extinction (1/m) integrated over the volume */
  float* albedo;          /**< [count][3], single scattering albedo, linear Rec.709, 0 to 1 */
  uint32_t* cloud;        /**< [count], index of its cloud */
  uint32_t* id;           /**< [count], unique within its cloud, the same in every frame */
} OffingCloudParticles;
/** Reads the particles of all clouds. `count` must be offing_cloud_particle_count(). */
OffingStatus offing_read_cloud_particles(OffingWorld* world, size_t count,
                                         const OffingCloudParticles* particles);

/** Samples the extinction of the clouds at points [count][3] m: extinction_per_m [count], 1/m. The particles
 * are rasterised to a grid with cells of cell_m, 0.001 to 1e5 m, which keeps their optical mass. Values
 * between cell centres are trilinear. A particle smaller than a cell fills one. Calls about the same frame
 * with the same cell_m share the grid. */
OffingStatus offing_sample_clouds(OffingWorld* world, double cell_m, const double* points_m, size_t count,
                                  double* extinction_per_m);

/** A camera. */
typedef struct OffingCamera {
  size_t size;                       /**< sizeof(OffingCamera) */
  double eye_m[3];                   /**< position in the world */
  double yaw_rad;                    /**< 0 along -z (north), growing toward +x (east) */
  double pitch_rad;                  /**< upward, -pi/2 to pi/2 */
  double roll_rad;                   /**< the camera turns clockwise */
  double vertical_field_of_view_rad; /**< above 0, below pi */
  int width_px, height_px;           /**< of the picture, 1 to 16384 */
} OffingCamera;
/** The scene's camera at the last frame. */
OffingStatus offing_get_camera(OffingWorld* world, OffingCamera* camera);

/** Draws the clouds alone as a camera sees them. Row 0 is at the top. `count` must be width * height.
 *
 * rgba_kcdpm2 [height][width][4] has premultiplied light, linear Rec.709 in kcd/m^2, and opacity 0 to 1.
 * distance_m [height][width] has the mean distance of that light, 0 where there is none. Either may be NULL.
 * `offing-view --compare-reference` compares such pictures with path tracing. */
OffingStatus offing_draw_clouds(OffingWorld* world, const OffingCamera* camera, float* rgba_kcdpm2,
                                float* distance_m, size_t count);

/* Meshes of a world, the [[mesh]] sections of its scene in order, and their highlights. */

/** The number of meshes; 0 for NULL. */
size_t offing_mesh_count(const OffingWorld* world);
/** A mesh's name in its scene; "" if it has none. Valid until the world is freed. */
const char* offing_mesh_name(const OffingWorld* world, size_t mesh);

/** The pose of a mesh: world = turn * mesh + position_m. */
typedef struct OffingMeshPose {
  size_t size;          /**< sizeof(OffingMeshPose) */
  double position_m[3]; /**< of the mesh's origin, in the world */
  double turn[4];       /**< unit quaternion w, x, y, z from mesh to world axes */
} OffingMeshPose;
/** The pose of a mesh at the last frame. */
OffingStatus offing_get_mesh_pose(OffingWorld* world, size_t mesh, OffingMeshPose* pose);

/** The texture of a highlight's projector. */
typedef enum OffingTexture {
  OFFING_TEXTURE_DOT = 0,
  OFFING_TEXTURE_WINDOW,
  OFFING_TEXTURE_STAR,
  OFFING_TEXTURE_RING,
  OFFING_TEXTURE_STREAK,
  OFFING_TEXTURE_HEART,
  OFFING_TEXTURE_IMAGE,     /**< the image of its rule */
  OFFING_TEXTURE_NORMAL_MAP /**< the normal map of its rule */
} OffingTexture;

/** Where offing_read_highlights() writes. A projector is a box that casts its texture along -normal onto its
 * mesh. Texture coordinates go from -1 to 1 along right over the width and along up over the height. Vectors
 * are in mesh axes (offing_get_mesh_pose()). */
typedef struct OffingHighlights {
  size_t size;        /**< sizeof(OffingHighlights) */
  uint64_t* id;       /**< [count], constant in a sequence; copies of a highlight share it */
  int32_t* rule;      /**< [count], index of its [[mesh.highlight]]; -1: none */
  int32_t* copy;      /**< [count], index of the copy, if its rule splits it */
  int32_t* light;     /**< [count], index of its [[light]]; one past the last: the sun; -1: a pin */
  double* position_m; /**< [count][3], centre of the box */
  double* right;      /**< [count][3], unit; right x up = normal */
  double* up;         /**< [count][3], unit */
  double* normal;     /**< [count][3], unit, out of the surface */
  double* width_m;    /**< [count], full, along right */
  double* height_m;   /**< [count], full, along up */
  double* opacity;    /**< [count], above 0, at most 1 */
  int32_t* texture;   /**< [count], an OffingTexture */
  double* softness;   /**< [count], of the shape's edge, in half widths */
  double* colour;     /**< [count][3], linear Rec.709, a factor of the light's colour */
} OffingHighlights;
/** Finds the highlights of all meshes at the last frame, for the scene's camera. `first_s` is the time of the
 * sequence's first frame, within 7200 s before the last frame. The highlights depend on these two times
 * alone.
 *
 * Frames of one sequence share a history, so that highlights keep their ids and do not jump. The history is
 * simulated: the first call takes time in proportion to the length of the sequence. */
OffingStatus offing_find_highlights(OffingWorld* world, double first_s);
/** The number of highlights of a mesh by the last offing_find_highlights(); 0 before the first. */
OffingStatus offing_count_highlights(OffingWorld* world, size_t mesh, size_t* count);
/** Reads the projectors of a mesh's highlights. `count` must be that of offing_count_highlights(). */
OffingStatus offing_read_highlights(OffingWorld* world, size_t mesh, size_t count,
                                    const OffingHighlights* highlights);

/* Meshes of files and arrays. The corners of a triangle are anticlockwise seen from outside. Triangles
 * without an area, repeated triangles, borders and edges of three triangles are allowed. */

/** How to read a mesh. NULL stands for zeros. */
typedef struct OffingMeshOptions {
  size_t size;      /**< sizeof(OffingMeshOptions) */
  int is_untrusted; /**< 1: the file may only refer to files in and below its folder */
} OffingMeshOptions;
/** Reads a mesh: OBJ, PLY, OFF, STL or glTF. Vertices and triangles are in the order of the file. Polygons
 * become triangles. Corners of an STL at the same place become one vertex. If parts of the file are left
 * out, the log has a warning. */
OffingStatus offing_open_mesh(const char* file, const OffingMeshOptions* options, OffingMesh** mesh);
/** Makes a mesh from vertices [vertex_count][3] m, finite and within +-1e30 m, and at least one triangle.
 * Triangles [triangle_count][3] are indices of vertices from 0 on. Both arrays are copied. */
OffingStatus offing_make_mesh(const double* vertices_m, size_t vertex_count, const uint32_t* triangles,
                              size_t triangle_count, OffingMesh** mesh);
/** Frees the mesh. */
void offing_free_mesh(OffingMesh* mesh);

/** What is known about a mesh. */
typedef struct OffingMeshInfo {
  size_t size; /**< sizeof(OffingMeshInfo) */
  size_t vertex_count, triangle_count;
  double lowest_m[3], highest_m[3]; /**< the box around all vertices */
  const char* format; /**< of the file, such as "OBJ"; "" for arrays; valid until the mesh is freed */
} OffingMeshInfo;
/** Describes the mesh. */
OffingStatus offing_get_mesh_info(const OffingMesh* mesh, OffingMeshInfo* info);
/** Reads vertices [vertex_count][3] m and triangles [triangle_count][3]. Either may be NULL, with a count of
 * 0. Other counts must be those of offing_get_mesh_info(). */
OffingStatus offing_read_mesh(const OffingMesh* mesh, double* vertices_m, size_t vertex_count,
                              uint32_t* triangles, size_t triangle_count);
/** Writes a .ply, .obj, .off or .stl file, by its name. .ply and .obj keep the normals of the file that was
 * read. If the file exists and `replace` is 0, the call returns OFFING_BAD_INPUT and keeps it. */
OffingStatus offing_save_mesh(const OffingMesh* mesh, const char* file, int replace);

/** Settings of offing_compute_curvatures(). NULL and zeros mean 3 rounds. */
typedef struct OffingCurvatureOptions {
  size_t size; /**< sizeof(OffingCurvatureOptions) */
  int rounds;  /**< averages with neighbours, 1 to 1000; more suit a noisy surface */
} OffingCurvatureOptions;
/** Where offing_compute_curvatures() writes. Curvatures are positive where the surface is convex: both are
 * 1/r on a sphere of radius r. The sign of a direction has no meaning. Curvatures, vectors and confidence are
 * 0 at vertices without a triangle that has an area. */
typedef struct OffingCurvatures {
  size_t size;         /**< sizeof(OffingCurvatures) */
  double* k_max_per_m; /**< [count], the largest curvature, 1/m */
  double* k_min_per_m; /**< [count], the smallest, 1/m */
  double* e_max;       /**< [count][3], unit direction of the largest */
  double* e_min;       /**< [count][3], unit direction of the smallest */
  double* normal;      /**< [count][3], unit, outward: e_max x e_min */
  double* area_m2;     /**< [count], a third of the area of the triangles around */
  double* confidence;  /**< [count], 0 to 1, of directions; near 0 on spheres */
} OffingCurvatures;
/** Computes curvatures at all vertices. `count` must be the mesh's vertex_count. Vertices at the same place
 * count as one. Angles at edges are averaged with those of neighbours, as by the method `diffused` of
 * `offing-mesh curvature`, on the device in single precision.
 *
 * The table has measured errors with 3 rounds, mean and largest. Errors of curvatures are in % of the larger
 * curvature at a vertex. Errors of e_max are at vertices where the curvatures differ by a tenth or more. The
 * meshes are icospheres. Ellipsoids are stretched to half axes of 1 : 0.75 : 0.5. "Moved" vertices are moved
 * along the surface by up to a quarter of an edge.
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

/** Draws pictures of a scene. It has a world of its own. */
typedef struct OffingRenderer OffingRenderer;

/** Size and time of a picture, and where offing_render() writes it. */
typedef struct OffingPicture {
  size_t size;             /**< sizeof(OffingPicture) */
  int width_px, height_px; /**< 1 to 16384 */
  double time_s;           /**< -1e8 to 1e8; times may come in any order */
  unsigned char* rgb;      /**< [height][width][3], sRGB, row 0 at the top */
  float* light;            /**< [height][width][3], linear Rec.709 in kcd/m^2, row 0 at the top */
} OffingPicture;

/** Makes a renderer. It needs OpenGL but no display, and returns OFFING_NO_DEVICE without OpenGL. */
OffingStatus offing_make_renderer(const OffingDevice* device, const OffingScene* scene,
                                  OffingRenderer** renderer);
/** Draws what the scene's camera sees, as `offing-view --headless` does. */
OffingStatus offing_render(OffingRenderer* renderer, const OffingPicture* picture);
/** Frees the renderer with its world. */
void offing_free_renderer(OffingRenderer* renderer);

#ifdef __cplusplus
}
#endif

#endif
