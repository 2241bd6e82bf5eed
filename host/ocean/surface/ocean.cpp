#include "host/ocean/surface/ocean.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/parameter_check.h"
#include "host/ocean/ocean_limits.h"
#include "host/ocean/query/query_waves.h"
#include "host/ocean/query/surface_query.h"
#include "host/ocean/surface/foam.h"
#include "host/ocean/surface/gerstner_surface.h"
#include "host/ocean/surface/surface_maps.h"
#include "host/ocean/surface/velocity_map.h"
#include "host/ocean/surface/wave_modes.h"
#include "host/ocl/program.h"
#include "kernels/shared/ocean_params.h"

namespace offing::ocean {
namespace {

/// The maps of a sea without its short waves: each mode counts in full or, if it is shorter than asked, not
/// at all.
class LongWaves {
 public:
  LongWaves(const ocl::Device& device, const WaveModes& modes, double choppiness, double water_depth_m);

  /// Enqueues the surface of the waves no shorter than this, unless it is there already.
  void at(const WaveModes& modes, double min_wavelength_m, double time_s);
  /// Enqueues their velocity at the time of at(), unless it is there already.
  void velocity_at(const WaveModes& modes, double depth_below_surface_m);
  /// Forgets all: the waves have changed.
  void reset();

  const SurfaceMaps& surface() const { return surface_; }
  const ocl::Buffer<float>& velocity() const { return velocity_->velocity(); }

 private:
  ocl::Device device_;
  double water_depth_m_;
  ocl::Kernel filter_;
  ocl::Buffer<float> amplitude_;
  std::optional<double> min_wavelength_m_;  // of amplitude_
  SurfaceMaps surface_;
  std::optional<double> time_s_;  // of surface_
  std::optional<VelocityMap> velocity_;
};

LongWaves::LongWaves(const ocl::Device& device, const WaveModes& modes, double choppiness,
                     double water_depth_m)
    : device_(device),
      water_depth_m_(water_depth_m),
      filter_(ocl::Program::build(device, "ocean/mode_filter.cl").kernel("mode_filter")),
      amplitude_(device, modes.amplitude().size(), "long waves' amplitudes"),
      surface_(device, modes, choppiness) {}

void LongWaves::at(const WaveModes& modes, double min_wavelength_m, double time_s) {
  if (min_wavelength_m_ != min_wavelength_m) {
    reset();
    filter_.launch({{static_cast<std::size_t>(modes.columns()), static_cast<std::size_t>(modes.size()),
                     static_cast<std::size_t>(modes.cascade_count())}},
                   modes.amplitude(), modes.wavenumber_step(), modes.columns(), modes.size(),
                   static_cast<float>(largest_wavenumber_radpm(min_wavelength_m)), amplitude_);
    min_wavelength_m_ = min_wavelength_m;
  }
  if (time_s_ == time_s) return;
  time_s_.reset();
  surface_.at(modes, amplitude_, time_s);
  time_s_ = time_s;
}

void LongWaves::velocity_at(const WaveModes& modes, double depth_below_surface_m) {
  if (!velocity_) velocity_.emplace(device_, modes, water_depth_m_);
  velocity_->at(modes, amplitude_, *time_s_, depth_below_surface_m);
}

void LongWaves::reset() {
  min_wavelength_m_.reset();
  time_s_.reset();
  if (velocity_) velocity_->reset();
}

// Where a field is on the device: [texels][stride] floats, at this offset.
enum class FieldMap { displacement, gradient, jacobian };
constexpr std::size_t map_kinds = 3;

struct FieldPlace {
  FieldMap map;
  std::size_t stride, offset;
};

/// Copies one of interleaved fields. A step that the compiler knows lets it use vectors.
template <std::size_t step>
void take_every(const float* __restrict from, std::size_t count, float* __restrict to) {
  for (std::size_t i = 0; i < count; ++i) to[i] = from[step * i];
}

FieldPlace place_of(SeaField field) {
  switch (field) {
    case SeaField::displacement_x:
      return {FieldMap::displacement, 4, 0};
    case SeaField::displacement_y:
      return {FieldMap::displacement, 4, 1};
    case SeaField::displacement_z:
      return {FieldMap::displacement, 4, 2};
    case SeaField::gradient_xz:
      return {FieldMap::displacement, 4, 3};
    case SeaField::slope_x:
      return {FieldMap::gradient, 4, 0};
    case SeaField::slope_z:
      return {FieldMap::gradient, 4, 1};
    case SeaField::gradient_xx:
      return {FieldMap::gradient, 4, 2};
    case SeaField::gradient_zz:
      return {FieldMap::gradient, 4, 3};
    case SeaField::jacobian:
      return {FieldMap::jacobian, 2, 0};
    case SeaField::jacobian_min_eigenvalue:
      return {FieldMap::jacobian, 2, 1};
  }
  throw Error(ErrorKind::bad_usage,
              fmt::format("field: expected a SeaField, got {}", static_cast<int>(field)),
              "use one of the names in ocean.h");
}

OceanParameters checked(const OceanParameters& parameters) {
  require_valid_size(parameters.size);
  require_within("cascade count", static_cast<double>(parameters.cascades.size()), 1, 4);
  for (const Cascade& cascade : parameters.cascades) {
    require_within("patch_length_m", cascade.patch_length_m, 0.01, 1e6);
    require_within("k_min_radpm", cascade.k_min_radpm, 0.0, cascade.k_max_radpm);
  }
  require_within("choppiness", parameters.choppiness, 0.0, 10.0);
  if (parameters.loop_period_s) require_within("loop_period_s", *parameters.loop_period_s, 0.1, 1e5);
  require_valid_foam(parameters.foam);
  require_valid_gerstner_waves(parameters.gerstner_waves);
  return parameters;
}

}  // namespace

struct Ocean::State {
  State(const ocl::Device& opened, const SeaSpectrum& asked, const OceanParameters& requested)
      : device(opened),
        spectrum(asked),
        parameters(checked(requested)),
        dispersion(spectrum.dispersion),
        modes(device, spectrum, parameters.cascades, parameters.size, parameters.loop_period_s,
              parameters.modes.get()),
        surface(device, modes, parameters.choppiness),
        query_waves(device, parameters.cascades, parameters.choppiness, dispersion),
        wakes(std::make_shared<const WakeMaps>(device)) {
    modes.draw(parameters.seed);
  }

