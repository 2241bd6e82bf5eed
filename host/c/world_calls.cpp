#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "host/c/arrays.h"
#include "host/c/handles.h"
#include "host/c/watched_work.h"
#include "host/io/modes/mode_file.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/prepare/world_scene.h"
#include "host/world/cloud_grower.h"

using offing::Error;
using offing::ErrorKind;
using offing::c::require;
using offing::c::run;
using offing::c::Use;
using offing::c::write_values;

namespace {

using offing::ocean::SeaField;

OffingSample to_sample(const offing::ocean::WaterSample& water) {
  const auto normal = offing::ocean::normal_of(water);
  return {.height_m = water.height_m,
          .normal = {normal[0], normal[1], normal[2]},
          .velocity_mps = {water.velocity_x_mps, water.velocity_y_mps, water.velocity_z_mps},
          .pressure_pa = water.pressure_pa,
          .residual_m = water.residual_m};
}

/// Writes the samples of the points from index `first` on: one quantity after the other, in blocks that stay
/// in a core's nearest cache.
void write_water(const OffingWater& arrays, std::size_t first,
                 std::span<const offing::ocean::WaterSample> water) {
  if (arrays.samples != nullptr) {
    constexpr std::size_t floats = std::tuple_size_v<offing::ocean::FirstWaterFloats>;
    for (std::size_t i = 0; i < water.size(); ++i)
      std::memcpy(arrays.samples + floats * (first + i), &water[i], floats * sizeof(float));
  }
  if (arrays.full_samples != nullptr) {
    constexpr std::size_t floats = 12;
    static_assert(sizeof(offing::ocean::WaterSample) == floats * sizeof(float));
    std::memcpy(arrays.full_samples + floats * first, water.data(), water.size_bytes());
  }
  constexpr std::size_t block = 512;
  for (std::size_t begin = 0; begin < water.size(); begin += block) {
    const std::size_t end = std::min(begin + block, water.size());
    const auto write = [&](float* array, auto value) {
      if (array == nullptr) return;
      for (std::size_t i = begin; i < end; ++i) array[first + i] = value(water[i]);
    };
    const auto write_vectors = [&](float* array, auto value) {
      if (array == nullptr) return;
      for (std::size_t i = begin; i < end; ++i) {
        const std::array<float, 3> vector = value(water[i]);
        for (std::size_t axis = 0; axis < 3; ++axis) array[3 * (first + i) + axis] = vector[axis];
      }
    };
    using Sample = offing::ocean::WaterSample;
    write(arrays.height_m, [](const Sample& sample) { return sample.height_m; });
    write(arrays.pressure_pa, [](const Sample& sample) { return sample.pressure_pa; });
    write(arrays.residual_m, [](const Sample& sample) { return sample.residual_m; });
    write_vectors(arrays.normal, [](const Sample& sample) { return offing::ocean::normal_of(sample); });
    write_vectors(arrays.velocity_mps, [](const Sample& sample) {
      return std::array{sample.velocity_x_mps, sample.velocity_y_mps, sample.velocity_z_mps};
    });
    write_vectors(arrays.acceleration_mps2, [](const Sample& sample) {
      return std::array{sample.acceleration_x_mps2, sample.acceleration_y_mps2, sample.acceleration_z_mps2};
    });
    write(arrays.error_rms_m, [](const Sample& sample) { return sample.error_rms_m; });
  }
}

offing::ocean::WaterQuery::Accuracy accuracy_of(int accuracy) {
  using Accuracy = offing::ocean::WaterQuery::Accuracy;
  switch (accuracy) {
    case OFFING_ACCURACY_AUTOMATIC:
      return Accuracy::automatic;
    case OFFING_ACCURACY_EXACT:
      return Accuracy::exact;
    case OFFING_ACCURACY_MAPS:
      return Accuracy::maps;
    case OFFING_ACCURACY_FRAME_MAPS:
      return Accuracy::frame_maps;
    default:
      throw Error(ErrorKind::bad_usage,
                  fmt::format("query.accuracy: expected an OffingAccuracy, found {}", accuracy),
                  "set it to 0, or to a name of OffingAccuracy");
  }
}

offing::ocean::WaterQuery query_of(const OffingWaterQuery* given, bool wants_flow) {
  const OffingWaterQuery query = offing::c::read_struct(given, "query");
  using Fields = offing::ocean::WaterQuery::Fields;
  return {.depth_m = query.depth_m,
          .min_wavelength_m = query.min_wavelength_m,
          .fields = wants_flow && query.is_surface_only == 0 ? Fields::surface_and_flow : Fields::surface,
          .accuracy = accuracy_of(query.accuracy)};
}

/// Which component of the velocity a field is, 0 to 2; -1: none.
constexpr int velocity_component(OffingField field) {
  return field >= OFFING_VELOCITY_X && field <= OFFING_VELOCITY_Z ? field - OFFING_VELOCITY_X : -1;
}

/// Throws Error(bad_usage) for foam, velocity and what is no field.
SeaField surface_field(OffingField field) {
  switch (field) {
    case OFFING_DISPLACEMENT_X:
      return SeaField::displacement_x;
    case OFFING_DISPLACEMENT_Y:
      return SeaField::displacement_y;
    case OFFING_DISPLACEMENT_Z:
      return SeaField::displacement_z;
    case OFFING_SLOPE_X:
      return SeaField::slope_x;
    case OFFING_SLOPE_Z:
      return SeaField::slope_z;
    case OFFING_JACOBIAN:
      return SeaField::jacobian;
    case OFFING_GRADIENT_XX:
      return SeaField::gradient_xx;
    case OFFING_GRADIENT_XZ:
      return SeaField::gradient_xz;
    case OFFING_GRADIENT_ZZ:
      return SeaField::gradient_zz;
    case OFFING_JACOBIAN_MIN_EIGENVALUE:
      return SeaField::jacobian_min_eigenvalue;
    case OFFING_FOAM:
    case OFFING_VELOCITY_X:
    case OFFING_VELOCITY_Y:
    case OFFING_VELOCITY_Z:
      break;
  }
  throw Error(ErrorKind::bad_usage,
              fmt::format("field: expected an OffingField, got {}", static_cast<int>(field)),
              "use one of the names in offing.h");
}

void read_fields(offing::ocean::Ocean& ocean, int cascade, std::span<const OffingField> fields,
                 float* const* values, std::size_t count) {
  const auto size = static_cast<std::size_t>(ocean.parameters().size);
  offing::c::require_count("count", count, size * size);
  std::vector<SeaField> of_surface;
  std::vector<float*> targets;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    require(values[i], "values");
    if (fields[i] == OFFING_FOAM || velocity_component(fields[i]) >= 0) continue;
    of_surface.push_back(surface_field(fields[i]));
    targets.push_back(values[i]);
  }
  ocean.read_fields(cascade, of_surface, targets);
  std::optional<offing::ocean::VelocityFields> velocity;  // all three components are read together
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (fields[i] == OFFING_FOAM) {
      ocean.foam_map().read({values[i], count}, count * static_cast<std::size_t>(cascade));
    } else if (const int component = velocity_component(fields[i]); component >= 0) {
      if (!velocity) velocity = ocean.read_velocity(cascade);
      const std::vector<float>& found =
          *std::array{&velocity->x, &velocity->y, &velocity->z}.at(static_cast<std::size_t>(component));
      std::copy(found.begin(), found.end(), values[i]);
    }
  }
}

