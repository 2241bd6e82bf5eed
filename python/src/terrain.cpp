// Terrain: height maps, rays, lines of sight, viewsheds, lakes, sky and sun.
#include <algorithm>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "handles.h"
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>

using namespace nb::literals;

namespace {

using Heights = nb::ndarray<const float, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

OffingTerrainQuery query_of(bool smooth_normals, double earth_radius_m, double refraction) {
  OffingTerrainQuery query{};
  query.size = sizeof query;
  query.has_smooth_normals = smooth_normals ? 1 : 0;
  query.earth_radius_m = earth_radius_m;
  query.refraction = refraction;
  return query;
}

class Terrain {
 public:
  static Terrain open(const Device& device, const std::filesystem::path& file, double spacing_x_m,
                      double spacing_z_m, double vertical_scale, double offset_m,
                      std::optional<double> nodata, std::optional<double> void_height_m,
                      const std::optional<std::string>& reproject_to, bool untrusted, int band) {
    OffingTerrainOptions options{};
    options.size = sizeof options;
    options.spacing_x_m = spacing_x_m;
    options.spacing_z_m = spacing_z_m;
    options.vertical_scale = vertical_scale;
    options.offset_m = offset_m;
    options.nodata = nodata ? &*nodata : nullptr;
    options.void_height_m = void_height_m ? &*void_height_m : nullptr;
    options.reproject_to = reproject_to ? reproject_to->c_str() : nullptr;
    options.is_untrusted = untrusted ? 1 : 0;
    options.band = band;
    OffingTerrain* terrain = nullptr;
    run([&] { return offing_open_terrain(device.get(), file.c_str(), &options, &terrain); });
    return Terrain(terrain);
  }
  static Terrain make(const Device& device, const Heights& heights_m, double spacing_x_m,
                      double spacing_z_m) {
    OffingTerrain* terrain = nullptr;
    run([&] {
      return offing_make_terrain(device.get(), heights_m.data(), static_cast<int>(heights_m.shape(1)),
                                 static_cast<int>(heights_m.shape(0)), spacing_x_m, spacing_z_m, &terrain);
    });
    return Terrain(terrain);
  }

  nb::dict info() {
    const OffingTerrainInfo found = read_info();
    nb::dict values;
    values["columns"] = found.columns;
    values["rows"] = found.rows;
    values["spacing_x_m"] = found.spacing_x_m;
    values["spacing_z_m"] = found.spacing_z_m;
    values["lowest_m"] = found.lowest_m;
    values["highest_m"] = found.highest_m;
    values["void_posts"] = found.void_posts;
    values["origin_x"] = found.origin_x;
    values["origin_y"] = found.origin_y;
    values["step_x"] = found.step_x;
    values["step_y"] = found.step_y;
    values["centre_latitude_deg"] = found.centre_latitude_deg;
    values["centre_longitude_deg"] = found.centre_longitude_deg;
    values["coordinate_system"] = str_of(found.coordinate_system);
    values["coordinate_system_wkt"] = str_of(found.coordinate_system_wkt);
    values["format"] = str_of(found.format);
    values["is_spacing_assumed"] = found.is_spacing_assumed != 0;
    return values;
  }

  /// (heights, is_void)
  nb::tuple read() {
    const auto [rows, columns] = shape();
    auto heights = new_array<float>({rows, columns});
    auto voids = new_array<bool>({rows, columns});
    run([&] {
      return offing_read_terrain(terrain_.get(), heights.data(),
                                 reinterpret_cast<std::uint8_t*>(voids.data()), rows * columns);
    });
    return nb::make_tuple(heights, voids);
  }

  /// (height, normal, is_measured)
  nb::tuple sample(const Rows<2>& points_m, bool smooth_normals) {
    const std::size_t count = points_m.shape(0);
    auto height = new_array<double>({count}), normal = new_array<double>({count, 3});
    auto measured = new_array<bool>({count});
    const OffingTerrainSamples samples{sizeof samples, height.data(), normal.data(),
                                       reinterpret_cast<std::uint8_t*>(measured.data())};
    const OffingTerrainQuery query = query_of(smooth_normals, 0.0, 0.0);
    run([&] { return offing_sample_terrain(terrain_.get(), &query, points_m.data(), count, &samples); });
    return nb::make_tuple(height, normal, measured);
  }