  std::size_t texels() const {
    return static_cast<std::size_t>(parameters.size) * static_cast<std::size_t>(parameters.size);
  }

  std::size_t first_texel(int cascade) const {
    require_within("cascade index", cascade, 0, static_cast<double>(parameters.cascades.size()) - 1);
    return static_cast<std::size_t>(cascade) * texels();
  }

  /// The surface at time_s, computed anew where foam left one of its past instants in the maps, or failed
  /// there.
  const SurfaceMaps& current_surface() {
    if (!surface_is_current) {
      surface.at(modes, time_s);
      surface_is_current = true;
    }
    return surface;
  }

  /// Of all cascades; the Jacobian of the cascade alone that begins at this texel, made anew each time.
  const ocl::Buffer<float>& map_of(FieldMap map, std::size_t first_texel_of_cascade) {
    const SurfaceMaps& current = current_surface();
    if (map == FieldMap::displacement) return current.displacement();
    if (map == FieldMap::gradient) return current.gradient();
    if (!jacobian)
      jacobian = ocl::Program::build(device, "ocean/surface_jacobian.cl").kernel("surface_jacobian");
    if (jacobians.empty()) jacobians = ocl::Buffer<float>(device, 2 * texels(), "jacobian");
    jacobian->launch({{texels(), 1, 1}}, current.displacement(), current.gradient(),
                     static_cast<int>(first_texel_of_cascade), jacobians);
    return jacobians;
  }

  /// Particle velocity at time_s of all waves.
  const ocl::Buffer<float>& velocity_at(double depth_m) {
    if (!velocity) velocity.emplace(device, modes, dispersion.depth_m);
    velocity->at(modes, modes.amplitude(), time_s, depth_m);
    return velocity->velocity();
  }

  /// The waves that a query of so many points counts, at time_s.
  QueriedSea queried(const WaterQuery& query, std::size_t count);
  /// The same from a frame's maps.
  FrameMaps frame_maps(const WaterQuery& query);
  void enqueue_sample(const auto& points, std::size_t count, auto& samples, const WaterQuery& query);
  OceanComposeParams grid_in_patches(const SampleGrid& grid);

