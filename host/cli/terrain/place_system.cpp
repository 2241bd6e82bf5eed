#include "host/cli/terrain/place_system.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "host/base/argument.h"
#include "host/base/error.h"
#include "host/cli/terrain/terrain_place.h"

namespace offing::cli {
namespace {

/// What a person writes for a place.
std::string form_text(PlaceForm form, const std::string& system) {
  const bool is_local = system == local_places;
  const std::string plan = is_local ? "X,Z" : system == lonlat_places ? "LON,LAT" : "X,Y";
  switch (form) {
    case PlaceForm::plan:
      return plan;
    case PlaceForm::above_ground:
      return plan + (is_local ? ",H" : ",HEIGHT");
    case PlaceForm::height:
      return is_local ? "X,Y,Z" : plan + ",HEIGHT";
    case PlaceForm::level:
      break;
  }
  return plan + ",LEVEL";
}

std::string example_text(PlaceForm form, const std::string& system, std::string_view local) {
  if (system == local_places) return std::string(local);
  const std::string plan = system == lonlat_places ? "-70.5,-32.5" : "372500,6400000";
  return form == PlaceForm::plan ? plan : plan + (form == PlaceForm::above_ground ? ",1.7" : ",2500");
}

}  // namespace

void PlaceFlags::add_to(CLI::App& command, const char* group) {
  SettingOptions::add_to(
      command,
      {{&PlaceSettings::system,
        {.key = "crs",
         .help =
             "coordinate system of all places, east before north: local (m from the north-west post), map "
             "(the map's own coordinates), lonlat (degrees on WGS 84) or a name such as EPSG:32719",
         .example = "lonlat",
         .rule = scene::ParameterRule::name}}},
      group);
}

GivenPlace read_place(std::string_view flag, std::string_view text, PlaceForm form, const std::string& system,
                      std::string_view example) {
  const std::vector<double> numbers =
      read_numbers(flag, text, form == PlaceForm::plan ? 2 : 3, form_text(form, system),
                   example_text(form, system, example));
  if (form == PlaceForm::plan) return {{numbers[0], numbers[1]}};
  if (form == PlaceForm::height && system == local_places) return {{numbers[0], numbers[2]}, numbers[1]};
  return {{numbers[0], numbers[1]}, numbers[2]};
}

PlaceSystem::PlaceSystem(MapFrame map, std::string system, const std::string& flag)
    : map_(std::move(map)), system_(std::move(system)) {
  if (is_local()) return;
  coordinates_ = map_coordinates(map_, system_, flag);
  coordinate_system_ = coordinates_->coordinate_system();
}

const char* PlaceSystem::first() const {
  return is_local() ? "x_m" : system_ == lonlat_places ? "longitude_deg" : "x";
}

const char* PlaceSystem::second() const {
  return is_local() ? "z_m" : system_ == lonlat_places ? "latitude_deg" : "y";
}

bool PlaceSystem::is_within(const glm::dvec2& place_m) const {
  return place_m.x >= 0.0 && place_m.x <= map_.spacing_x_m * (map_.columns - 1) && place_m.y >= 0.0 &&
         place_m.y <= map_.spacing_z_m * (map_.rows - 1);
}

void PlaceSystem::refuse(const std::string& name, const glm::dvec2& place, const glm::dvec2& place_m) const {
  const glm::dvec2 swapped(place.y, place.x);
  if (is_within(coordinates_->to_local(std::span(&swapped, 1))[0])) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("{}: expected a place on the map, found {:.10g}, {:.10g}, which is on it only the "
                    "other way round",
                    name, place.x, place.y),
        fmt::format("east comes before north, longitude before latitude: write {:.10g},{:.10g}", place.y,
                    place.x));
  }
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: expected a place on the map, found {:.10g}, {:.10g}{}", name, place.x, place.y,
                          std::isnan(place_m.x)
                              ? ", which is nowhere in the map's coordinate system"
                              : fmt::format(", {:.6g} m {} and {:.6g} m {} of its "
                                            "north-west post",
                                            std::abs(place_m.x), place_m.x < 0.0 ? "west" : "east",
                                            std::abs(place_m.y), place_m.y < 0.0 ? "north" : "south")),
              fmt::format("`offing terrain info {}{}` prints the map's corners", one_line(map_.file),
                          system_.find('[') == std::string::npos ? " --crs " + printable(system_) : ""));
}

