#pragma once

#include <any>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "host/scene/model/scene.h"
#include "host/scene/schema/section.h"
#include "host/scene/schema/value_storage.h"

namespace offing::scene {

/// What a parameter belongs to: its heading in help, and its panel in the window.
enum class ParameterGroup {
  world,
  time,
  wind,
  sea,
  grid,
  swell,
  raindrop,
  wake,
  wake_hull,
  foam,
  camera,
  bookmark,
  sun,
  sky,
  render,
  terrain,
  height_map,
  material,
  canopy,
  walk,
  lake,
  light,
  mesh,
  highlight,
  body,
  mooring,
  clouds,
  cloud_layer,
  cloud,
  cloud_ball,
  cloud_level,
  particle_edit
};
/// What a value must be beside its type: numbers within their range, text the name of a file.
enum class ParameterRule { within_range, power_of_two, file_name, name };
/// Whether a value may have keyframes (parameter_track.h), and goes from one to the next as an angle does.
enum class ParameterMotion { constant, keyed, keyed_angle };
/// What has to be made anew where a value changes, and what its value tells of: a set of bits.
enum class Affects : unsigned {
  nothing = 0,
  spectrum = 1u << 0,     ///< the sea, from its energy on
  sea_seed = 1u << 1,     ///< which sea it is of all of the same spectrum
  extra_waves = 1u << 2,  ///< swells and raindrops
  wakes = 1u << 3,
  water = 1u << 4,  ///< what the water looks like
  baked = 1u << 5,  ///< a baked frame by itself: other values do through what is made of them, or not at all
  heights = 1u << 6,     ///< of the ground
  cover = 1u << 7,       ///< where the ground is, and what covers it
  meshes = 1u << 8,      ///< surface, motion or highlights of a mesh
  mesh_looks = 1u << 9,  ///< what needs none of them anew
  highlights = 1u << 10,
  lights = 1u << 11,
  bodies = 1u << 12,
  clouds = 1u << 13,
  view = 1u << 14,  ///< what is asked for in each frame: eye, sun, air and exposure
};

constexpr Affects operator|(Affects a, Affects b) {
  return static_cast<Affects>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
constexpr bool share_a_bit(Affects a, Affects b) {
  return (static_cast<unsigned>(a) & static_cast<unsigned>(b)) != 0;
}

inline constexpr Affects everything = static_cast<Affects>(~0u);
inline constexpr Affects all_but_clouds = static_cast<Affects>(~0u & ~static_cast<unsigned>(Affects::clouds));
inline constexpr Affects parts_of_sea =
    Affects::spectrum | Affects::sea_seed | Affects::extra_waves | Affects::wakes | Affects::water;

/// What files tell about the sea of a scene.
struct SeaFacts {
  bool is_there = false;
  bool is_measured = false;
  bool is_directional = false;  ///< measured, with directions of its own
  bool is_deep = false;
  double last_hz = 0.0;  ///< highest frequency of a measured spectrum, with its tail
};

/// What a row sees of a scene when it tells whether its value has an effect.
struct UseContext {
  const Scene& scene;
  ElementIndex element = {};  ///< of the row's section
  SeaFacts sea = {};
};

/// Where a slider ends.
struct SliderRange {
  double low, high;
};

/// One row of the parameter table: everything there is to say about one value of a scene.
struct Parameter {
  std::string_view key;                ///< in a scene file: "ocean.fetch_m"
  std::string_view alias = {};         ///< an earlier key that still works, with a warning
  Affects affects = Affects::nothing;  ///< nothing: as the rows around it do
  std::string_view flag = {};          ///< on the command line: "--fetch-m"; empty: scene files only
  ParameterGroup group = ParameterGroup::sea;
  Storage storage = {};  ///< in the struct of its section
  const Section* section = nullptr;
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
  /// Why the value has no effect in this struct of its section, empty where it has one; none: it always has.
  std::function<std::string(const UseContext&, const void* section)> unused = {};
  ParameterMotion motion = ParameterMotion::constant;
  /// Ends of its slider, in `unit`, where the range goes on to values that make much work or have hardly a
  /// use: those are typed. Of three numbers: what they are dragged across.
  std::optional<SliderRange> slider = {};
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
  std::variant<std::monostate, std::int64_t, double, std::string, std::vector<double>> value;
  std::string shown;  ///< for messages: `"17 kn"`
};

/// Where a value was written, for messages: what() begins with `subject`, the hint shows `assignment` and a
/// value.
struct Place {
  std::string subject;          ///< `storm.toml:14:13: ocean.wind_speed_mps` or `--wind-speed-mps`
  std::string assignment = {};  ///< `wind_speed_mps = ` or `--wind-speed-mps `
};

// Values in the struct of their section, which `section` points to.

bool is_same_value(const Parameter& row, const void* a, const void* b);
void copy_value(const Parameter& row, const void* from, void* to);
/// A value of any type, to be put back.
std::any value_in(const void* section, const Parameter& row);
void put_in(void* section, const Parameter& row, const std::any& value);
/// The numbers that a value is made of: one, three, or none where it has no value or is no number.
std::vector<double*> numbers_in(void* section, const Parameter& row);
/// Checks a value and stores it; appends it to a list. Throws Error(bad_input) that names place, expected and
/// found.
void store_in(void* section, const Parameter& row, const WrittenValue& written, const Place& place);

/// Twelve digits, as people write numbers, as many as read back to the same stored value, or as many as tell
/// any two numbers apart.
enum class Digits { readable, reads_back, exact };

/// In the parameter's unit, all values of a list separated by commas; `absent` when there is none.
std::string text_in(const void* section, const Parameter& row, Digits digits);

/// The numbers of a value, as they are stored, in the shortest text that reads back to them.
std::string numbers_text(const Parameter& row, std::span<const double> stored);

// Values of a scene.

/// Checks a value and stores it with its place, in the stead of keyframes; appends it to a list. Without an
/// element it is the last one's of a repeated section, which gets its first one if it has none. Throws
/// Error(bad_input) that names place, expected and found.
void store(Scene& scene, const Parameter& parameter, const WrittenValue& written, const Place& place,
           std::optional<ElementIndex> element = {});

/// Empties a parameter that is a list, so that new values replace the old ones; does nothing to others.
void clear_list(Scene& scene, const Parameter& parameter);

/// Text of a command line as the parameter's type asks: numbers where numbers are due, else text.
WrittenValue read_flag_value(const Parameter& parameter, std::string_view text);

/// "a number in m/s within [0, 60]".
std::string expected_text(const Parameter& parameter);

/// The value of an element.
std::string value_text(const Scene& scene, const Parameter& parameter, ElementIndex element, Digits digits);

/// The values of all elements, separated by commas, those of one parent from the next by semicolons; "none"
/// without an element.
std::string value_text(const Scene& scene, const Parameter& parameter, Digits digits = Digits::readable);

/// The value without a word in the scene; of a repeated section, that of an element.
std::string default_text(const Parameter& parameter);

}  // namespace offing::scene