  ocl::Device device;
  SeaSpectrum spectrum;
  OceanParameters parameters;
  Dispersion dispersion;
  double time_s = 0.0;
  WaveModes modes;
  SurfaceMaps surface;
  QueryWaves query_waves;
  std::shared_ptr<const WakeMaps> wakes;  // never none
  std::shared_ptr<const Shoals> shoals;   // none: the open sea
  bool surface_is_current = false;        // whether `surface` is that of time_s
  // Made at first use: many callers want the surface alone.
  std::optional<VelocityMap> velocity;
  std::optional<FoamOnset> foam_onset;
  std::optional<std::vector<FoamGathering>> foam_gathering;  // by these Gerstner waves
  std::optional<Foam> foam;
  std::optional<ocl::Kernel> jacobian, field_copy;
  ocl::Buffer<float> jacobians;
  std::optional<ocl::Kernel> compose, foam_compose;
  std::optional<GerstnerSurface> gerstner_surface;
  std::optional<LongWaves> long_waves;
  std::optional<SurfaceQuery> query;
};

FrameMaps Ocean::State::frame_maps(const WaterQuery& wanted) {
  const bool wants_flow = wanted.fields == WaterQuery::Fields::surface_and_flow;
  const bool counts_all =
      parameters.cascades.back().k_max_radpm <= largest_wavenumber_radpm(wanted.min_wavelength_m);
  const ocl::Buffer<float>* flow = nullptr;
  if (counts_all) {
    if (wants_flow) flow = &velocity_at(wanted.depth_m);
    current_surface();
  } else {
    if (!long_waves) long_waves.emplace(device, modes, parameters.choppiness, dispersion.depth_m);
    long_waves->at(modes, wanted.min_wavelength_m, time_s);
    if (wants_flow) {
      long_waves->velocity_at(modes, wanted.depth_m);
      flow = &long_waves->velocity();
    }
  }
  const SurfaceMaps& maps = counts_all ? surface : long_waves->surface();
  return {.displacement = maps.displacement(), .gradient = maps.gradient(), .flow = flow};
}

QueriedSea Ocean::State::queried(const WaterQuery& wanted, std::size_t count) {
  require_valid_query(wanted, std::min(dispersion.depth_m, parameters.gerstner_waves.dispersion.depth_m));
  using Accuracy = WaterQuery::Accuracy;
  Accuracy accuracy = wanted.accuracy;
  if (accuracy == Accuracy::automatic) {
    accuracy = count <= most_exact_points ? Accuracy::exact : Accuracy::maps;
  }
  return {.source = accuracy == Accuracy::frame_maps ? QueryWaves::Source(frame_maps(wanted))
                                                     : query_waves.at(modes, time_s, wanted, accuracy),
          .cascades = parameters.cascades,
          .size = query_waves.size(modes, wanted, accuracy),
          .error_rms_m = query_waves.error_rms_m(modes, parameters.gerstner_waves, wanted, accuracy),
          .gerstner_waves = parameters.gerstner_waves,
          .wakes = *wakes,
          .shoals = shoals.get(),
          .dispersion = dispersion,
          .time_s = time_s};
}

Ocean::Ocean(const ocl::Device& device, const SeaSpectrum& spectrum, const OceanParameters& parameters)
    : state_(std::make_unique<State>(device, spectrum, parameters)) {}
Ocean::Ocean(Ocean&&) noexcept = default;
Ocean& Ocean::operator=(Ocean&&) noexcept = default;
Ocean::~Ocean() = default;

const OceanParameters& Ocean::parameters() const {
  return state_->parameters;
}

void Ocean::at(double time_s) {
  require_within("time_s", time_s, -largest_time_s, largest_time_s);
  state_->time_s = time_s;
  state_->surface_is_current = false;
}

void Ocean::set_gerstner_waves(const GerstnerSea& gerstner_waves) {
  require_valid_gerstner_waves(gerstner_waves);
  state_->parameters.gerstner_waves = gerstner_waves;
  state_->foam_gathering.reset();
}

void Ocean::set_wakes(std::shared_ptr<const WakeMaps> wakes) {
  state_->wakes = wakes ? std::move(wakes) : std::make_shared<const WakeMaps>(state_->device);
}

void Ocean::set_shoals(std::shared_ptr<const Shoals> shoals) {
  state_->shoals = std::move(shoals);
}

SurfaceFields Ocean::read_surface(int cascade) const {
  SurfaceFields fields;
  fields.size = state_->parameters.size;
  std::vector<SeaField> all;
  std::vector<float*> values;
  for (std::vector<float>* field :
       {&fields.displacement_x, &fields.displacement_y, &fields.displacement_z, &fields.slope_x,
        &fields.slope_z, &fields.gradient_xx, &fields.gradient_xz, &fields.gradient_zz, &fields.jacobian,
        &fields.jacobian_min_eigenvalue}) {
    field->resize(state_->texels());
    all.push_back(static_cast<SeaField>(all.size()));
    values.push_back(field->data());
  }
  read_fields(cascade, all, values);
  return fields;
}

void Ocean::read_fields(int cascade, std::span<const SeaField> fields, std::span<float* const> values) const {
  State& state = *state_;
  if (fields.size() != values.size()) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("read_fields: expected memory for each of {} fields, found {}", fields.size(),
                            values.size()),
                "pass as many pointers as fields");
  }
  const std::size_t count = state.texels(), first = state.first_texel(cascade);
  std::vector<FieldPlace> places;
  for (const SeaField field : fields) places.push_back(place_of(field));
  std::array<std::optional<ocl::MappedSpan<float>>, map_kinds> maps;
  for (const FieldPlace& place : places) {
    const auto kind = static_cast<std::size_t>(place.map);
    if (maps[kind]) continue;
    const ocl::Buffer<float>& map = state.map_of(place.map, first);
    maps[kind].emplace(map.memory(), map.size());
  }
  // In blocks that stay in a core's cache while one field after the other is taken from them.
  constexpr std::size_t block = 4096;
  for (std::size_t begin = 0; begin < count; begin += block) {
    const std::size_t end = std::min(begin + block, count);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const FieldPlace& place = places[i];
      const std::size_t first_here = place.map == FieldMap::jacobian ? 0 : first;
      const float* const from =
          maps[static_cast<std::size_t>(place.map)]->span().data() + first_here * place.stride + place.offset;
      if (place.stride == 4) {
        take_every<4>(from + 4 * begin, end - begin, values[i] + begin);
      } else {
        take_every<2>(from + 2 * begin, end - begin, values[i] + begin);
      }
    }
  }
}