/// The world as offing-view shows it, with its camera placed.
std::unique_ptr<OffingWorld> made_world(const offing::ocl::Device& device, offing::scene::Scene scene,
                                        const offing::c::WatchedWork& watched) {
  constexpr double prepared = 0.1, grown = 0.8, made = 0.9;
  const offing::Work& work = watched.work();
  offing::world::WorldParameters parameters = offing::scene::prepare_shown_world(scene);
  work.tell(prepared);
  const offing::Work growing = work.part(prepared, grown);
  offing::world::grow_clouds(device, parameters, watched.cancel(),
                             [&](const offing::world::CloudProgress& progress) {
                               growing.tell((static_cast<double>(progress.done) + progress.share) /
                                            static_cast<double>(progress.all));
                             });
  auto world = std::make_unique<OffingWorld>(scene, device, parameters);
  work.tell(made);
  world->camera = offing::scene::show_at(world->world, world->scene, world->scene.time.start_s).camera;
  work.tell(1.0);
  return world;
}

}  // namespace

OffingStatus offing_load_scene(const char* file, OffingScene** scene) {
  return run([&] {
    require(file, "file");
    require(scene, "scene");
    *scene = new OffingScene{offing::scene::load_scene(file)};
  });
}

OffingStatus offing_parse_scene(const char* text, const char* folder, OffingScene** scene) {
  return run([&] {
    require(text, "text");
    require(scene, "scene");
    *scene = new OffingScene{offing::scene::parse_scene(text, "scene", folder == nullptr ? "" : folder)};
  });
}

OffingStatus offing_parse_values(const char* text, const char* folder, OffingScene** scene) {
  return run([&] {
    require(text, "text");
    require(scene, "scene");
    *scene = new OffingScene{offing::scene::parse_scene(text, "", folder == nullptr ? "" : folder)};
  });
}

void offing_free_scene(OffingScene* scene) {
  delete scene;
}

OffingStatus offing_make_world(const OffingDevice* device, const OffingScene* scene, OffingWorld** world) {
  return offing_make_world_with(device, scene, nullptr, world);
}

OffingStatus offing_make_world_with(const OffingDevice* device, const OffingScene* scene,
                                    const OffingWorldOptions* options, OffingWorld** world) {
  return run([&] {
    require(device, "device");
    require(scene, "scene");
    require(world, "world");
    const offing::c::WatchedWork watched(offing::c::read_struct(options, "options").progress);
    *world = made_world(device->device, scene->copy(), watched).release();
  });
}

void offing_free_world(OffingWorld* world) {
  delete world;
}

OffingStatus offing_frame(OffingWorld* world, double time_s) {
  return run([&] {
    const Use use(world, "world");
    world->camera = offing::scene::show_at(world->world, world->scene, time_s).camera;
  });
}

