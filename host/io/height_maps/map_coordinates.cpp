// Places on a map in local metres, the map's own coordinates, or any system of PROJ's.
#include "host/io/height_maps/map_coordinates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/height_maps/gdal_session.h"

namespace offing {
namespace {

using height_maps::GdalSession;
using height_maps::spatial_reference;
using height_maps::SpatialReference;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr const char* wgs84 = "EPSG:4326";

struct DestroyTransformation {
  void operator()(void* way) const { OCTDestroyCoordinateTransformation(way); }
};
using Transformation = std::unique_ptr<void, DestroyTransformation>;

/// Coordinates of a system in place; NaN where there is no way.
void transform(const Transformation& way, std::vector<glm::dvec2>& places) {
  if (!way) return;
  const GdalSession session;
  std::vector<double> x, y;
  for (const glm::dvec2& place : places) {
    x.push_back(place.x);
    y.push_back(place.y);
  }
  std::vector<int> is_there(places.size(), 0);
  OCTTransformEx(way.get(), static_cast<int>(places.size()), x.data(), y.data(), nullptr, is_there.data());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool is_place = is_there[i] != 0 && std::isfinite(x[i]) && std::isfinite(y[i]);
    places[i] = is_place ? glm::dvec2(x[i], y[i]) : glm::dvec2(unknown);
  }
}

/// A place in posts; beyond the first or last one by rounding is on it.
double on_edge(double post, int posts) {
  constexpr double rounding = 1e-6;
  const double last = posts - 1;
  return post > -rounding && post < last + rounding ? std::clamp(post, 0.0, last) : post;
}

/// What a person calls a system: of a text in WKT its name.
std::string short_name(const std::string& system) {
  if (system.find('[') == std::string::npos) return printable(system);
  const SpatialReference reference = spatial_reference(system);
  return reference ? printable(OSRGetName(reference.get())) : "WKT";
}

/// How to ask for another system: by a flag, as an argument of a call, or in the layer that names one.
std::string other_system(const std::string& flag, const char* system) {
  if (flag.starts_with("--")) return fmt::format("write {} {}", flag, system);
  if (flag.find(": ") == std::string::npos) return fmt::format("give \"{}\" as {}", system, flag);
  return "give the layer another system with ogr2ogr -t_srs";
}

[[noreturn]] void refuse_map(const MapFrame& map, const std::string& flag, const std::string& system,
                             const std::string& found, const std::string& hint) {
  throw Error(
      ErrorKind::bad_input,
      fmt::format("{}: expected a map with a place in the world{}, found {}", one_line(map.file),
                  flag.empty() ? "" : fmt::format(", as {} {} needs", flag, short_name(system)), found),
      hint);
}

/// How many units of a geographic system go round the Earth; 0 for other systems.
double round_the_earth(const SpatialReference& system) {
  constexpr double turn_rad = 6.283185307179586;
  return system && OSRIsGeographic(system.get()) != 0 ? turn_rad / OSRGetAngularUnits(system.get(), nullptr)
                                                      : 0.0;
}

class PlacedCoordinates : public MapCoordinates {
 public:
  PlacedCoordinates(const MapFrame& map, const std::string& system, const std::string& flag) : map_(map) {
    const Georeference& place = map.georeference;
    if (place.step_x == 0.0) {
      refuse_map(map, flag, system, "none",
                 fmt::format("place the map with gdal_edit.py -a_ullr, or {}",
                             flag.find(": ") == std::string::npos
                                 ? other_system(flag, local_places) + " for metres from the north-west post"
                                 : "give the points as CSV in metres from the north-west post"));
    }
    const GdalSession session;
    const SpatialReference own =
        place.coordinate_system.empty() ? nullptr : spatial_reference(place.coordinate_system);
    turn_ = round_the_earth(own);
    if (system == map_places) {
      system_ = place.coordinate_system;
      return;
    }
    const bool is_lonlat = system == lonlat_places;
    const SpatialReference other = spatial_reference(is_lonlat ? wgs84 : system);
    if (!other || (OSRIsGeographic(other.get()) == 0 && OSRIsProjected(other.get()) == 0)) {
      throw Error(ErrorKind::bad_input,
                  fmt::format("{}: expected local, map, lonlat or a coordinate system of the plane that PROJ "
                              "knows, found \"{}\"",
                              flag, short_name(system)),
                  fmt::format("{} for longitude and latitude, or a code such as EPSG:32719",
                              other_system(flag, lonlat_places)));
    }
    const std::string hint =
        fmt::format("give it one with gdal_edit.py -a_srs EPSG:CODE, or {} for the map's own coordinates",
                    other_system(flag, map_places));
    if (!own) refuse_map(map, flag, system, "no coordinate system", hint);
    system_ = height_maps::wkt_of(other.get());
    if (is_lonlat) lonlat_turn_ = round_the_earth(other);
    if (OSRIsSame(own.get(), other.get()) != 0) return;
    to_map_.reset(OCTNewCoordinateTransformation(other.get(), own.get()));
    from_map_.reset(OCTNewCoordinateTransformation(own.get(), other.get()));
    if (!to_map_ || !from_map_) {
      refuse_map(map, flag, system, fmt::format("\"{}\"", printable(OSRGetName(own.get()))), hint);
    }
  }

