#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <glm/vec3.hpp>

#include "host/base/utc_time.h"
#include "host/scene/model/scene.h"

namespace offing::scene {

/// Where a value lives in the scene: every value outside of repeated sections is its own only element.
template <class Value>
using ValueAt = Value& (*)(Scene&, ElementIndex);

/// One of several named values, stored as an enumeration whose values count from 0 in the order of the names.
struct ChoiceStorage {
  std::vector<std::string_view> names;
  std::size_t (*get)(Scene&, ElementIndex);
  void (*set)(Scene&, ElementIndex, std::size_t);
};

/// Where a row's value lives; the alternative is its type. Triples are written as lists.
using Storage =
    std::variant<ValueAt<double>, ValueAt<std::optional<double>>, ValueAt<int>, ValueAt<std::uint64_t>,
                 ValueAt<std::string>, ValueAt<std::optional<UtcTime>>, ValueAt<std::vector<double>>,
                 ValueAt<glm::dvec3>, ValueAt<std::optional<glm::dvec3>>, ChoiceStorage>;

/// A section that may be repeated, such as [[ocean.swell]]; one within another's elements, such as
/// [[mesh.highlight]], counts anew in each of them.
struct RepeatedSection {
  const RepeatedSection* parent = nullptr;
  std::size_t (*count)(const Scene&, ElementIndex);  ///< within this element of the parent
  void (*append)(Scene&, ElementIndex);              ///< an element of default values
  void (*remove)(Scene&, ElementIndex);
};

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
  walk,
  light,
  mesh,
  highlight,
  body,
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
  made_terrain,        ///< with ground that is made
  dry_scene,           ///< with ground and without a sea
  sea_over_terrain,    ///< with ground
  far_light,           ///< of a light that is a direction
  near_light,          ///< of a light that stands at a place
  made_mesh,           ///< of a mesh that is no file's
  cartoon_mesh,        ///< of one that is shaded as cartoons are
  stepped_mesh,        ///< of one that is shaded so without a ramp
  outlined_mesh,       ///< of one with an outline
  shiny_mesh,          ///< of one with a highlight of Blinn's own
  found_highlights,    ///< of a mesh with highlights
  masked_highlight,    ///< of one that is drawn around a place only
  split_highlight,     ///< of one in several copies
  shape_highlight,     ///< of one that is no picture
  image_highlight,     ///< of one that is
  body_of_density,     ///< of a body without mass and draught
  driven_body,         ///< of one that forces move
  filed_cloud,         ///< of a cloud that a file makes
  shaped_cloud,        ///< of one that a mesh or a text makes
  turned_cloud,        ///< of one that a file, a mesh or a text makes
  text_cloud,          ///< of one that a text makes
  balled_cloud,        ///< of one that balls make
  sampled_cloud,       ///< of one that is merged from cells
  grown_cloud,         ///< of one that grows on its balls
  heated_cloud,        ///< of one that warm air carries
  obstructed_cloud,    ///< of one that flows around something
};

/// Where a slider ends.
struct SliderRange {
  double low, high;
};

/// One row of the parameter table: everything there is to say about one value of a scene.
struct Parameter {
  std::string_view key;        ///< in a scene file: "ocean.fetch_m"
  std::string_view flag = {};  ///< on the command line: "--fetch-m"; empty: scene files only
  ParameterGroup group = ParameterGroup::sea;
  Storage storage;
  /// The section of its elements; nullptr for values outside of repeated sections.
  const RepeatedSection* elements = nullptr;
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

/// Twelve digits, as people write numbers, or as many as tell any two numbers apart.
enum class Digits { readable, exact };

/// The value of an element, in the parameter's unit, all values of a list separated by commas; `absent` when
/// there is none.
std::string value_text(const Scene& scene, const Parameter& parameter, ElementIndex element, Digits digits);

/// The values of all elements, separated by commas, those of one parent from the next by semicolons; "none"
/// without an element.
std::string value_text(const Scene& scene, const Parameter& parameter, Digits digits = Digits::readable);

/// The value without a word in the scene; of a repeated section, that of an element.
std::string default_text(const Parameter& parameter);

}  // namespace offing::scene
