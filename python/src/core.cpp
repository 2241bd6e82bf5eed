// offing._core: the calls of offing.h for Python. The modules beside it make the classes that users see of them.
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <offing.h>

namespace nb = nanobind;
using namespace nb::literals;

namespace {

/// Raises the class of offing.errors that a status stands for.
[[noreturn]] void raise(OffingStatus status) {
  const nb::object make = nb::module_::import_("offing.errors").attr("from_status");
  const nb::object error = make(static_cast<int>(status), offing_last_error(), offing_last_hint());
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(error.ptr())), error.ptr());
  throw nb::python_error();
}

/// Runs a call of offing.h without Python's lock.
template <class Call>
void run(const Call& call) {
  OffingStatus status = OFFING_OK;
  {
    const nb::gil_scoped_release released;
    status = call();
  }
  if (status != OFFING_OK) raise(status);
}

/// A handle of offing.h and the call that frees it.
template <class Handle, void (*free_handle)(Handle*)>
struct Free {
  void operator()(Handle* handle) const { free_handle(handle); }
};
template <class Handle, void (*free_handle)(Handle*)>
using Owned = std::unique_ptr<Handle, Free<Handle, free_handle>>;

/// A new array of numpy's that owns its memory, not yet filled.
template <class Value>
nb::ndarray<nb::numpy, Value> new_array(std::initializer_list<std::size_t> shape) {
  std::size_t count = 1;
  for (const std::size_t length : shape) count *= length;
  auto memory = std::make_unique_for_overwrite<Value[]>(count);
  Value* const data = memory.get();
  const nb::capsule owner(memory.release(), [](void* values) noexcept { delete[] static_cast<Value*>(values); });
  return {data, shape, owner};
}

nb::ndarray<nb::numpy, double> copied(const double* values, std::initializer_list<std::size_t> shape) {
  auto array = new_array<double>(shape);
  std::copy(values, values + array.size(), array.data());
  return array;
}

using Values = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using Table = nb::ndarray<const double, nb::ndim<2>, nb::c_contig, nb::device::cpu>;
using Points = nb::ndarray<const double, nb::shape<-1, 2>, nb::c_contig, nb::device::cpu>;

nb::dict dict_of(const OffingDeviceInfo& info) {
  nb::dict values;
  values["index"] = info.index;
  values["name"] = info.name;
  values["type"] = info.type;
  values["vendor"] = info.vendor;
  values["platform"] = info.platform;
  values["driver"] = info.driver;
  values["memory_bytes"] = info.memory_bytes;
  values["compute_units"] = info.compute_units;
  return values;
}

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

void* handle_of(std::uintptr_t number) {
  return reinterpret_cast<void*>(number);
}
std::uintptr_t number_of(void* handle) {
  return reinterpret_cast<std::uintptr_t>(handle);
}

class Device {
 public:
  explicit Device(const std::optional<std::string>& selector) {
    OffingDevice* device = nullptr;
    run([&] { return offing_open_device(selector ? selector->c_str() : nullptr, &device); });
    device_.reset(device);
  }
  static Device adopt(std::uintptr_t context, std::uintptr_t queue) {
    OffingDevice* device = nullptr;
    run([&] { return offing_adopt_device(handle_of(context), handle_of(queue), &device); });
    return Device(device);
  }

  nb::dict info() const {
    OffingDeviceInfo values{};
    values.size = sizeof values;
    run([&] { return offing_get_device_info(get(), &values); });
    return dict_of(values);
  }
  void finish() const {
    run([&] { return offing_finish_device(get()); });
  }
  OffingDevice* get() const { return device_.get(); }

 private:
  explicit Device(OffingDevice* device) : device_(device) {}
  Owned<OffingDevice, offing_close_device> device_;
};