void PlaceSystem::refuse_other_system(const std::string& name, const glm::dvec2& place) const {
  if (map_.georeference.step_x == 0.0) return;
  const std::array both{place, glm::dvec2(place.y, place.x)};
  for (const char* system : {lonlat_places, map_places}) {
    if (system == lonlat_places && map_.georeference.coordinate_system.empty()) continue;
    std::vector<glm::dvec2> local_m;
    try {
      local_m = map_coordinates(map_, system)->to_local(both);
    } catch (const Error&) {
      continue;  // a system that is nowhere on the Earth, as that of generated terrain
    }
    if (!is_within(local_m[0]) && !is_within(local_m[1])) continue;
    try {
      require_within(name, map_.spacing_x_m * (map_.columns - 1), map_.spacing_z_m * (map_.rows - 1), place.x,
                     place.y);
    } catch (const Error& error) {
      throw Error(error.kind(), error.what(),
                  fmt::format("add --crs {} if these are {}", system,
                              system == lonlat_places ? "longitude and latitude"
                                                      : "coordinates of the map's own system"));
    }
  }
}

std::vector<glm::dvec2> PlaceSystem::on_map(const NameOfPlace& name_of,
                                            std::span<const glm::dvec2> places) const {
  if (is_local()) return {places.begin(), places.end()};
  std::vector<glm::dvec2> places_m = coordinates_->to_local(places);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (std::isnan(places_m[i].x)) refuse(name_of(i), places[i], places_m[i]);
  }
  return places_m;
}

std::vector<glm::dvec2> PlaceSystem::within_map(const NameOfPlace& name_of,
                                                std::span<const glm::dvec2> places) const {
  std::vector<glm::dvec2> places_m = on_map(name_of, places);
  if (is_local()) {
    const auto beyond = std::ranges::find_if(places_m, [this](const glm::dvec2& place_m) {
      constexpr double rounding_posts = 1e-6;
      const double column = place_m.x / map_.spacing_x_m, row = place_m.y / map_.spacing_z_m;
      return std::min(column, row) < -rounding_posts || column > map_.columns - 1 + rounding_posts ||
             row > map_.rows - 1 + rounding_posts;
    });
    if (beyond != places_m.end())
      refuse_other_system(name_of(static_cast<std::size_t>(beyond - places_m.begin())), *beyond);
    return places_m;
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!is_within(places_m[i])) refuse(name_of(i), places[i], places_m[i]);
  }
  return places_m;
}

glm::dvec2 PlaceSystem::on_map(std::string_view flag, const glm::dvec2& place) const {
  return on_map([flag](std::size_t) { return std::string(flag); }, std::span(&place, 1))[0];
}

glm::dvec2 PlaceSystem::within_map(std::string_view flag, const glm::dvec2& place) const {
  return within_map([flag](std::size_t) { return std::string(flag); }, std::span(&place, 1))[0];
}

std::vector<glm::dvec2> PlaceSystem::of_map(std::span<const glm::dvec2> places_m) const {
  if (is_local()) return {places_m.begin(), places_m.end()};
  return coordinates_->from_local(places_m);
}

glm::dvec2 PlaceSystem::of_map(const glm::dvec2& place_m) const {
  return of_map(std::span(&place_m, 1))[0];
}

nlohmann::ordered_json PlaceSystem::to_json(const glm::dvec2& place_m, const double* height_m) const {
  if (is_local()) return nullptr;
  const glm::dvec2 place = of_map(place_m);
  nlohmann::ordered_json json = {{first(), place.x}, {second(), place.y}};
  if (height_m != nullptr) json["height_m"] = *height_m;
  return json;
}

std::string PlaceSystem::text(const glm::dvec2& place_m, double height_m) const {
  if (is_local()) return fmt::format("({}, {}, {})", place_m.x, height_m, place_m.y);
  const glm::dvec2 place = of_map(place_m);
  // A millimetre, of degrees and of what is likely to be metres.
  if (system_ == lonlat_places)
    return fmt::format("longitude {:.8f}, latitude {:.8f}, height {} m", place.x, place.y, height_m);
  return fmt::format("x {:.10g}, y {:.10g}, height {} m", place.x, place.y, height_m);
}

}  // namespace offing::cli