  /// (distance, point, normal, kind)
  nb::tuple cast(const Rows<3>& origins_m, const Rows<3>& directions, double limit_m, bool smooth_normals,
                 double earth_radius_m, double refraction) {
    const std::size_t count = origins_m.shape(0);
    if (directions.shape(0) != count) throw nb::value_error("directions: expected one for each origin");
    auto distance = new_array<double>({count}), point = new_array<double>({count, 3});
    auto normal = new_array<float>({count, 3});
    auto kind = new_array<std::uint8_t>({count});
    const OffingHits hits{sizeof hits, distance.data(), point.data(), normal.data(), kind.data()};
    const OffingTerrainQuery query = query_of(smooth_normals, earth_radius_m, refraction);
    const auto limits = std::make_unique<double[]>(count);
    std::fill_n(limits.get(), count, limit_m);
    run([&] {
      return offing_cast_rays(terrain_.get(), &query, origins_m.data(), directions.data(), limits.get(),
                              count, &hits);
    });
    return nb::make_tuple(distance, point, normal, kind);
  }

  /// (is_visible, distance, hidden_at, hidden_by)
  nb::tuple trace_sight_lines(const Rows<3>& from_m, const Rows<3>& to_m, double earth_radius_m,
                              double refraction) {
    const std::size_t count = from_m.shape(0);
    if (to_m.shape(0) != count) throw nb::value_error("to_m: expected one for each place in from_m");
    auto visible = new_array<bool>({count});
    auto distance = new_array<double>({count}), hidden_at = new_array<double>({count}),
         hidden_by = new_array<double>({count, 3});
    const OffingSightLines lines{sizeof lines, reinterpret_cast<std::uint8_t*>(visible.data()),
                                 distance.data(), hidden_at.data(), hidden_by.data()};
    const OffingTerrainQuery query = query_of(false, earth_radius_m, refraction);
    run([&] {
      return offing_trace_sight_lines(terrain_.get(), &query, from_m.data(), to_m.data(), count, &lines);
    });
    return nb::make_tuple(visible, distance, hidden_at, hidden_by);
  }

  /// Places of a system as x and z on the terrain.
  nb::ndarray<nb::numpy, double> to_local(const Rows<2>& places, const std::string& system) {
    const std::size_t count = places.shape(0);
    auto places_m = new_array<double>({count, 2});
    run([&] {
      return offing_places_to_terrain(terrain_.get(), system.c_str(), places.data(), places_m.data(), count);
    });
    return places_m;
  }
  nb::ndarray<nb::numpy, double> from_local(const Rows<2>& places_m, const std::string& system) {
    const std::size_t count = places_m.shape(0);
    auto places = new_array<double>({count, 2});
    run([&] {
      return offing_places_from_terrain(terrain_.get(), system.c_str(), places_m.data(), places.data(),
                                        count);
    });
    return places;
  }

  nb::ndarray<nb::numpy, bool> viewshed(double x_m, double z_m, double observer_height_m,
                                        double target_height_m, double radius_m, double earth_radius_m,
                                        double refraction, std::pair<double, double> azimuth_rad,
                                        std::pair<double, double> elevation_rad) {
    const auto [rows, columns] = shape();
    auto seen = new_array<bool>({rows, columns});
    auto* const bytes = reinterpret_cast<std::uint8_t*>(seen.data());
    const OffingViewshed wanted{sizeof wanted,
                                x_m,
                                z_m,
                                observer_height_m,
                                target_height_m,
                                radius_m,
                                earth_radius_m,
                                refraction,
                                azimuth_rad.first,
                                azimuth_rad.second,
                                elevation_rad.first,
                                elevation_rad.second};
    run([&] {
      const OffingStatus status = offing_compute_viewshed(terrain_.get(), &wanted, bytes, rows * columns);
      for (std::size_t i = 0; status == OFFING_OK && i < rows * columns; ++i)
        bytes[i] = bytes[i] != 0 ? 1 : 0;
      return status;
    });
    return seen;
  }

