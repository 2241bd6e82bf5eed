#include "host/c/offing.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <mutex>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/log.h"
#include "host/ocl/device.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/file/version.h"
#include "host/scene/prepare/world_scene.h"
#include "host/world/world.h"

struct OffingDevice {
  offing::ocl::Device device;
};

struct OffingScene {
  offing::scene::Scene scene;
};

struct OffingWorld {
  offing::scene::Scene scene;
  offing::world::World world;
};

namespace {

using offing::Error;
using offing::ErrorKind;

struct LastFailure {
  std::string error, hint;
};
thread_local LastFailure last_failure;

OffingStatus fail(OffingStatus status, const char* error, const char* hint) noexcept {
  try {
    last_failure = {error, hint};
  } catch (const std::bad_alloc&) {
    last_failure = {};
  }
  return status;
}

OffingStatus status_of(ErrorKind kind) {
  switch (offing::exit_code(kind)) {
    case 2:
      return OFFING_BAD_INPUT;
    case 3:
      return OFFING_NO_DEVICE;
    default:
      return OFFING_FAILED;
  }
}

/// spdlog's own logger writes to standard output, which is the program's; one that the program has set stays.
/// Once a process, whichever call comes first.
void log_to_stderr() {
  static std::once_flag is_done;
  std::call_once(is_done, [] {
    const std::shared_ptr<spdlog::logger> logger = spdlog::default_logger();
    if (logger != nullptr && logger->name().empty()) offing::configure_log(offing::Verbosity::normal);
  });
}

/// Runs what a call does; an exception becomes its status and the thread's last failure.
template <class Work>
OffingStatus run(const Work& work) noexcept {
  try {
    log_to_stderr();
    work();
    return OFFING_OK;
  } catch (const Error& error) {
    return fail(status_of(error.kind()), error.what(), error.hint().c_str());
  } catch (const std::bad_alloc&) {
    return fail(OFFING_FAILED, "out of memory", "ask for fewer points at a time, or smaller maps");
  } catch (const std::exception& error) {
    return fail(OFFING_FAILED, error.what(), "");
  }
}

void require(const void* argument, const char* name) {
  if (argument != nullptr) return;
  throw Error(ErrorKind::bad_usage, fmt::format("{}: expected a pointer, got NULL", name),
              "pass what offing.h asks for");
}

OffingSample to_sample(const offing::ocean::WaterSample& water) {
  const auto normal = offing::ocean::normal_of(water);
  return {.height_m = water.height_m,
          .normal = {normal[0], normal[1], normal[2]},
          .velocity_mps = {water.velocity_x_mps, water.velocity_y_mps, water.velocity_z_mps},
          .pressure_pa = water.pressure_pa,
          .residual_m = water.residual_m};
}

std::vector<float> read_field(offing::ocean::Ocean& ocean, int cascade, OffingField field) {
  if (field == OFFING_FOAM) return ocean.read_foam(cascade);
  offing::ocean::SurfaceFields surface = ocean.read_surface(cascade);
  switch (field) {
    case OFFING_DISPLACEMENT_X:
      return std::move(surface.displacement_x);
    case OFFING_DISPLACEMENT_Y:
      return std::move(surface.displacement_y);
    case OFFING_DISPLACEMENT_Z:
      return std::move(surface.displacement_z);
    case OFFING_SLOPE_X:
      return std::move(surface.slope_x);
    case OFFING_SLOPE_Z:
      return std::move(surface.slope_z);
    case OFFING_JACOBIAN:
      return std::move(surface.jacobian);
    case OFFING_FOAM:
      break;
  }
  throw Error(ErrorKind::bad_usage,
              fmt::format("field: expected an OffingField, got {}", static_cast<int>(field)),
              "use one of the names in offing.h");
}

}  // namespace

const char* offing_version(void) {
  static const std::string version(offing::scene::version());
  return version.c_str();
}

int offing_interface(void) {
  return OFFING_INTERFACE;
}

const char* offing_last_error(void) {
  return last_failure.error.c_str();
}

const char* offing_last_hint(void) {
  return last_failure.hint.c_str();
}

OffingStatus offing_open_device(const char* selector, OffingDevice** device) {
  return run([&] {
    require(device, "device");
    *device = new OffingDevice{offing::ocl::Device::open(selector == nullptr ? "" : selector)};
  });
}

const char* offing_device_name(const OffingDevice* device) {
  return device == nullptr ? "" : device->device.info().name.c_str();
}

void offing_close_device(OffingDevice* device) {
  delete device;
}

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

void offing_free_scene(OffingScene* scene) {
  delete scene;
}

OffingStatus offing_make_world(const OffingDevice* device, const OffingScene* scene, OffingWorld** world) {
  return run([&] {
    require(device, "device");
    require(scene, "scene");
    require(world, "world");
    auto made = std::unique_ptr<OffingWorld>(new OffingWorld{
        scene->scene, offing::world::World(device->device, offing::scene::prepare_world(scene->scene))});
    offing::scene::show_at(made->world, made->scene, made->scene.time.start_s);
    *world = made.release();
  });
}

void offing_free_world(OffingWorld* world) {
  delete world;
}

OffingStatus offing_frame(OffingWorld* world, double time_s) {
  return run([&] {
    require(world, "world");
    offing::scene::show_at(world->world, world->scene, time_s);
  });
}

OffingStatus offing_sample(OffingWorld* world, const OffingQuery* query, const OffingPoint* points,
                           size_t count, OffingSample* samples) {
  return run([&] {
    require(world, "world");
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
  return run([&] {
    require(world, "world");
    require(values, "values");
    const std::vector<float> map = read_field(world->world.ocean(), cascade, field);
    if (map.size() != count) {
      throw Error(ErrorKind::bad_usage, fmt::format("count: expected {}, got {}", map.size(), count),
                  "a map has offing_map_size() squared values");
    }
    std::copy(map.begin(), map.end(), values);
  });
}
