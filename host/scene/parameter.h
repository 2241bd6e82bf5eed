#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "host/base/utc_time.h"
#include "host/scene/ocean_scene.h"

namespace offing::scene {

/// One of several named values, stored as an enumeration whose values count from 0 in the order of the names.
struct ChoiceStorage {
  std::vector<std::string_view> names;
  std::size_t (*get)(OceanScene&);
  void (*set)(OceanScene&, std::size_t);
};

/// A number of each element of a section that may be repeated, such as [[ocean.swell]].
struct ElementStorage {
  std::size_t (*count)(const OceanScene&);
  void (*append)(OceanScene&);  ///< an element of default values
  void (*remove)(OceanScene&, std::size_t);
  std::variant<double& (*)(OceanScene&, std::size_t), std::optional<double>& (*)(OceanScene&, std::size_t)>
      at;
};

/// Where a row's value lives in the scene; the alternative is its type.
using Storage = std::variant<double& (*)(OceanScene&), std::optional<double>& (*)(OceanScene&),
                             int& (*)(OceanScene&), std::uint64_t& (*)(OceanScene&),
                             std::string& (*)(OceanScene&), std::optional<UtcTime>& (*)(OceanScene&),
                             std::vector<double>& (*)(OceanScene&), ChoiceStorage, ElementStorage>;

enum class ParameterGroup {
  world,
  time,
  wind,
  sea,
  grid,
  swell,
  raindrop,
  foam,
  camera,
  sun,
  sky,
  render,
  terrain,
  height_map,
  walk
};
enum class ParameterRule { within_range, power_of_two };
/// Whether a value may have keyframes (parameter_track.h), and goes from one to the next as an angle does.
enum class ParameterMotion { constant, keyed, keyed_angle };
/// Which scenes a parameter matters to (unused_parameters.h).
enum class ParameterUse {
  always,
  modelled_sea,      ///< not one of a measured spectrum
  measured_sea,      ///< one of a measured spectrum
  measured_tail,     ///< one of a measured spectrum that ends below the value
  jonswap_or_tma,    ///< models, as are the next three
  tma_depth_factor,  ///< in water of some depth
  phillips,
  swell,
  wind,                ///< all that wind makes
  own_wind,            ///< all that wind makes, and those whose spreading has a wave age
  wind_direction,      ///< without directions of their own
  spreading,           ///< without directions or a spreading of their own
  spreading_exponent,  ///< those spread by cos^2s
  chosen_cascades,     ///< whose patches are not given
  gerstner,            ///< with Gerstner waves
  dated_sun,           ///< under a sun that stands where its time says
  terrain_file,        ///< with ground that is read from a file, but for tile stores
  tile_store,          ///< with ground from a tile store
  whole_map,           ///< with ground that is no tile store
  made_ground,         ///< with ground that is made
  dry_scene,           ///< with ground and without a sea
};

/// One row of the parameter table: everything there is to say about one value of a scene.
struct Parameter {
  std::string_view key;   ///< in a scene file: "ocean.fetch_m"
  std::string_view flag;  ///< on the command line: "--fetch-m"; empty: scene files only
  ParameterGroup group = ParameterGroup::sea;
  Storage storage;
  std::string_view unit = {};  ///< as written in the scene and on the command line; empty: dimensionless
  double low = 0.0;            ///< smallest and largest value, in `unit`, both included
  double high = 0.0;
  std::string_view help = {};
  std::string_view example = {};  ///< a value that makes sense, for hints
  std::string_view absent = {};   ///< what happens without a value, where there is no default value
  double scale = 1.0;             ///< stored value = written value * scale
  ParameterRule rule = ParameterRule::within_range;
  std::size_t max_count = 1;  ///< of a list or of a section's elements: the most of them
  /// Row of the same section that says the same in another way: a scene file gives one of the two, and where
  /// a program has set both, that one counts.
  std::string_view instead_of = {};
  ParameterUse use = ParameterUse::always;
  ParameterMotion motion = ParameterMotion::constant;
};

/// The parts of a row's key "ocean.foam.width": "ocean.foam" and "width".
inline std::string_view section_of(std::string_view key) {
  return key.substr(0, key.rfind('.'));
}
inline std::string_view name_of(std::string_view key) {
  return key.substr(key.rfind('.') + 1);
}

/// A value as it was written, before any check. std::monostate is a type that no parameter takes.
struct WrittenValue {
  std::variant<std::monostate, std::int64_t, double, std::string> value;
  std::string shown;  ///< for messages: `"17 kn"`
};

/// Where a value was written, for messages: what() begins with `subject`, the hint shows `assignment` and a
/// value.
struct Place {
  std::string subject;          ///< `storm.toml:14:13: ocean.wind_speed_mps` or `--wind-speed-mps`
  std::string assignment = {};  ///< `wind_speed_mps = ` or `--wind-speed-mps `
};

/// Checks a value and stores it with its place, in the stead of keyframes; appends it to a list, and gives it
/// to the last element of a repeated section, which gets its first one if it has none. Throws
/// Error(bad_input) that names place, expected and found.
void store(OceanScene& scene, const Parameter& parameter, const WrittenValue& written, const Place& place);

/// Empties a parameter that is a list, so that new values replace the old ones; does nothing to others.
void clear_list(OceanScene& scene, const Parameter& parameter);

/// Begins a new element of default values in the repeated section of this row; does nothing for others.
/// Throws Error(bad_input) where the section has its most elements; `place.subject` names the section.
void append_element(OceanScene& scene, const Parameter& parameter, const Place& place);

/// Text of a command line as the parameter's type asks: numbers where numbers are due, else text.
WrittenValue read_flag_value(const Parameter& parameter, std::string_view text);

/// "a number in m/s within [0, 60]".
std::string expected_text(const Parameter& parameter);

/// Twelve digits, as people write numbers, or as many as tell any two numbers apart.
enum class Digits { readable, exact };

/// The value in a scene, in the parameter's unit, or all values of a list or a repeated section, separated by
/// commas; `absent` when there is none.
std::string value_text(const OceanScene& scene, const Parameter& parameter, Digits digits = Digits::readable);

/// The value without a word in the scene; of a repeated section, that of an element.
std::string default_text(const Parameter& parameter);

}  // namespace offing::scene