OffingStatus offing_get_time(OffingWorld* world, double* time_s) {
  return run([&] {
    const Use use(world, "world");
    require(time_s, "time_s");
    *time_s = world->world.time_s();
  });
}

OffingStatus offing_sample(OffingWorld* world, const OffingQuery* query, const OffingPoint* points,
                           size_t count, OffingSample* samples) {
  return run([&] {
    const Use use(world, "world");
    if (count == 0) return;
    require(points, "points");
    require(samples, "samples");
    offing::ocean::WaterQuery asked;
    if (query != nullptr) {
      asked.depth_m = query->depth_m;
      asked.min_wavelength_m = query->min_wavelength_m;
    }
    std::vector<offing::ocean::WaterPoint> places(count);
    std::transform(points, points + count, places.begin(), [](const OffingPoint& point) {
      return offing::ocean::WaterPoint{point.x_m, point.z_m};
    });
    const std::vector<offing::ocean::WaterSample> found = world->world.sample(places, asked);
    std::transform(found.begin(), found.end(), samples, to_sample);
  });
}

OffingStatus offing_sample_water(OffingWorld* world, const OffingWaterQuery* query, const double* points_m,
                                 size_t count, const OffingWater* water) {
  return run([&] {
    const Use use(world, "world");
    if (count == 0) return;
    require(points_m, "points_m");
    require(water, "water");
    const OffingWater wanted = offing::c::read_struct(water, "water");
    const bool wants_flow = wanted.velocity_mps != nullptr || wanted.pressure_pa != nullptr ||
                            wanted.samples != nullptr || wanted.acceleration_mps2 != nullptr ||
                            wanted.full_samples != nullptr;
    static_assert(sizeof(offing::ocean::WaterPoint) == 2 * sizeof(double));
    const std::span places(reinterpret_cast<const offing::ocean::WaterPoint*>(points_m), count);
    world->world.sample(
        places,
        [&](std::size_t first, std::span<const offing::ocean::WaterSample> part) {
          write_water(wanted, first, part);
        },
        query_of(query, wants_flow));
  });
}

OffingStatus offing_sample_water_on_device(OffingWorld* world, const OffingWaterQuery* query, void* points,
                                           size_t count, void* samples) {
  return run([&] {
    const Use use(world, "world");
    if (count == 0) return;
    require(points, "points");
    require(samples, "samples");
    const offing::ocl::Device& device = world->world.device();
    const auto places =
        offing::ocl::Buffer<SurfaceQueryPoint>::adopt(device, static_cast<cl_mem>(points), "points");
    const auto sample_into = [&]<class Sample>(offing::ocl::Buffer<Sample> found) {
      world->world.sample(places, count, found, query_of(query, true));
    };
    using offing::ocl::Buffer;
    if (offing::c::read_struct(query, "query").is_full != 0) {
      sample_into(Buffer<offing::ocean::WaterSample>::adopt(device, static_cast<cl_mem>(samples), "samples"));
    } else {
      sample_into(
          Buffer<offing::ocean::FirstWaterFloats>::adopt(device, static_cast<cl_mem>(samples), "samples"));
    }
  });
}

int offing_cascade_count(const OffingWorld* world) {
  return world == nullptr ? 0 : static_cast<int>(world->world.parameters().ocean.cascades.size());
}

int offing_map_size(const OffingWorld* world) {
  return world == nullptr ? 0 : world->world.parameters().ocean.size;
}

double offing_patch_length_m(const OffingWorld* world, int cascade) {
  if (cascade < 0 || cascade >= offing_cascade_count(world)) return 0.0;
  return world->world.parameters().ocean.cascades[static_cast<std::size_t>(cascade)].patch_length_m;
}

OffingStatus offing_read(OffingWorld* world, int cascade, OffingField field, float* values, size_t count) {
  return offing_read_fields(world, cascade, &field, 1, &values, count);
}

OffingStatus offing_read_fields(OffingWorld* world, int cascade, const OffingField* fields,
                                size_t field_count, float* const* values, size_t count) {
  return run([&] {
    const Use use(world, "world");
    if (field_count == 0) return;
    require(fields, "fields");
    require(values, "values");
    read_fields(world->world.ocean(), cascade, {fields, field_count}, values, count);
  });
}

OffingStatus offing_copy_field(OffingWorld* world, int cascade, OffingField field, void* buffer,
                               size_t first) {
  return run([&] {
    const Use use(world, "world");
    require(buffer, "buffer");
    offing::ocean::Ocean& ocean = world->world.ocean();
    auto values =
        offing::ocl::Buffer<float>::adopt(world->world.device(), static_cast<cl_mem>(buffer), "buffer");
    if (field == OFFING_FOAM || velocity_component(field) >= 0) {
      throw Error(ErrorKind::bad_usage, "field: expected one of the surface, got foam or velocity",
                  "read these with offing_read()");
    }
    ocean.copy_field(cascade, surface_field(field), values, first);
  });
}

OffingStatus offing_write_modes(OffingWorld* world, const char* file) {
  return run([&] {
    const Use use(world, "world");
    require(file, "file");
    offing::write_modes(file, world->world.ocean().modes());
  });
}
