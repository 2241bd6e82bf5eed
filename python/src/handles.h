#pragma once

#include <cstdint>
#include <filesystem>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bind.h"

/// The classes of the module that others take as arguments: thin owners of the handles of offing.h.

using Values = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using Table = nb::ndarray<const double, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

inline nb::dict dict_of(const OffingDeviceInfo& info) {
  nb::dict values;
  values["index"] = info.index;
  values["name"] = str_of(info.name);
  values["type"] = str_of(info.type);
  values["vendor"] = str_of(info.vendor);
  values["platform"] = str_of(info.platform);
  values["driver"] = str_of(info.driver);
  values["memory_bytes"] = info.memory_bytes;
  values["compute_units"] = info.compute_units;
  return values;
}

inline void* handle_of(std::uintptr_t number) {
  return reinterpret_cast<void*>(number);
}
inline std::uintptr_t number_of(void* handle) {
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
  static Spectra read(const std::filesystem::path& file) {
    OffingSpectra* spectra = nullptr;
    run([&] { return offing_read_spectra(file.c_str(), &spectra); });
    return Spectra(spectra);
  }
  static Spectra make(const Values& frequencies_hz, const std::optional<Values>& energy,
                      const std::optional<Values>& directions_rad, const std::optional<Table>& density,
                      double latitude_deg, double longitude_deg, double depth_m, const std::string& station,
                      const std::string& time_utc) {
    const std::size_t frequencies = frequencies_hz.size(),
                      directions = directions_rad ? directions_rad->size() : 0;
    if (!energy && directions == 0)
      throw nb::value_error("expected energy, or density with directions_rad, got neither");
    if (energy && energy->size() != frequencies)
      throw nb::value_error("energy: expected one value for each frequency");
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
    values["station"] = str_of(found.station);
    values["time_utc"] = str_of(found.time_utc);
    return values;
  }
  OffingSpectra* get() const { return spectra_.get(); }

 private:
  Owned<OffingSpectra, offing_free_spectra> spectra_;
};

constexpr double degrees(double angle_rad) {
  return angle_rad * 180.0 / std::numbers::pi;
}

class Scene {
 public:
  static Scene load(const std::filesystem::path& file) {
    OffingScene* scene = nullptr;
    run([&] { return offing_load_scene(file.c_str(), &scene); });
    return Scene(scene);
  }
  /// A text of the user's, or one that was made of a dict.
  static Scene parse(const std::string& text, const std::filesystem::path& folder, bool is_made) {
    const auto call = is_made ? offing_parse_values : offing_parse_scene;
    OffingScene* scene = nullptr;
    run([&] { return call(text.c_str(), folder.c_str(), &scene); });
    return Scene(scene);
  }

