#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/App.hpp>
#include <glm/vec2.hpp>
#include <nlohmann/json.hpp>

#include "host/command_line/setting_options.h"
#include "host/io/height_maps/map_coordinates.h"

namespace offing::cli {

/// What --crs says.
struct PlaceSettings {
  std::string system = local_places;
};

/// --crs: the system in which a command's places are given and printed. `this` must outlive the command.
class PlaceFlags : public SettingOptions<PlaceSettings> {
 public:
  void add_to(CLI::App& command, const char* group = "Options");
  std::string system() const { return read().system; }
};

/// A place of a flag.
struct GivenPlace {
  glm::dvec2 place{};     ///< local: x and z; otherwise east, then north
  double height_m = 0.0;  ///< where the flag has one
};

/// What a flag's place has beside the place itself: nothing, a height above ground, a height, or a water
/// level. Local places are written as X,Z or X,Z,H or X,Y,Z or X,Z,LEVEL, others as the place and then the
/// height.
enum class PlaceForm { plan, above_ground, height, level };

/// Throws bad_argument() for anything else than numbers of that form; `example` is a local one.
GivenPlace read_place(std::string_view flag, std::string_view text, PlaceForm form, const std::string& system,
                      std::string_view example);

/// The places of a command: in the system that --crs names, and on the map.
class PlaceSystem {
 public:
  /// Throws what map_coordinates() throws; its errors name `flag`, or the file that names the system.
  PlaceSystem(MapFrame map, std::string system, const std::string& flag = "--crs");

  bool is_local() const { return system_ == local_places; }
  const std::string& name() const { return system_; }
  /// WKT of the system; empty for local places.
  const std::string& coordinate_system() const { return coordinate_system_; }

  /// Names of the columns of a place: x_m and z_m, longitude_deg and latitude_deg, or x and y.
  const char* first() const;
  const char* second() const;

  using NameOfPlace = std::function<std::string(std::size_t)>;
  /// (x_m, z_m) of places. Throws Error(bad_input) that names the flag, or the line, of one that is not there
  /// in the map's system; they may be beyond the map.
  std::vector<glm::dvec2> on_map(const NameOfPlace& name_of, std::span<const glm::dvec2> places) const;
  glm::dvec2 on_map(std::string_view flag, const glm::dvec2& place) const;
  /// The same for places that must be within the map. Local ones are left for the ground to judge, unless
  /// they are within the map in its own system or in degrees: then the hint is to name that one.
  std::vector<glm::dvec2> within_map(const NameOfPlace& name_of, std::span<const glm::dvec2> places) const;
  glm::dvec2 within_map(std::string_view flag, const glm::dvec2& place) const;

  /// Places of the system, from (x_m, z_m).
  std::vector<glm::dvec2> of_map(std::span<const glm::dvec2> places_m) const;
  glm::dvec2 of_map(const glm::dvec2& place_m) const;
  /// A place and its height in the system, for JSON; null for local places, which have keys of their own.
  nlohmann::ordered_json to_json(const glm::dvec2& place_m, const double* height_m = nullptr) const;
  /// A place and its height in the system, for words: "(X, Y, Z)" for local places.
  std::string text(const glm::dvec2& place_m, double height_m) const;

 private:
  bool is_within(const glm::dvec2& place_m) const;
  /// Throws as within_map() does for a local place that looks like one of another system.
  void refuse_other_system(const std::string& name, const glm::dvec2& place) const;
  [[noreturn]] void refuse(const std::string& name, const glm::dvec2& place, const glm::dvec2& place_m) const;

  MapFrame map_;
  std::string system_, coordinate_system_;
  std::unique_ptr<MapCoordinates> coordinates_;  // null: local
};

}  // namespace offing::cli