  /// (counts, is_reached, seen_posts, reached_posts, only_posts, best, best_posts, is_best_exhaustive); each
  /// row of `settings` is the observer's height, the target's, the radius, two azimuths and two elevations.
  nb::tuple count_viewsheds(const Rows<2>& points_m, const Rows<7>& settings, double earth_radius_m,
                            double refraction, std::size_t best_count, const nb::object& progress) {
    const auto [rows, columns] = shape();
    const std::size_t observers = points_m.shape(0);
    if (settings.shape(0) != observers) throw nb::value_error("settings: expected a row for each point");
    auto counts = new_array<std::uint16_t>({rows, columns});
    auto reached = new_array<bool>({rows, columns});
    auto seen_posts = new_array<std::uint64_t>({observers}),
         reached_posts = new_array<std::uint64_t>({observers}),
         only_posts = new_array<std::uint64_t>({observers});
    auto best = new_array<std::uint64_t>({best_count}), best_posts = new_array<std::uint64_t>({best_count});
    std::vector<std::size_t> best_observers(best_count);
    int is_exhaustive = 0;
    std::vector<double> observer_height_m, target_height_m, radius_m, azimuth_rad, elevation_rad;
    for (std::size_t i = 0; i < observers; ++i) {
      observer_height_m.push_back(settings(i, 0));
      target_height_m.push_back(settings(i, 1));
      radius_m.push_back(settings(i, 2));
      azimuth_rad.insert(azimuth_rad.end(), {settings(i, 3), settings(i, 4)});
      elevation_rad.insert(elevation_rad.end(), {settings(i, 5), settings(i, 6)});
    }
    const OffingObservers given{
        sizeof given,           observers,       points_m.data(),    observer_height_m.data(),
        target_height_m.data(), radius_m.data(), azimuth_rad.data(), elevation_rad.data()};
    const OffingSightCounts wanted{
        sizeof wanted,     counts.data(),         reinterpret_cast<std::uint8_t*>(reached.data()),
        seen_posts.data(), reached_posts.data(),  only_posts.data(),
        best_count,        best_observers.data(), best_posts.data(),
        &is_exhaustive};
    OffingViewshed shared{};
    shared.size = sizeof shared;
    shared.earth_radius_m = earth_radius_m;
    shared.refraction = refraction;
    Watched(progress).run([&](const OffingProgress* watching) {
      return offing_count_viewsheds(terrain_.get(), &shared, &given, &wanted, rows * columns, watching);
    });
    std::copy(best_observers.begin(), best_observers.end(), best.data());
    return nb::make_tuple(counts, reached, seen_posts, reached_posts, only_posts, best, best_posts,
                          is_exhaustive != 0);
  }

  /// (level, spill level, spill place, area, volume, greatest depth, depth of each post, outline [n, 2] with
  /// NaN between rings)
  nb::tuple fill_lake(double x_m, double z_m, std::optional<double> level_m) {
    const auto [rows, columns] = shape();
    const double* const level = level_m ? &*level_m : nullptr;
    auto depth_m = new_array<float>({rows, columns});
    OffingLake lake{};
    lake.size = sizeof lake;
    run([&] {
      return offing_fill_lake(terrain_.get(), x_m, z_m, level, &lake, depth_m.data(), rows * columns, nullptr,
                              0);
    });
    auto outline_m = new_array<double>({static_cast<std::size_t>(lake.outline_count), 2});
    run([&] {
      return offing_fill_lake(terrain_.get(), x_m, z_m, level, nullptr, nullptr, 0, outline_m.data(),
                              lake.outline_count);
    });
    return nb::make_tuple(lake.level_m, lake.spill_level_m, std::pair(lake.spill_x_m, lake.spill_z_m),
                          lake.area_m2, lake.volume_m3, lake.greatest_depth_m, depth_m, outline_m);
  }

  nb::ndarray<nb::numpy, float> sky_view(int azimuths, double earth_radius_m, double refraction) {
    const auto [rows, columns] = shape();
    auto factors = new_array<float>({rows, columns});
    const OffingSkyView wanted{sizeof wanted, azimuths, earth_radius_m, refraction};
    run([&] {
      return offing_compute_sky_view(terrain_.get(), &wanted, factors.data(), nullptr, rows * columns);
    });
    return factors;
  }

  nb::ndarray<nb::numpy, float> horizons(int azimuths, double earth_radius_m, double refraction) {
    const auto [rows, columns] = shape();
    auto rises = new_array<float>({static_cast<std::size_t>(std::max(azimuths, 0)), rows, columns});
    const OffingSkyView wanted{sizeof wanted, azimuths, earth_radius_m, refraction};
    run([&] {
      return offing_compute_sky_view(terrain_.get(), &wanted, nullptr, rises.data(), rows * columns);
    });
    return rises;
  }

  std::pair<nb::ndarray<nb::numpy, float>, nb::ndarray<nb::numpy, float>> sun_hours(
      std::int64_t from_s, std::int64_t to_s, std::int64_t step_s, double turbidity,
      std::optional<std::pair<double, double>> place_rad, int azimuths, double earth_radius_m,
      double refraction) {
    const auto [rows, columns] = shape();
    auto hours = new_array<float>({rows, columns}), energy_kwh = new_array<float>({rows, columns});
    OffingSunHours wanted{};
    wanted.size = sizeof wanted;
    wanted.from_s = from_s;
    wanted.to_s = to_s;
    wanted.step_s = step_s;
    wanted.turbidity = turbidity;
    wanted.has_place = place_rad ? 1 : 0;
    if (place_rad) std::tie(wanted.latitude_rad, wanted.longitude_rad) = *place_rad;
    wanted.azimuths = azimuths;
    wanted.earth_radius_m = earth_radius_m;
    wanted.refraction = refraction;
    run([&] {
      return offing_compute_sun_hours(terrain_.get(), &wanted, hours.data(), energy_kwh.data(),
                                      rows * columns);
    });
    return {std::move(hours), std::move(energy_kwh)};
  }