void Ocean::copy_field(int cascade, SeaField field, ocl::Buffer<float>& values, std::size_t first) const {
  State& state = *state_;
  const std::size_t count = state.texels(), first_texel = state.first_texel(cascade);
  if (values.size() < first || values.size() - first < count) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("copy_field: expected room for {} values from {} on, found a buffer of {}", count,
                            first, values.size()),
                "make the buffer larger, or begin further ahead");
  }
  constexpr std::size_t most = std::numeric_limits<int>::max();  // the kernel's indices are int
  if (first > most - count) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("copy_field: expected a first value within [0, {}], got {}", most - count, first),
                "copy to a buffer of its own");
  }
  const FieldPlace place = place_of(field);
  const std::size_t first_here = place.map == FieldMap::jacobian ? 0 : first_texel;
  if (!state.field_copy) {
    state.field_copy = ocl::Program::build(state.device, "ocean/field_copy.cl").kernel("field_copy");
  }
  state.field_copy->launch({{count, 1, 1}}, state.map_of(place.map, first_texel),
                           static_cast<int>(first_here * place.stride + place.offset),
                           static_cast<int>(place.stride), static_cast<int>(first), values);
}

const ocl::Buffer<float>& Ocean::displacement_map() const {
  return state_->current_surface().displacement();
}

const ocl::Buffer<float>& Ocean::gradient_map() const {
  return state_->current_surface().gradient();
}

const FoamOnset& Ocean::foam_onset() const {
  State& state = *state_;
  if (!state.foam_onset) {
    const OceanParameters& sea = state.parameters;
    std::vector<Cascade> held = sea.cascades;  // fewer samples than the bands need hold less of them
    for (Cascade& cascade : held) {
      cascade.k_max_radpm =
          std::min(cascade.k_max_radpm, resolved_wavenumber_radpm(cascade.patch_length_m, sea.size));
    }
    state.foam_onset = ocean::foam_onset(state.spectrum, held, sea.choppiness, sea.foam, sea.loop_period_s);
  }
  return *state.foam_onset;
}

const ocl::Buffer<float>& Ocean::foam_map() {
  State& state = *state_;
  if (!state.foam) {
    state.foam.emplace(state.device, state.modes, state.parameters.foam, foam_onset(),
                       state.parameters.choppiness, state.parameters.loop_period_s);
  }
  if (!state.foam->holds(state.time_s)) {
    // Until it has been asked, the maps may hold a past instant: foam may fail half-way.
    const bool was_current = std::exchange(state.surface_is_current, false);
    const bool used_surface = state.foam->at(state.modes, state.surface, state.time_s);
    state.surface_is_current = was_current && !used_surface;
  }
  return state.foam->foam();
}

