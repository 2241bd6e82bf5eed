// offing._core: the calls of offing.h for Python. The modules in python/offing wrap them in the classes that
// users see.
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "handles.h"
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

using namespace nb::literals;

namespace {

nb::list list_devices() {
  std::size_t count = 0;
  run([&] { return offing_list_devices(nullptr, 0, &count); });
  std::vector<OffingDeviceInfo> devices(count);
  for (OffingDeviceInfo& info : devices) info.size = sizeof info;
  run([&] { return offing_list_devices(devices.data(), devices.size(), &count); });
  nb::list values;
  for (const OffingDeviceInfo& info : devices) values.append(dict_of(info));
  return values;
}

class Renderer {
 public:
  Renderer(const Device& device, const Scene& scene) {
    OffingRenderer* renderer = nullptr;
    run([&] { return offing_make_renderer(device.get(), scene.get(), &renderer); });
    renderer_.reset(renderer);
  }

  /// sRGB bytes.
  nb::ndarray<nb::numpy, std::uint8_t> render(double time_s, int width_px, int height_px) {
    auto rgb = new_array<std::uint8_t>({picture_side(height_px), picture_side(width_px), 3});
    draw(time_s, width_px, height_px, rgb.data(), nullptr);
    return rgb;
  }
  /// Linear light.
  nb::ndarray<nb::numpy, float> render_light(double time_s, int width_px, int height_px) {
    auto light = new_array<float>({picture_side(height_px), picture_side(width_px), 3});
    draw(time_s, width_px, height_px, nullptr, light.data());
    return light;
  }

 private:
  void draw(double time_s, int width_px, int height_px, std::uint8_t* rgb, float* light) {
    OffingPicture picture{};
    picture.size = sizeof picture;
    picture.width_px = width_px;
    picture.height_px = height_px;
    picture.time_s = time_s;
    picture.rgb = rgb;
    picture.light = light;
    run([&] { return offing_render(renderer_.get(), &picture); });
  }

  Owned<OffingRenderer, offing_free_renderer> renderer_;
};

/// The callback of the log; none after the interpreter has ended.
nb::object& log_callback() {
  static nb::object callback;
  return callback;
}

void set_log(const nb::object& callback) {
  if (callback.is_none()) {
    run([] { return offing_set_log(nullptr, nullptr); });
    log_callback() = nb::object();
    return;
  }
  log_callback() = callback;
  run([] {
    return offing_set_log(
        [](void*, OffingLogLevel level, const char* line) {
          const nb::gil_scoped_acquire acquired;
          try {
            const nb::object callback = log_callback();  // which another thread may replace meanwhile
            if (callback.is_valid()) callback(static_cast<int>(level), str_of(line));
          } catch (nb::python_error& error) {
            error.discard_as_unraisable("offing.set_log");
          }
        },
        nullptr);
  });
}

}  // namespace

NB_MODULE(_core, module) {
  module.doc() = "The calls of offing.h. Use the classes of offing instead.";
  module.def("version", [] { return offing_version(); });
  module.def("list_devices", list_devices);
  module.def("set_log", set_log, "callback"_a.none());
  module.def("forget_log", [] {
    run([] { return offing_set_log(nullptr, nullptr); });
    log_callback() = nb::object();
  });

  nb::class_<Device>(module, "Device")
      .def(nb::init<std::optional<std::string>>(), "selector"_a.none() = nb::none())
      .def_static("adopt", &Device::adopt, "context"_a, "queue"_a)
      .def("info", &Device::info)
      .def("finish", &Device::finish)
      .def_prop_ro("context",
                   [](const Device& device) { return number_of(offing_device_context(device.get())); })
      .def_prop_ro("queue",
                   [](const Device& device) { return number_of(offing_device_queue(device.get())); });
  nb::class_<Spectra>(module, "Spectra")
      .def_static("read", &Spectra::read, "file"_a)
      .def_static("make", &Spectra::make, "frequencies_hz"_a, "energy"_a.none(), "directions_rad"_a.none(),
                  "density"_a.none(), "latitude_deg"_a, "longitude_deg"_a, "depth_m"_a, "station"_a,
                  "time_utc"_a)
      .def("__len__", &Spectra::size)
      .def("at", &Spectra::at, "index"_a);
  nb::class_<Scene>(module, "Scene")
      .def_static("load", &Scene::load, "file"_a)
      .def_static("parse", &Scene::parse, "text"_a, "folder"_a, "is_made"_a)
      .def("set_spectrum", &Scene::set_spectrum, "spectra"_a, "index"_a)
      .def("tabulate_spectrum", &Scene::tabulate_spectrum, "frequencies_hz"_a, "directions"_a)
      .def("sea_state", &Scene::sea_state)
      .def("measure", &Scene::measure, "device"_a, "seeds"_a, "progress"_a.none());
  nb::class_<Renderer>(module, "Renderer")
      .def(nb::init<const Device&, const Scene&>(), "device"_a, "scene"_a)
      .def("render", &Renderer::render, "time_s"_a, "width_px"_a, "height_px"_a)
      .def("render_light", &Renderer::render_light, "time_s"_a, "width_px"_a, "height_px"_a);
  nb::class_<World>(module, "World")
      .def(nb::init<const Device&, const Scene&, const nb::object&>(), "device"_a, "scene"_a,
           "progress"_a.none())
      .def("frame", &World::frame, "time_s"_a)
      .def_prop_ro("time_s", &World::time_s)
      .def("sample", &World::sample, "points_m"_a, "depth_m"_a, "min_wavelength_m"_a, "wants_flow"_a,
           "accuracy"_a)
      .def("sample_on_device", &World::sample_on_device, "points"_a, "count"_a, "samples"_a, "depth_m"_a,
           "min_wavelength_m"_a, "accuracy"_a, "is_full"_a)
      .def_prop_ro("cascade_count", &World::cascade_count)
      .def_prop_ro("map_size", &World::map_size)
      .def("patch_length_m", &World::patch_length_m, "cascade"_a)
      .def("read_fields", &World::read_fields, "fields"_a, "cascade"_a)
      .def("write_modes", &World::write_modes, "file"_a)
      .def("copy_field", &World::copy_field, "field"_a, "buffer"_a, "first"_a, "cascade"_a);
  bind_mesh(module);
  bind_terrain(module);
  bind_world_parts(module);
}