/// A list of spectra that does not change.
class Spectra {
 public:
  explicit Spectra(OffingSpectra* spectra) : spectra_(spectra) {}
  static Spectra read(const std::string& file) {
    OffingSpectra* spectra = nullptr;
    run([&] { return offing_read_spectra(file.c_str(), &spectra); });
    return Spectra(spectra);
  }
  static Spectra make(const Values& frequencies_hz, const std::optional<Values>& energy,
                      const std::optional<Values>& directions_rad, const std::optional<Table>& density,
                      double latitude_deg, double longitude_deg, double depth_m, const std::string& station,
                      const std::string& time_utc) {
    const std::size_t frequencies = frequencies_hz.size(), directions = directions_rad ? directions_rad->size() : 0;
    if (energy && energy->size() != frequencies) throw nb::value_error("energy: expected one value for each frequency");
    if (directions > 0 && (!density || density->shape(0) != frequencies || density->shape(1) != directions)) {
      throw nb::value_error("density: expected an array of the shape (frequencies, directions)");
    }
    OffingSpectrum values{};
    values.size = sizeof values;
    values.frequency_count = frequencies;
    values.direction_count = directions;
    values.frequencies_hz = frequencies_hz.data();
    values.energy_m2phz = energy ? energy->data() : nullptr;
    values.directions_rad = directions_rad ? directions_rad->data() : nullptr;
    values.density = density ? density->data() : nullptr;
    values.latitude_deg = latitude_deg;
    values.longitude_deg = longitude_deg;
    values.depth_m = depth_m;
    values.station = station.c_str();
    values.time_utc = time_utc.c_str();
    OffingSpectra* spectra = nullptr;
    run([&] { return offing_make_spectrum(&values, &spectra); });
    return Spectra(spectra);
  }

  std::size_t size() const { return offing_spectrum_count(get()); }
  nb::dict at(std::size_t index) const {
    OffingSpectrum found{};
    found.size = sizeof found;
    run([&] { return offing_get_spectrum(get(), index, &found); });
    nb::dict values;
    values["frequencies_hz"] = copied(found.frequencies_hz, {found.frequency_count});
    values["energy"] = copied(found.energy_m2phz, {found.frequency_count});
    values["directions_rad"] = copied(found.directions_rad, {found.direction_count});
    values["density"] = found.direction_count == 0
                            ? nb::object(nb::none())
                            : nb::cast(copied(found.density, {found.frequency_count, found.direction_count}));
    values["latitude_deg"] = found.latitude_deg;
    values["longitude_deg"] = found.longitude_deg;
    values["depth_m"] = found.depth_m;
    values["station"] = found.station;
    values["time_utc"] = found.time_utc;
    return values;
  }
  OffingSpectra* get() const { return spectra_.get(); }

 private:
  Owned<OffingSpectra, offing_free_spectra> spectra_;
};

class Scene {
 public:
  static Scene load(const std::string& file) {
    OffingScene* scene = nullptr;
    run([&] { return offing_load_scene(file.c_str(), &scene); });
    return Scene(scene);
  }
  static Scene parse(const std::string& text, const std::optional<std::string>& folder) {
    OffingScene* scene = nullptr;
    run([&] { return offing_parse_scene(text.c_str(), folder ? folder->c_str() : nullptr, &scene); });
    return Scene(scene);
  }

  void set_spectrum(const Spectra& spectra, std::size_t index) {
    run([&] { return offing_set_spectrum(get(), spectra.get(), index); });
  }
  Spectra tabulate_spectrum(const Values& frequencies_hz, std::size_t directions) const {
    OffingSpectra* spectra = nullptr;
    run([&] {
      return offing_tabulate_spectrum(get(), frequencies_hz.data(), frequencies_hz.size(), directions, &spectra);
    });
    return Spectra(spectra);
  }
  nb::dict sea_state() const {
    OffingSeaState found{};
    found.size = sizeof found;
    run([&] { return offing_get_sea_state(get(), &found); });
    nb::dict values;
    values["hs_m"] = found.hs_m;
    values["tp_s"] = found.tp_s;
    values["tm01_s"] = found.tm01_s;
    values["tm02_s"] = found.tm02_s;
    values["mean_direction_rad"] = found.mean_direction_rad;
    values["mss"] = found.mss;
    return values;
  }
  OffingScene* get() const { return scene_.get(); }

