#include "host/cli/scene/json_schema.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "host/base/parameter_check.h"
#include "host/scene/file/parameter_track.h"
#include "host/scene/file/scene_reader.h"
#include "host/scene/schema/checked_value.h"
#include "host/scene/schema/parameter_table.h"

namespace offing::cli {

namespace {

using nlohmann::ordered_json;
using scene::Parameter;
using scene::ParameterMotion;
using scene::ParameterRule;
using scene::Section;

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

ordered_json within(const char* type, double low, double high) {
  return {{"type", type}, {"minimum", number_json(low)}, {"maximum", number_json(high)}};
}

ordered_json powers_of_two(const Parameter& row) {
  ordered_json powers = ordered_json::array();
  for (double power = 1.0; power <= row.high; power *= 2.0) {
    if (power >= row.low) powers.push_back(number_json(power));
  }
  return {{"enum", std::move(powers)}};
}

/// What a value without keyframes must be.
ordered_json value_schema(const Parameter& row) {
  const auto triple = [&] {
    return ordered_json{
        {"type", "array"}, {"items", within("number", row.low, row.high)}, {"minItems", 3}, {"maxItems", 3}};
  };
  return std::visit(Overloaded{[&](scene::ValueAt<int>) {
                                 return row.rule == ParameterRule::power_of_two
                                            ? powers_of_two(row)
                                            : within("integer", row.low, row.high);
                               },
                               [](scene::ValueAt<std::uint64_t>) {
                                 return ordered_json{{"type", "integer"},
                                                     {"minimum", 0},
                                                     {"maximum", std::numeric_limits<std::int64_t>::max()}};
                               },
                               [](scene::ValueAt<std::string>) {
                                 return ordered_json{{"type", "string"}, {"minLength", 1}};
                               },
                               // A date of TOML is a string in JSON.
                               [](scene::ValueAt<std::optional<UtcTime>>) {
                                 return ordered_json{{"type", "string"}, {"format", "date-time"}};
                               },
                               [&](scene::ValueAt<glm::dvec3>) { return triple(); },
                               [&](scene::ValueAt<std::optional<glm::dvec3>>) { return triple(); },
                               [](const scene::ChoiceStorage& choice) {
                                 return ordered_json{{"enum", choice.names}};
                               },
                               [&](const auto&) { return within("number", row.low, row.high); }},
                    row.storage);
}

ordered_json closed_object(ordered_json properties, const std::vector<std::string_view>& required = {}) {
  ordered_json object = {
      {"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}};
  if (!required.empty()) object["required"] = required;
  return object;
}

/// `{ keys = [{ t = 0, value = 1 }], interpolation = "linear" }`
ordered_json keyframes_schema(const ordered_json& value) {
  const ordered_json key =
      closed_object({{"t", {{"$ref", "#/definitions/time_s"}}}, {"value", value}}, {"t", "value"});
  const ordered_json keys = {
      {"type", "array"}, {"items", key}, {"minItems", 1}, {"maxItems", scene::most_keyframes}};
  return closed_object({{"keys", keys}, {"interpolation", {{"$ref", "#/definitions/interpolation"}}}},
                       {"keys"});
}

std::string description_of(const Parameter& row) {
  std::string text = fmt::format("{}\n\n{}", row.help, expected_text(row));
  if (const std::string usual = default_text(row); !usual.empty()) text += fmt::format("; default {}", usual);
  if (row.motion != ParameterMotion::constant) text += "; may have keyframes";
  return text;
}

ordered_json row_schema(const Parameter& row) {
  ordered_json schema = {{"description", description_of(row)}};
  if (ordered_json usual = default_json(row); !usual.is_null()) schema["default"] = std::move(usual);
  ordered_json value = value_schema(row);
  if (row.motion == ParameterMotion::constant) {
    schema.update(value);
  } else {
    schema["anyOf"] = {value, keyframes_schema(value)};
  }
  return schema;
}

/// Two keys of which a section has one at most.
void exclude(ordered_json& section, std::string_view one, std::string_view other) {
  section["allOf"].push_back({{"not", {{"required", {one, other}}}}});
}

/// The schema of the values of a section with at most so many elements, which is made where there is none
/// yet. `root` is the scene's.
ordered_json& section_schema(ordered_json& root, const Section& section, std::size_t most_elements) {
  ordered_json& parent =
      section.parent ? section_schema(root, *section.parent, section.parent->max_count) : root;
  ordered_json& schema = parent["properties"][std::string(scene::name_of(section.name))];
  if (schema.is_null()) {
    schema = closed_object(ordered_json::object());
    if (most_elements > 1)
      schema = {{"type", "array"}, {"items", schema}, {"minItems", 1}, {"maxItems", most_elements}};
  }
  return most_elements > 1 ? schema["items"] : schema;
}

void add_row(ordered_json& root, const Parameter& row) {
  ordered_json& section = section_schema(root, *row.section, row.max_count);
  const std::string_view name = scene::name_of(row.key);
  const ordered_json schema = row_schema(row);
  section["properties"][std::string(name)] = schema;
  if (!row.instead_of.empty()) exclude(section, name, scene::name_of(row.instead_of));
  if (row.alias.empty()) return;
  const std::string_view earlier = scene::name_of(row.alias);
  ordered_json deprecated = schema;
  deprecated["description"] = fmt::format("earlier name of {}", name);
  deprecated["deprecated"] = true;
  section["properties"][std::string(earlier)] = std::move(deprecated);
  exclude(section, name, earlier);
}

}  // namespace

ordered_json number_json(double number) {
  constexpr double most_exact = 1LL << 53;
  if (number == std::trunc(number) && std::abs(number) <= most_exact) {
    return static_cast<std::int64_t>(number);
  }
  return number;
}

ordered_json default_json(const Parameter& row) {
  const std::string text = default_text(row);
  if (is_text(row)) return text == row.absent ? ordered_json() : ordered_json(text);
  const ordered_json value = ordered_json::parse(text, nullptr, false);
  return value.is_discarded() ? ordered_json() : value;
}

ordered_json scene_json_schema() {
  ordered_json root = closed_object(
      {{"version", {{"description", "of the scene format"}, {"type", "integer"}, {"const", 1}}}},
      {"version"});
  for (const Parameter& row : scene::parameter_table()) add_row(root, row);
  root["properties"][std::string(scene::bench_section)] = {
      {"description", "for benchmarks; changes nothing in the scene"}, {"type", "object"}};
  ordered_json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", "Offing scene"}};
  schema.update(root);
  schema["definitions"] = {{"time_s", within("number", -largest_time_s, largest_time_s)},
                           {"interpolation", {{"enum", {"smooth", "linear"}}, {"default", "smooth"}}}};
  schema["definitions"]["time_s"]["description"] = "time of the scene in s";
  return schema;
}

}  // namespace offing::cli