std::vector<float> Ocean::read_foam(int cascade) {
  const std::size_t first = state_->first_texel(cascade);
  std::vector<float> foam(state_->texels());
  foam_map().read(foam, first);
  return foam;
}

VelocityFields Ocean::read_velocity(int cascade, double depth_m) {
  State& state = *state_;
  const std::size_t count = state.texels(), first = state.first_texel(cascade);
  require_within("depth_m", depth_m, 0.0, std::min(deepest_m, state.dispersion.depth_m));
  const ocl::Buffer<float>& velocity_map = state.velocity_at(depth_m);
  VelocityFields fields;
  fields.size = state.parameters.size;
  for (std::vector<float>* field : {&fields.x, &fields.y, &fields.z}) field->resize(count);
  const auto velocity = velocity_map.map();
  for (std::size_t i = 0; i < count; ++i) {
    fields.x[i] = velocity[4 * (first + i)];
    fields.y[i] = velocity[4 * (first + i) + 1];
    fields.z[i] = velocity[4 * (first + i) + 2];
  }
  return fields;
}

/// Enqueues the Gerstner waves on this grid, if there are any, and says where its samples lie in the patches.
OceanComposeParams Ocean::State::grid_in_patches(const SampleGrid& grid) {
  require_valid_grid(grid);
  const GerstnerSea& gerstner_waves = parameters.gerstner_waves;
  const bool has_gerstner_waves = !gerstner_waves.waves.empty() || !gerstner_waves.raindrops.empty();
  if (has_gerstner_waves) {
    if (!gerstner_surface) gerstner_surface.emplace(device);
    gerstner_surface->at(gerstner_waves, grid, time_s);
  }
  OceanComposeParams params{};
  params.cascade_count = static_cast<int>(parameters.cascades.size());
  params.columns = grid.columns;
  params.rows = grid.rows;
  params.gerstner_pitch = has_gerstner_waves ? gerstner_surface->pitch() : 0;
  for (std::size_t i = 0; i < parameters.cascades.size(); ++i) {
    const double length_m = parameters.cascades[i].patch_length_m;
    // In 2^-32 of the patch, as the kernel adds them up. fmod() is exact, so that a grid far from the origin
    // loses nothing; a step's rounding comes to columns * 2^-33 of the patch at the far end, 0.008 texels at
    // most.
    const auto fraction = [&](double distance_m) {
      return static_cast<int>(std::llround(std::fmod(distance_m, length_m) / length_m * 0x1p32));
    };
    params.origin_column[i] = fraction(grid.origin_x_m);
    params.origin_row[i] = fraction(grid.origin_z_m);
    params.column_step[i] = fraction(grid.spacing_x_m);
    params.row_step[i] = fraction(grid.spacing_z_m);
  }
  return params;
}

namespace {

/// Where a grid's samples lie in each window; one that says nothing where there is none.
ocl::Buffer<WakeSamples> samples_in_wakes(const ocl::Device& device, const WakeMaps& wakes,
                                          const SampleGrid& grid) {
  std::vector<WakeSamples> samples = wakes.samples_of(grid);
  samples.resize(std::max<std::size_t>(samples.size(), 1));
  return ocl::Buffer<WakeSamples>(device, samples, "samples in wakes");
}

}  // namespace