 private:
  explicit Scene(OffingScene* scene) : scene_(scene) {}
  Owned<OffingScene, offing_free_scene> scene_;
};

OffingWaterQuery query_of(double depth_m, double min_wavelength_m) {
  OffingWaterQuery query{};
  query.size = sizeof query;
  query.depth_m = depth_m;
  query.min_wavelength_m = min_wavelength_m;
  return query;
}

class World {
 public:
  World(const Device& device, const Scene& scene) {
    OffingWorld* world = nullptr;
    run([&] { return offing_make_world(device.get(), scene.get(), &world); });
    world_.reset(world);
  }

  void frame(double time_s) {
    run([&] { return offing_frame(get(), time_s); });
  }

  /// (height, normal, velocity, pressure, residual); None for flow that is not wanted.
  nb::tuple sample(const Points& points_m, double depth_m, double min_wavelength_m, bool wants_flow) {
    const std::size_t count = points_m.shape(0);
    auto height = new_array<float>({count}), residual = new_array<float>({count}), normal = new_array<float>({count, 3});
    auto velocity = new_array<float>({wants_flow ? count : 0, 3}), pressure = new_array<float>({wants_flow ? count : 0});
    OffingWater water{};
    water.size = sizeof water;
    water.height_m = height.data();
    water.normal = normal.data();
    water.residual_m = residual.data();
    if (wants_flow) {
      water.velocity_mps = velocity.data();
      water.pressure_pa = pressure.data();
    }
    const OffingWaterQuery query = query_of(depth_m, min_wavelength_m);
    run([&] { return offing_sample_water(get(), &query, points_m.data(), count, &water); });
    if (!wants_flow) return nb::make_tuple(height, normal, nb::none(), nb::none(), residual);
    return nb::make_tuple(height, normal, velocity, pressure, residual);
  }
  void sample_on_device(std::uintptr_t points, std::size_t count, std::uintptr_t samples, double depth_m,
                        double min_wavelength_m) {
    const OffingWaterQuery query = query_of(depth_m, min_wavelength_m);
    run([&] { return offing_sample_water_on_device(get(), &query, handle_of(points), count, handle_of(samples)); });
  }

  std::size_t cascade_count() const { return static_cast<std::size_t>(offing_cascade_count(get())); }
  std::size_t map_size() const { return static_cast<std::size_t>(offing_map_size(get())); }
  double patch_length_m(int cascade) const { return offing_patch_length_m(get(), cascade); }

  nb::list read_fields(const std::vector<int>& fields, int cascade) {
    const std::size_t n = map_size();
    std::vector<nb::ndarray<nb::numpy, float>> maps;
    std::vector<float*> values;
    std::vector<OffingField> names;
    for (const int field : fields) {
      maps.push_back(new_array<float>({n, n}));
      values.push_back(maps.back().data());
      names.push_back(static_cast<OffingField>(field));
    }
    run([&] { return offing_read_fields(get(), cascade, names.data(), names.size(), values.data(), n * n); });
    nb::list found;
    for (const auto& map : maps) found.append(map);
    return found;
  }
  void copy_field(int field, std::uintptr_t buffer, std::size_t first, int cascade) {
    run([&] { return offing_copy_field(get(), cascade, static_cast<OffingField>(field), handle_of(buffer), first); });
  }
  OffingWorld* get() const { return world_.get(); }

 private:
  Owned<OffingWorld, offing_free_world> world_;
};

