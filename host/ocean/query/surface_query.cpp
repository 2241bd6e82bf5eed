#include "host/ocean/query/surface_query.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "host/ocean/query/mode_fields.h"
#include "host/ocean/spectrum/dispersion.h"
#include "host/ocean/surface/device_gerstner_waves.h"
#include "host/ocean/surface/wave_clock.h"
#include "host/ocl/program.h"

namespace offing::ocean {
namespace {

constexpr double tile_m = SURFACE_QUERY_TILE_M;
// Points that are on the device at a time: 48 MB with their samples.
constexpr std::size_t most_points = std::size_t{1} << 20;

std::int32_t device_phase(double turns) {
  return std::bit_cast<std::int32_t>(device_turns(turns));
}

/// A wave's turns from tile to tile in 2^-32 of one, modulo a whole one.
struct TileStep {
  std::int32_t whole;
  float rest;
};

TileStep tile_step(double turns_perm) {
  const double steps = turns_perm * tile_m * 0x1p32;
  const std::int64_t whole = std::llround(steps);
  return {.whole = std::bit_cast<std::int32_t>(static_cast<std::uint32_t>(whole)),
          .rest = static_cast<float>(steps - static_cast<double>(whole))};
}

/// What a wave of unit phase does at a depth, as GerstnerInstant has it.
struct Flow {
  double along_mps, up_mps, head_m;
};

Flow flow_of(const GerstnerWave& wave, double omega_radps, double depth_m, double water_depth_m) {
  const double k = wave.wavenumber_radpm;
  const double above_bed = std::exp(-2.0 * k * (water_depth_m - depth_m));
  const double at_bed = std::exp(-2.0 * k * water_depth_m);
  const double attenuated_m = wave.amplitude_m * std::exp(-k * depth_m);
  const double speed_mps = omega_radps * attenuated_m / (1.0 - at_bed);
  return {.along_mps = speed_mps * (1.0 + above_bed),
          .up_mps = speed_mps * (1.0 - above_bed),
          .head_m = attenuated_m * (1.0 + above_bed) / (1.0 + at_bed)};
}

/// `bands`: of waves that shoal; none where they do not.
std::vector<SurfaceQueryWave> pack_waves(const GerstnerSea& sea, const WaterQuery& query,
                                         const WaveClock& clock, const SeaBands* bands) {
  const double scale = horizontal_scale(sea).scale;
  std::vector<SurfaceQueryWave> packed;
  for (const GerstnerWave& wave : sea.waves) {
    if (wave.wavenumber_radpm > largest_wavenumber_radpm(query.min_wavelength_m)) continue;
    const double cosine = std::cos(wave.direction_rad), sine = std::sin(wave.direction_rad);
    const double k = wave.wavenumber_radpm, a = wave.amplitude_m, qa = scale * a;
    const double turns_x_perm = k * cosine / two_pi, turns_z_perm = k * sine / two_pi;
    const std::uint32_t rate = clock.rate(wave.omega_radps);
    const TileStep step_x = tile_step(turns_x_perm), step_z = tile_step(turns_z_perm);
    const Flow flow = flow_of(wave, rate * clock.radps_per_rate(), query.depth_m, sea.dispersion.depth_m);
    packed.push_back({.phase = device_phase(wave.phase_rad / two_pi),
                      .tile_step_x = step_x.whole,
                      .tile_step_z = step_z.whole,
                      .tile_rest_x = step_x.rest,
                      .tile_rest_z = step_z.rest,
                      .rate = std::bit_cast<std::int32_t>(rate),
                      .turns_x_perm = static_cast<float>(turns_x_perm),
                      .turns_z_perm = static_cast<float>(turns_z_perm),
                      .height_m = static_cast<float>(a),
                      .gradient_xx = static_cast<float>(-qa * k * cosine * cosine),
                      .gradient_xz = static_cast<float>(-qa * k * cosine * sine),
                      .gradient_zz = static_cast<float>(-qa * k * sine * sine),
                      .shift_x_m = static_cast<float>(-qa * cosine),
                      .shift_z_m = static_cast<float>(-qa * sine),
                      .slope_x = static_cast<float>(-a * k * cosine),
                      .slope_z = static_cast<float>(-a * k * sine),
                      .velocity_x_mps = static_cast<float>(flow.along_mps * cosine),
                      .velocity_z_mps = static_cast<float>(flow.along_mps * sine),
                      .head_m = static_cast<float>(flow.head_m),
                      .velocity_y_mps = static_cast<float>(flow.up_mps),
                      .omega_radps = static_cast<float>(rate * clock.radps_per_rate()),
                      .band = bands ? bands->gerstner_band(k) : 0});
  }
  return packed;
}

std::vector<GerstnerRingInTile> pack_rings(const GerstnerSea& sea, const WaterQuery& query, double time_s) {
  std::vector<GerstnerRingInTile> packed;
  for (const Raindrop& drop : sea.raindrops) {
    if (drop.wavelength_m < query.min_wavelength_m) continue;
    const double tile_x = std::nearbyint(drop.x_m / tile_m), tile_z = std::nearbyint(drop.z_m / tile_m);
    const GerstnerRing ring =
        device_ring(drop, time_s, sea.dispersion, {.x_m = tile_x * tile_m, .z_m = tile_z * tile_m});
    if (!is_visible(ring)) continue;
    packed.push_back({.tile_x = static_cast<int>(tile_x), .tile_z = static_cast<int>(tile_z), .ring = ring});
  }
  return packed;
}

SurfaceQueryParams pack_params(const QueriedSea& sea, const WaterQuery& query, int sample_floats) {
  SurfaceQueryParams params{};
  for (const Cascade& cascade : sea.cascades) {
    // Cascades go from long waves to short ones: those that hold none of the waves asked for come last.
    if (cascade.k_min_radpm > largest_wavenumber_radpm(query.min_wavelength_m)) break;
    const int i = params.cascade_count++;
    const double length_m = cascade.patch_length_m;
    const double step = std::fmod(tile_m, length_m) / length_m * 0x1p32, high = std::floor(step);
    params.tile_step_high[i] = std::bit_cast<std::int32_t>(static_cast<std::uint32_t>(high));
    params.tile_step_low[i] = std::bit_cast<std::int32_t>(static_cast<std::uint32_t>((step - high) * 0x1p32));
    params.patches_per_m[i] = static_cast<float>(1.0 / length_m);
    params.texels_per_m[i] = static_cast<float>(sea.size / length_m);
    params.mode_radius[i] = static_cast<float>(mode_radius(cascade, query.min_wavelength_m));
  }
  params.size = sea.size;
  params.has_flow = query.fields == WaterQuery::Fields::surface_and_flow ? 1 : 0;
  params.depth_m = static_cast<float>(query.depth_m);
  params.weight_papm = static_cast<float>(query.density_kgpm3 * sea.dispersion.gravity_mps2);
  params.tolerance_m = static_cast<float>(query.tolerance_m);
  params.error_rms_m = static_cast<float>(sea.error_rms_m);
  params.sample_floats = sample_floats;
  if (const auto* sums = std::get_if<ModeSums>(&sea.source)) params.columns = sums->columns;
  if (const auto* splines = std::get_if<SplineMaps>(&sea.source)) {
    std::copy(splines->scales.begin(), splines->scales.end(), params.map_scales);
  }
  return params;
}

/// Writes values that differ from those that were written before.
template <class T>
void write_changed(const ocl::Device& device, std::vector<T>&& values, std::vector<T>& held,
                   ocl::Buffer<T>& buffer, const char* name) {
  if (buffer.size() < std::max<std::size_t>(values.size(), 1)) {
    buffer = ocl::Buffer<T>(device, std::max<std::size_t>(values.size(), 1), name);
    held.clear();
  }
  const bool is_same =
      values.size() == held.size() &&
      (values.empty() || std::memcmp(values.data(), held.data(), values.size() * sizeof(T)) == 0);
  if (is_same) return;
  held.clear();
  if (!values.empty()) buffer.write(values);
  held = std::move(values);
}

}  // namespace

SurfaceInstant read_instant(const QueriedSea& sea, const WaterQuery& query) {
  const auto& maps = std::get<FrameMaps>(sea.source);
  std::vector<SurfaceInstant::Maps> cascades;
  const std::size_t floats = 4 * static_cast<std::size_t>(sea.size) * static_cast<std::size_t>(sea.size);
  for (std::size_t i = 0; i < sea.cascades.size(); ++i) {
    const auto read = [&](const ocl::Buffer<float>& map) {
      std::vector<float> values(floats);
      map.read(values, i * floats);
      return values;
    };
    cascades.push_back({.patch_length_m = sea.cascades[i].patch_length_m,
                        .displacement = read(maps.displacement),
                        .gradient = read(maps.gradient),
                        .flow = maps.flow ? read(*maps.flow) : std::vector<float>{}});
  }
  return {std::move(cascades),
          sea.size,
          sea.gerstner_waves,
          sea.time_s,
          query,
          sea.dispersion,
          sea.wakes.read(),
          sea.shoals ? std::optional(sea.shoals->instant()) : std::nullopt,
          sea.error_rms_m};
}

SurfaceQuery::SurfaceQuery(const ocl::Device& device)
    : device_(device),
      tuning_(ocl::tuning_for(device.info(), "surface_query")),
      sum_tuning_(ocl::tuning_for(device.info(), "mode_sums")) {}

const ocl::Kernel& SurfaceQuery::kernel_for(const QueriedSea& sea) {
  const auto source = static_cast<int>(sea.source.index());
  const auto* maps = std::get_if<SplineMaps>(&sea.source);
  const int map_fields = maps ? maps->map_fields : 0;
  const auto [entry, is_new] = kernels_.try_emplace({source, map_fields, sea.shoals ? 1 : 0});
  if (is_new) {
    const ocl::KernelTuning& tuning = source == QUERY_MODES ? sum_tuning_ : tuning_;
    ocl::Defines defines;
    defines.set("SOURCE", source).set("LANES", tuning.lanes).set("VECTORS", tuning.per_item);
    if (maps) defines.set("MAP_FIELDS", map_fields);
    if (source == QUERY_MODES) defines.set("GROUP", static_cast<int>(tuning.group));
    if (sea.shoals) defines.set("SHOALS", 1);
    entry->second = ocl::Program::build(device_, "ocean/surface_query.cl", defines).kernel("surface_query");
  }
  return entry->second;
}

void SurfaceQuery::upload(const QueriedSea& sea, const WaterQuery& query, int sample_floats) {
  const WaveClock clock(largest_omega_radps / two_pi, sea.gerstner_waves.loop_period_s);
  std::vector<SurfaceQueryWave> waves = pack_waves(
      sea.gerstner_waves, query, clock, sea.shoals ? &sea.shoals->instant().table.bands() : nullptr);
  std::vector<GerstnerRingInTile> rings = pack_rings(sea.gerstner_waves, query, sea.time_s);
  SurfaceQueryParams params = pack_params(sea, query, sample_floats);
  params.wave_count = static_cast<int>(waves.size());
  params.ring_count = static_cast<int>(rings.size());
  write_changed(device_, std::move(waves), waves_, waves_buffer_, "queried waves");
  write_changed(device_, std::move(rings), rings_, rings_buffer_, "queried rings");
  write_changed(device_, std::vector{params}, params_, params_buffer_, "query");
}

template <class Sample>
void SurfaceQuery::enqueue(const QueriedSea& sea, const WaterQuery& query,
                           const ocl::Buffer<SurfaceQueryPoint>& points, std::size_t count,
                           ocl::Buffer<Sample>& samples) {
  if (count == 0) return;
  upload(sea, query, static_cast<int>(sizeof(Sample) / sizeof(float)));
  const WaveClock clock(largest_omega_radps / two_pi, sea.gerstner_waves.loop_period_s);
  const WaveTime time = clock.at(sea.time_s);
  const ocl::Kernel& kernel = kernel_for(sea);
  const auto launch_with = [&](const ocl::LaunchShape& shape, const auto&... source) {
    const auto launch = [&](const auto&... shoals) {
      kernel.launch(shape, points, source..., waves_buffer_, rings_buffer_, sea.wakes.maps(),
                    sea.wakes.layers(), static_cast<int>(sea.wakes.count()), shoals..., params_buffer_,
                    static_cast<int>(count), time.ticks, time.tick_fraction, samples);
    };
    if (sea.shoals == nullptr) {
      launch();
    } else {
      launch(sea.shoals->map(), sea.shoals->depths_m(), sea.shoals->shares());
    }
  };
  const ocl::LaunchShape shape = ocl::launch_shape(tuning_, count);
  // Without flow a map that is there stands in for it, unread.
  if (const auto* frame = std::get_if<FrameMaps>(&sea.source)) {
    launch_with(shape, frame->displacement, frame->gradient, frame->flow ? *frame->flow : frame->gradient);
  } else if (const auto* splines = std::get_if<SplineMaps>(&sea.source)) {
    launch_with(shape, splines->map);
  } else {
    launch_with({{count * sum_tuning_.group}, {sum_tuning_.group}}, std::get<ModeSums>(sea.source).fields);
  }
}

void SurfaceQuery::sample(const QueriedSea& sea, const WaterQuery& query,
                          const ocl::Buffer<SurfaceQueryPoint>& points, std::size_t count,
                          ocl::Buffer<WaterSample>& samples) {
  enqueue(sea, query, points, count, samples);
}

void SurfaceQuery::sample(const QueriedSea& sea, const WaterQuery& query,
                          const ocl::Buffer<SurfaceQueryPoint>& points, std::size_t count,
                          ocl::Buffer<FirstWaterFloats>& samples) {
  enqueue(sea, query, points, count, samples);
}

void SurfaceQuery::sample(const QueriedSea& sea, const WaterQuery& query,
                          const ocl::Buffer<SurfaceQueryPoint>& points, std::size_t count,
                          ocl::Buffer<ShiftedWaterSample>& samples) {
  enqueue(sea, query, points, count, samples);
}

void SurfaceQuery::sample(const QueriedSea& sea, const WaterQuery& query, std::span<const WaterPoint> points,
                          const TakeSamples& take) {
  const std::size_t most = std::min(points.size(), most_points);
  if (points_.size() < most) {
    points_ = ocl::Buffer<SurfaceQueryPoint>(device_, most, "queried points");
    samples_ = ocl::Buffer<WaterSample>(device_, most, "queried samples");
  }
  for (std::size_t first = 0; first < points.size(); first += most_points) {
    const std::span<const WaterPoint> part =
        points.subspan(first, std::min(most_points, points.size() - first));
    packed_points_.resize(part.size());
    std::transform(part.begin(), part.end(), packed_points_.begin(), device_point);
    points_.write(packed_points_);
    sample(sea, query, points_, part.size(), samples_);
    take(first, samples_.map().span().first(part.size()));
  }
}

}  // namespace offing::ocean