 private:
  explicit Terrain(OffingTerrain* terrain) : terrain_(terrain) {}

  OffingTerrainInfo read_info() {
    OffingTerrainInfo found{};
    found.size = sizeof found;
    run([&] { return offing_get_terrain_info(terrain_.get(), &found); });
    return found;
  }
  std::pair<std::size_t, std::size_t> shape() {
    const OffingTerrainInfo found = read_info();
    return {static_cast<std::size_t>(found.rows), static_cast<std::size_t>(found.columns)};
  }

  Owned<OffingTerrain, offing_free_terrain> terrain_;
};

/// (places [n, 2], z [n], coordinate system, attributes: a dict of names and [n])
nb::tuple read_points(const std::filesystem::path& file, const std::string& layer) {
  OffingPointFile* opened = nullptr;
  run([&] { return offing_open_point_file(file.c_str(), layer.c_str(), &opened); });
  const Owned<OffingPointFile, offing_free_point_file> points(opened);
  OffingPointFileInfo info{};
  info.size = sizeof info;
  run([&] { return offing_get_point_file_info(points.get(), &info); });
  auto places = new_array<double>({info.count, 2}), z = new_array<double>({info.count});
  run([&] { return offing_read_point_file(points.get(), places.data(), z.data(), info.count); });
  nb::dict attributes;
  for (std::size_t i = 0; i < info.attribute_count; ++i) {
    const char* const name = offing_point_attribute_name(points.get(), i);
    auto values = new_array<double>({info.count});
    run([&] { return offing_read_point_attribute(points.get(), name, values.data(), info.count); });
    attributes[str_of(name)] = values;
  }
  return nb::make_tuple(places, z, str_of(info.coordinate_system), attributes);
}

}  // namespace

void bind_terrain(nb::module_& module) {
  nb::class_<Terrain>(module, "Terrain")
      .def_static("open", &Terrain::open, "device"_a, "file"_a, "spacing_x_m"_a, "spacing_z_m"_a,
                  "vertical_scale"_a, "offset_m"_a, "nodata"_a.none(), "void_height_m"_a.none(),
                  "reproject_to"_a.none(), "untrusted"_a, "band"_a)
      .def_static("make", &Terrain::make, "device"_a, "heights_m"_a, "spacing_x_m"_a, "spacing_z_m"_a)
      .def("info", &Terrain::info)
      .def("read", &Terrain::read)
      .def("sample", &Terrain::sample, "points_m"_a, "smooth_normals"_a)
      .def("cast", &Terrain::cast, "origins_m"_a, "directions"_a, "limit_m"_a, "smooth_normals"_a,
           "earth_radius_m"_a, "refraction"_a)
      .def("trace_sight_lines", &Terrain::trace_sight_lines, "from_m"_a, "to_m"_a, "earth_radius_m"_a,
           "refraction"_a)
      .def("viewshed", &Terrain::viewshed, "x_m"_a, "z_m"_a, "observer_height_m"_a, "target_height_m"_a,
           "radius_m"_a, "earth_radius_m"_a, "refraction"_a, "azimuth_rad"_a, "elevation_rad"_a)
      .def("count_viewsheds", &Terrain::count_viewsheds, "points_m"_a, "settings"_a, "earth_radius_m"_a,
           "refraction"_a, "best_count"_a, "progress"_a.none())
      .def("fill_lake", &Terrain::fill_lake, "x_m"_a, "z_m"_a, "level_m"_a.none())
      .def("sky_view", &Terrain::sky_view, "azimuths"_a, "earth_radius_m"_a, "refraction"_a)
      .def("horizons", &Terrain::horizons, "azimuths"_a, "earth_radius_m"_a, "refraction"_a)
      .def("sun_hours", &Terrain::sun_hours, "from_s"_a, "to_s"_a, "step_s"_a, "turbidity"_a,
           "place_rad"_a.none(), "azimuths"_a, "earth_radius_m"_a, "refraction"_a)
      .def("to_local", &Terrain::to_local, "places"_a, "system"_a)
      .def("from_local", &Terrain::from_local, "places_m"_a, "system"_a);
  module.def("read_points", &read_points, "file"_a, "layer"_a);
}