ComposedFields Ocean::read_composed(const SampleGrid& grid, SlopeRule slopes) {
  State& state = *state_;
  OceanComposeParams params = state.grid_in_patches(grid);
  params.adds_slopes = slopes == SlopeRule::added ? 1 : 0;
  const bool has_gerstner_waves = params.gerstner_pitch > 0;
  if (!state.compose) {
    state.compose = ocl::Program::build(state.device, "ocean/surface_compose.cl").kernel("surface_compose");
  }
  const SurfaceMaps& surface = state.current_surface();
  const auto columns = static_cast<std::size_t>(grid.columns), rows = static_cast<std::size_t>(grid.rows);
  const std::size_t count = columns * rows;
  const ocl::Buffer<OceanComposeParams> params_buffer(state.device, std::span(&params, 1), "sample grid");
  const ocl::Buffer<WakeSamples> samples_buffer = samples_in_wakes(state.device, *state.wakes, grid);
  ocl::Buffer<float> position(state.device, 4 * count, "composed positions");
  ocl::Buffer<float> shape(state.device, 4 * count, "composed slopes");
  // Without Gerstner waves the cascades' own maps stand in for theirs, unread.
  state.compose->launch({{columns, rows, 1}}, surface.displacement(), surface.gradient(),
                        has_gerstner_waves ? state.gerstner_surface->displacement() : surface.displacement(),
                        has_gerstner_waves ? state.gerstner_surface->gradient() : surface.gradient(),
                        state.wakes->maps(), state.wakes->layers(), samples_buffer,
                        static_cast<int>(state.wakes->count()), params_buffer, state.parameters.size,
                        position, shape);
  ComposedFields fields;
  fields.columns = grid.columns;
  fields.rows = grid.rows;
  for (std::vector<float>* field :
       {&fields.displacement_x, &fields.displacement_y, &fields.displacement_z, &fields.slope_x,
        &fields.slope_z, &fields.jacobian, &fields.jacobian_min_eigenvalue}) {
    field->resize(count);
  }
  const auto positions = position.map();
  const auto shapes = shape.map();
  for (std::size_t i = 0; i < count; ++i) {
    fields.displacement_x[i] = positions[4 * i];
    fields.displacement_y[i] = positions[4 * i + 1];
    fields.displacement_z[i] = positions[4 * i + 2];
    fields.jacobian[i] = positions[4 * i + 3];
    fields.slope_x[i] = shapes[4 * i];
    fields.slope_z[i] = shapes[4 * i + 1];
    fields.jacobian_min_eigenvalue[i] = shapes[4 * i + 2];
  }
  return fields;
}

const std::vector<FoamGathering>& Ocean::foam_gathering() const {
  State& state = *state_;
  if (!state.foam_gathering) {
    state.foam_gathering =
        ocean::foam_gathering(foam_onset(), state.parameters.gerstner_waves, state.parameters.choppiness);
  }
  return *state.foam_gathering;
}

namespace {

/// Variance of the compression by Gerstner waves that this grid is too coarse for.
double compression_hidden_by(const SampleGrid& grid, const GerstnerSea& waves) {
  const double all = compression_variance(waves), scale = horizontal_scale(waves).scale;
  const double spacing_m = std::max({std::abs(grid.spacing_x_m), std::abs(grid.spacing_z_m), 1e-9});
  double shown = 0.0;
  for (const GerstnerWave& wave : waves.waves) {
    const double strain = scale * wave.wavenumber_radpm * wave.amplitude_m *
                          shown_share(2.0 * std::numbers::pi / (wave.wavenumber_radpm * spacing_m));
    shown += 0.5 * strain * strain;
  }
  return std::max(all - shown, 0.0);
}

}  // namespace

std::vector<float> Ocean::read_composed_foam(const SampleGrid& grid) {
  State& state = *state_;
  const ocl::Buffer<float>& foam = foam_map();
  const SurfaceMaps& surface = state.current_surface();
  const OceanComposeParams params = state.grid_in_patches(grid);
  if (!state.foam_compose) {
    state.foam_compose = ocl::Program::build(state.device, "ocean/foam_compose.cl").kernel("foam_compose");
  }
  const double hidden = compression_hidden_by(grid, state.parameters.gerstner_waves);
  std::vector<float> gathering;
  for (const FoamGathering& cascade : foam_gathering()) {
    const double shown = cascade.variance > 0.0 ? std::max(1.0 - hidden / cascade.variance, 0.0) : 1.0;
    gathering.push_back(static_cast<float>(std::pow(cascade.factor, shown)));
    gathering.push_back(static_cast<float>(cascade.steepness));
  }
  const auto columns = static_cast<std::size_t>(grid.columns), rows = static_cast<std::size_t>(grid.rows);
  const ocl::Buffer<OceanComposeParams> params_buffer(state.device, std::span(&params, 1), "sample grid");
  const ocl::Buffer<float> gathering_buffer(state.device, gathering, "gathering of foam");
  ocl::Buffer<float> composed(state.device, columns * rows, "composed foam");
  // Without Gerstner waves the cascades' own map stands in for theirs, unread.
  state.foam_compose->launch(
      {{columns, rows, 1}}, foam, surface.gradient(),
      params.gerstner_pitch > 0 ? state.gerstner_surface->gradient() : surface.gradient(), gathering_buffer,
      state.wakes->shown(), state.wakes->layers(), samples_in_wakes(state.device, *state.wakes, grid),
      static_cast<int>(state.wakes->count()), params_buffer, state.parameters.size, composed);
  return composed.read();
}