  const std::string& coordinate_system() const override { return system_; }

  std::vector<glm::dvec2> to_local(std::span<const glm::dvec2> places) const override {
    std::vector<glm::dvec2> local(places.begin(), places.end());
    transform(to_map_, local);
    const Georeference& at = map_.georeference;
    const double middle_x = at.origin_x + 0.5 * at.step_x * (map_.columns - 1);
    for (glm::dvec2& place : local) {
      // The turn of the Earth that the map lies in.
      if (turn_ > 0.0) place.x -= turn_ * std::round((place.x - middle_x) / turn_);
      const double column = on_edge((place.x - at.origin_x) / at.step_x, map_.columns);
      const double row = on_edge((place.y - at.origin_y) / at.step_y, map_.rows);
      place = {column * map_.spacing_x_m, row * map_.spacing_z_m};
    }
    return local;
  }

  std::vector<glm::dvec2> from_local(std::span<const glm::dvec2> places_m) const override {
    const Georeference& at = map_.georeference;
    std::vector<glm::dvec2> places;
    places.reserve(places_m.size());
    for (const glm::dvec2& place_m : places_m) {
      places.emplace_back(at.origin_x + place_m.x / map_.spacing_x_m * at.step_x,
                          at.origin_y + place_m.y / map_.spacing_z_m * at.step_y);
    }
    transform(from_map_, places);
    if (lonlat_turn_ > 0.0) {
      // -180 ... 180, whatever the map counts from.
      for (glm::dvec2& place : places) place.x = std::remainder(place.x, lonlat_turn_);
    }
    return places;
  }

 private:
  MapFrame map_;
  std::string system_;
  double turn_ = 0.0, lonlat_turn_ = 0.0;
  Transformation to_map_, from_map_;  // null: the map's own coordinates
};

/// Metres from the first post, which need no transformation.
class LocalCoordinates : public MapCoordinates {
 public:
  const std::string& coordinate_system() const override { return none_; }
  std::vector<glm::dvec2> to_local(std::span<const glm::dvec2> places) const override {
    return {places.begin(), places.end()};
  }
  std::vector<glm::dvec2> from_local(std::span<const glm::dvec2> places_m) const override {
    return {places_m.begin(), places_m.end()};
  }

 private:
  std::string none_;
};

}  // namespace

std::unique_ptr<MapCoordinates> map_coordinates(const MapFrame& map, const std::string& system,
                                                const std::string& flag) {
  if (system == local_places) return std::make_unique<LocalCoordinates>();
  return std::make_unique<PlacedCoordinates>(map, system, flag);
}

}  // namespace offing
