#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "host/scene/ocean_scene.h"

namespace offing::scene {

/// One of several named values, stored as an enumeration whose values count from 0 in the order of the names.
struct ChoiceStorage {
  std::vector<std::string_view> names;
  std::size_t (*get)(OceanScene&);
  void (*set)(OceanScene&, std::size_t);
};

/// Where a row's value lives in the scene; the alternative is its type.
using Storage =
    std::variant<double& (*)(OceanScene&), std::optional<double>& (*)(OceanScene&), int& (*)(OceanScene&),
                 std::uint64_t& (*)(OceanScene&), std::string& (*)(OceanScene&),
                 std::vector<double>& (*)(OceanScene&), ChoiceStorage>;

enum class ParameterGroup { world, time, wind, sea, grid, foam, camera, sun, render };
enum class ParameterRule { within_range, power_of_two };
/// Which seas a parameter matters to (unused_parameters.h).
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
  std::size_t max_count = 1;  ///< of a list: the most values
  ParameterUse use = ParameterUse::always;
};

/// A value as it was written, before any check. std::monostate is a type that no parameter takes.
struct WrittenValue {
  std::variant<std::monostate, std::int64_t, double, std::string> value;
  std::string shown;  ///< for messages: `"17 kn"`
};

/// Where a value was written, for messages: what() begins with `subject`, the hint shows `assignment` and a
/// value.
struct Place {
  std::string subject;     ///< `storm.toml:14:13: ocean.wind_speed_mps` or `--wind-speed-mps`
  std::string assignment;  ///< `wind_speed_mps = ` or `--wind-speed-mps `
};

/// Checks a value and stores it with its place; appends it to a list. Throws Error(bad_input) that names
/// place, expected and found.
void store(OceanScene& scene, const Parameter& parameter, const WrittenValue& written, const Place& place);

/// Empties a parameter that is a list, so that new values replace the old ones; does nothing to others.
void clear_list(OceanScene& scene, const Parameter& parameter);

/// Text of a command line as the parameter's type asks: numbers where numbers are due, else text.
WrittenValue read_flag_value(const Parameter& parameter, std::string_view text);

/// "a number in m/s within [0, 60]".
std::string expected_text(const Parameter& parameter);

/// Twelve digits, as people write numbers, or as many as tell any two numbers apart.
enum class Digits { readable, exact };

/// The value in a scene, in the parameter's unit; `absent` when there is none.
std::string value_text(const OceanScene& scene, const Parameter& parameter, Digits digits = Digits::readable);

}  // namespace offing::scene