void Ocean::State::enqueue_sample(const auto& points, std::size_t count, auto& samples,
                                  const WaterQuery& wanted) {
  if (points.size() < count || samples.size() < count) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("sample: expected buffers of {} points and samples, found {} and {}", count,
                            points.size(), samples.size()),
                "make both buffers as large as the number of points");
  }
  const QueriedSea sea = queried(wanted, count);
  if (!query) query.emplace(device);
  query->sample(sea, wanted, points, count, samples);
}

void Ocean::sample(const ocl::Buffer<SurfaceQueryPoint>& points, std::size_t count,
                   ocl::Buffer<WaterSample>& samples, const WaterQuery& query) {
  state_->enqueue_sample(points, count, samples, query);
}

void Ocean::sample(const ocl::Buffer<SurfaceQueryPoint>& points, std::size_t count,
                   ocl::Buffer<FirstWaterFloats>& samples, const WaterQuery& query) {
  state_->enqueue_sample(points, count, samples, query);
}

void Ocean::sample(const ocl::Buffer<SurfaceQueryPoint>& points, std::size_t count,
                   ocl::Buffer<ShiftedWaterSample>& samples, const WaterQuery& query) {
  state_->enqueue_sample(points, count, samples, query);
}

void Ocean::sample(std::span<const WaterPoint> points, const TakeSamples& take, const WaterQuery& query) {
  State& state = *state_;
  const QueriedSea sea = state.queried(query, points.size());
  if (!state.query) state.query.emplace(state.device);
  state.query->sample(sea, query, points, take);
}

void Ocean::sample(std::span<const WaterPoint> points, std::span<WaterSample> samples,
                   const WaterQuery& query) {
  if (points.size() != samples.size()) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("sample: expected a sample for each of {} points, found {}", points.size(),
                            samples.size()),
                "pass as many samples as points");
  }
  sample(
      points,
      [&](std::size_t first, std::span<const WaterSample> part) {
        std::copy(part.begin(), part.end(), samples.begin() + static_cast<std::ptrdiff_t>(first));
      },
      query);
}

std::vector<WaterSample> Ocean::sample(std::span<const WaterPoint> points, const WaterQuery& query) {
  std::vector<WaterSample> samples(points.size());
  sample(points, samples, query);
  return samples;
}

SurfaceInstant Ocean::instant(const WaterQuery& query) {
  WaterQuery of_frame = query;
  of_frame.accuracy = WaterQuery::Accuracy::frame_maps;
  return read_instant(state_->queried(of_frame, 0), of_frame);
}

std::vector<float> Ocean::mode_variance(int cascade) const {
  state_->first_texel(cascade);
  return state_->modes.variance(cascade);
}

ModalSea Ocean::modes() const {
  const OceanParameters& parameters = state_->parameters;
  ModalSea sea{.modes = state_->modes.list(),
               .size = parameters.size,
               .split_radpm = parameters.cascades.front().k_min_radpm,
               .choppiness = parameters.choppiness,
               .depth_m = state_->dispersion.depth_m,
               .loop_period_s = parameters.loop_period_s};
  for (const Cascade& cascade : parameters.cascades) sea.patch_lengths_m.push_back(cascade.patch_length_m);
  const GerstnerInstant gerstner(parameters.gerstner_waves, 0.0);
  for (const GerstnerInstant::Wave& wave : gerstner.waves()) {
    sea.modes.push_back({.amplitude_m = wave.amplitude_m,
                         .kx_radpm = wave.kx_radpm,
                         .kz_radpm = wave.kz_radpm,
                         .omega_radps = wave.omega_radps,
                         .phase_rad = wave.phase_rad});
  }
  return sea;
}

void Ocean::reseed(std::uint64_t seed, const GerstnerSea& gerstner_waves) {
  set_gerstner_waves(gerstner_waves);
  State& state = *state_;
  state.surface_is_current = false;
  if (state.foam) state.foam->reset();
  if (state.velocity) state.velocity->reset();
  if (state.long_waves) state.long_waves->reset();
  state.query_waves.reset();
  state.parameters.seed = seed;
  state.modes.draw(seed);
}

}  // namespace offing::ocean
