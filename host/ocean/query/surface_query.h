#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <span>
#include <variant>
#include <vector>

#include "host/ocean/query/shoals.h"
#include "host/ocean/query/surface_instant.h"
#include "host/ocean/query/water_query.h"
#include "host/ocean/surface/cascades.h"
#include "host/ocean/surface/gerstner_waves.h"
#include "host/ocean/wakes/wake_maps.h"
#include "host/ocl/buffer.h"
#include "host/ocl/kernel.h"
#include "host/ocl/tuning.h"
#include "kernels/shared/gerstner_params.h"

namespace offing::ocean {

/// Where a query reads the waves of the cascades, each [cascades] of something.
struct FrameMaps {
  const ocl::Buffer<float>& displacement;  ///< [n][n] float4 of SurfaceMaps
  const ocl::Buffer<float>& gradient;
  const ocl::Buffer<float>* flow;  ///< that of VelocityMap at the query's depth; none: not asked for
};
/// Maps made for queries, read by splines.
struct SplineMaps {
  const ocl::Buffer<float>& map;  ///< of QueryMaps
  int map_fields;
  std::span<const float> scales;  ///< [QUERY_MAP_FIELDS]
};
/// The modes, which a query sums.
struct ModeSums {
  const ocl::Buffer<float>& fields;  ///< of ModeFields
  int columns;                       ///< of WaveModes
};

/// A sea on a device at one time, as a query reads it.
struct QueriedSea {
  std::variant<FrameMaps, SplineMaps, ModeSums> source;
  std::span<const Cascade> cascades;
  int size = 0;              ///< n, or rows of the modes
  double error_rms_m = 0.0;  ///< expected of heights
  const GerstnerSea& gerstner_waves;
  const WakeMaps& wakes;
  const Shoals* shoals = nullptr;  ///< none: the sea is open everywhere
  Dispersion dispersion = {};
  double time_s = 0.0;
};

/// That sea in host memory; of a frame's maps.
SurfaceInstant read_instant(const QueriedSea& sea, const WaterQuery& query);

/// Answers for points of the world on a device (ocean/surface_query.cl).
class SurfaceQuery {
 public:
  explicit SurfaceQuery(const ocl::Device& device);

  /// Enqueues the samples of the first `count` points. Waits for the query before where the waves have
  /// changed since, or rings run; otherwise time alone is passed on.
  void sample(const QueriedSea& sea, const WaterQuery& query, const ocl::Buffer<SurfaceQueryPoint>& points,
              std::size_t count, ocl::Buffer<WaterSample>& samples);
  /// The same with the first floats of each sample alone.
  void sample(const QueriedSea& sea, const WaterQuery& query, const ocl::Buffer<SurfaceQueryPoint>& points,
              std::size_t count, ocl::Buffer<FirstWaterFloats>& samples);
  /// The same, and how far waves have moved the water sideways.
  void sample(const QueriedSea& sea, const WaterQuery& query, const ocl::Buffer<SurfaceQueryPoint>& points,
              std::size_t count, ocl::Buffer<ShiftedWaterSample>& samples);

  /// The same from and to host memory, part by part; waits.
  void sample(const QueriedSea& sea, const WaterQuery& query, std::span<const WaterPoint> points,
              const TakeSamples& take);

 private:
  void upload(const QueriedSea& sea, const WaterQuery& query, int sample_floats);
  template <class Sample>
  void enqueue(const QueriedSea& sea, const WaterQuery& query, const ocl::Buffer<SurfaceQueryPoint>& points,
               std::size_t count, ocl::Buffer<Sample>& samples);
  /// Made at first use.
  const ocl::Kernel& kernel_for(const QueriedSea& sea);

  ocl::Device device_;
  ocl::KernelTuning tuning_, sum_tuning_;
  std::map<std::array<int, 3>, ocl::Kernel> kernels_;  // by source, fields of its map, and shoals
  // As they are on the device.
  std::vector<SurfaceQueryWave> waves_;
  std::vector<GerstnerRingInTile> rings_;
  std::vector<SurfaceQueryParams> params_;
  ocl::Buffer<SurfaceQueryWave> waves_buffer_;
  ocl::Buffer<GerstnerRingInTile> rings_buffer_;
  ocl::Buffer<SurfaceQueryParams> params_buffer_;
  std::vector<SurfaceQueryPoint> packed_points_;
  ocl::Buffer<SurfaceQueryPoint> points_;
  ocl::Buffer<WaterSample> samples_;
};

}  // namespace offing::ocean