class Renderer {
 public:
  Renderer(const Device& device, const Scene& scene) {
    OffingRenderer* renderer = nullptr;
    run([&] { return offing_make_renderer(device.get(), scene.get(), &renderer); });
    renderer_.reset(renderer);
  }

  /// sRGB bytes.
  nb::ndarray<nb::numpy, std::uint8_t> render(double time_s, int width_px, int height_px) {
    auto rgb = new_array<std::uint8_t>({side(height_px), side(width_px), 3});
    draw(time_s, width_px, height_px, rgb.data(), nullptr);
    return rgb;
  }
  /// Linear light.
  nb::ndarray<nb::numpy, float> render_light(double time_s, int width_px, int height_px) {
    auto light = new_array<float>({side(height_px), side(width_px), 3});
    draw(time_s, width_px, height_px, nullptr, light.data());
    return light;
  }

 private:
  /// Of the array for a picture: sizes that are none make an empty one and are refused by the call.
  static std::size_t side(int length_px) { return length_px < 1 || length_px > 16384 ? 0 : static_cast<std::size_t>(length_px); }
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
            if (log_callback().is_valid()) log_callback()(static_cast<int>(level), line);
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
  module.def("forget_log", [] { log_callback() = nb::object(); offing_set_log(nullptr, nullptr); });

  nb::class_<Device>(module, "Device")
      .def(nb::init<std::optional<std::string>>(), "selector"_a.none() = nb::none())
      .def_static("adopt", &Device::adopt, "context"_a, "queue"_a)
      .def("info", &Device::info)
      .def("finish", &Device::finish)
      .def_prop_ro("context", [](const Device& device) { return number_of(offing_device_context(device.get())); })
      .def_prop_ro("queue", [](const Device& device) { return number_of(offing_device_queue(device.get())); });
  nb::class_<Spectra>(module, "Spectra")
      .def_static("read", &Spectra::read, "file"_a)
      .def_static("make", &Spectra::make, "frequencies_hz"_a, "energy"_a.none(), "directions_rad"_a.none(),
                  "density"_a.none(), "latitude_deg"_a, "longitude_deg"_a, "depth_m"_a, "station"_a, "time_utc"_a)
      .def("__len__", &Spectra::size)
      .def("at", &Spectra::at, "index"_a);
  nb::class_<Scene>(module, "Scene")
      .def_static("load", &Scene::load, "file"_a)
      .def_static("parse", &Scene::parse, "text"_a, "folder"_a.none())
      .def("set_spectrum", &Scene::set_spectrum, "spectra"_a, "index"_a)
      .def("tabulate_spectrum", &Scene::tabulate_spectrum, "frequencies_hz"_a, "directions"_a)
      .def("sea_state", &Scene::sea_state);
  nb::class_<Renderer>(module, "Renderer")
      .def(nb::init<const Device&, const Scene&>(), "device"_a, "scene"_a)
      .def("render", &Renderer::render, "time_s"_a, "width_px"_a, "height_px"_a)
      .def("render_light", &Renderer::render_light, "time_s"_a, "width_px"_a, "height_px"_a);
  nb::class_<World>(module, "World")
      .def(nb::init<const Device&, const Scene&>(), "device"_a, "scene"_a)
      .def("frame", &World::frame, "time_s"_a)
      .def("sample", &World::sample, "points_m"_a, "depth_m"_a, "min_wavelength_m"_a, "wants_flow"_a)
      .def("sample_on_device", &World::sample_on_device, "points"_a, "count"_a, "samples"_a, "depth_m"_a,
           "min_wavelength_m"_a)
      .def_prop_ro("cascade_count", &World::cascade_count)
      .def_prop_ro("map_size", &World::map_size)
      .def("patch_length_m", &World::patch_length_m, "cascade"_a)
      .def("read_fields", &World::read_fields, "fields"_a, "cascade"_a)
      .def("copy_field", &World::copy_field, "field"_a, "buffer"_a, "first"_a, "cascade"_a);
}