  void set_spectrum(const Spectra& spectra, std::size_t index) {
    run([&] { return offing_set_spectrum(get(), spectra.get(), index); });
  }
  Spectra tabulate_spectrum(const Values& frequencies_hz, std::size_t directions) const {
    OffingSpectra* spectra = nullptr;
    run([&] {
      return offing_tabulate_spectrum(get(), frequencies_hz.data(), frequencies_hz.size(), directions,
                                      &spectra);
    });
    return Spectra(spectra);
  }
  nb::dict sea_state() const {
    OffingSeaState found{};
    found.size = sizeof found;
    run([&] { return offing_get_sea_state(get(), &found); });
    nb::dict values;
    values["hs_m"] = found.hs_m;
    values["peak_period_s"] = found.peak_period_s;
    values["tp_s"] = found.tp_s;
    values["tm01_s"] = found.tm01_s;
    values["tm02_s"] = found.tm02_s;
    values["tz_s"] = found.tm02_s;
    values["mean_direction_rad"] = found.mean_direction_rad;
    values["peak_direction_rad"] = found.peak_direction_rad;
    values["spread_rad"] = found.spread_rad;
    values["mss"] = found.mss;
    return values;
  }
  /// {"asked", "resolved", "measured", "standard_error", "foam"}, as `offing ocean stats --json` has them.
  nb::dict measure(const Device& device, int seeds, const nb::object& progress) const {
    OffingSeaStatistics found{};
    found.size = sizeof found;
    Watched(progress).run([&](const OffingProgress* watching) {
      return offing_measure_sea(device.get(), get(), seeds, watching, &found);
    });
    const auto state = [](double hs_m, double tp_s, double tm01_s, double tm02_s, double direction_rad,
                          double mss) {
      nb::dict values;
      values["hs_m"] = hs_m;
      values["tp_s"] = tp_s;
      values["tm01_s"] = tm01_s;
      values["tm02_s"] = tm02_s;
      values["mean_direction_deg"] = degrees(direction_rad);
      values["mean_direction_rad"] = direction_rad;
      values["mss"] = mss;
      return values;
    };
    const auto add_peak = [](nb::dict& values, double period_s, double direction_rad, double spread_rad) {
      values["peak_period_s"] = period_s;
      values["tz_s"] = values["tm02_s"];
      values["peak_direction_deg"] = degrees(direction_rad);
      values["peak_direction_rad"] = direction_rad;
      values["spread_deg"] = degrees(spread_rad);
      values["spread_rad"] = spread_rad;
    };
    nb::dict values, errors;
    nb::dict asked = state(found.asked_hs_m, found.asked_tp_s, found.asked_tm01_s, found.asked_tm02_s,
                           found.asked_mean_direction_rad, found.asked_mss);
    nb::dict resolved = state(found.resolved_hs_m, found.resolved_tp_s, found.resolved_tm01_s,
                              found.resolved_tm02_s, found.resolved_mean_direction_rad, found.resolved_mss);
    nb::dict measured =
        state(found.hs_m, found.tp_s, found.tm01_s, found.tm02_s, found.mean_direction_rad, found.mss);
    measured["skewness"] = found.skewness;
    measured["kurtosis"] = found.kurtosis;
    measured["max_ka"] = found.max_ka;
    measured["folded_share"] = found.folded_share;
    add_peak(asked, found.asked_peak_period_s, found.asked_peak_direction_rad, found.asked_spread_rad);
    add_peak(resolved, found.resolved_peak_period_s, found.resolved_peak_direction_rad,
             found.resolved_spread_rad);
    add_peak(measured, found.peak_period_s, found.peak_direction_rad, found.spread_rad);
    values["asked"] = asked;
    values["resolved"] = resolved;
    values["measured"] = measured;
    errors["hs_m"] = found.hs_standard_error_m;
    errors["peak_period_s"] = found.peak_period_standard_error_s;
    errors["tm02_s"] = found.tm02_standard_error_s;
    errors["mean_direction_deg"] = degrees(found.mean_direction_standard_error_rad);
    errors["mean_direction_rad"] = found.mean_direction_standard_error_rad;
    values["standard_error"] = errors;
    nb::dict foam;
    foam["asked"] = found.asked_foam_fraction;
    foam["measured"] = found.foam_fraction;
    values["foam"] = foam;
    return values;
  }
  OffingScene* get() const { return scene_.get(); }

 private:
  explicit Scene(OffingScene* scene) : scene_(scene) {}
  Owned<OffingScene, offing_free_scene> scene_;
};

inline OffingWaterQuery query_of(double depth_m, double min_wavelength_m, int accuracy) {
  OffingWaterQuery query{};
  query.size = sizeof query;
  query.depth_m = depth_m;
  query.min_wavelength_m = min_wavelength_m;
  query.accuracy = accuracy;
  return query;
}

class World {
 public:
  World(const Device& device, const Scene& scene, const nb::object& progress) {
    OffingWorld* world = nullptr;
    Watched(progress).run([&](const OffingProgress* watching) {
      const OffingWorldOptions options{sizeof options, watching};
      return offing_make_world_with(device.get(), scene.get(), &options, &world);
    });
    world_.reset(world);
  }

  void frame(double time_s) {
    run([&] { return offing_frame(get(), time_s); });
  }
  double time_s() const {
    double time_s = 0.0;
    run([&] { return offing_get_time(get(), &time_s); });
    return time_s;
  }

  /// [n, 12], as OffingWater.full_samples.
  nb::ndarray<nb::numpy, float> sample(const Rows<2>& points_m, double depth_m, double min_wavelength_m,
                                       bool wants_flow, int accuracy) {
    const std::size_t count = points_m.shape(0);
    auto samples = new_array<float>({count, 12});
    OffingWater water{};
    water.size = sizeof water;
    water.full_samples = samples.data();
    OffingWaterQuery query = query_of(depth_m, min_wavelength_m, accuracy);
    query.is_surface_only = wants_flow ? 0 : 1;
    run([&] { return offing_sample_water(get(), &query, points_m.data(), count, &water); });
    return samples;
  }
  void sample_on_device(std::uintptr_t points, std::size_t count, std::uintptr_t samples, double depth_m,
                        double min_wavelength_m, int accuracy, bool is_full) {
    OffingWaterQuery query = query_of(depth_m, min_wavelength_m, accuracy);
    query.is_full = is_full ? 1 : 0;
    run([&] {
      return offing_sample_water_on_device(get(), &query, handle_of(points), count, handle_of(samples));
    });
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
    run([&] {
      return offing_copy_field(get(), cascade, static_cast<OffingField>(field), handle_of(buffer), first);
    });
  }
  void write_modes(const std::string& file) {
    run([&] { return offing_write_modes(get(), file.c_str()); });
  }
  OffingWorld* get() const { return world_.get(); }

 private:
  Owned<OffingWorld, offing_free_world> world_;
};
