#include "host/scene/file/track_reader.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/base/error.h"
#include "host/scene/file/nearest_name.h"
#include "host/scene/file/parameter_track.h"
#include "host/scene/file/toml_value.h"

namespace offing::scene {

namespace {

class TrackReader {
 public:
  TrackReader(const Parameter& parameter, std::string_view file) : parameter_(parameter), file_(file) {}

  void read(Scene& scene, const toml::table& table) const {
    require_known(table, std::array<std::string_view, 2>{"keys", "interpolation"});
    store_track(scene, parameter_, keys_of(*table.get("keys")), interpolation_of(table),
                place_of(table, parameter_.key));
  }

 private:
  Place place_of(const toml::node& node, std::string_view subject) const {
    return {.subject = fmt::format("{}: {}", place_text(file_, node.source()), subject)};
  }

  void require_known(const toml::table& table, std::span<const std::string_view> names) const {
    for (const auto& [key, node] : table) {
      if (std::find(names.begin(), names.end(), key.str()) != names.end()) continue;
      const std::string_view near = nearest_name(key.str(), names);
      throw Error(ErrorKind::bad_input,
                  fmt::format("{}: {}: expected keys of keyframes, got \"{}\"",
                              place_text(file_, key.source()), parameter_.key, key.str().substr(0, 60)),
                  near.empty() ? fmt::format("known here: {}", fmt::join(names, ", "))
                               : fmt::format("did you mean {}?", near));
    }
  }

  [[noreturn]] void refuse(const toml::node& node, std::string_view expected) const {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected {}, got {}", place_of(node, parameter_.key).subject, expected,
                            shown_text(node)),
                "write keys = [{ t = 0, value = 1 }, { t = 2, value = 3 }]");
  }

  std::vector<WrittenKeyframe> keys_of(const toml::node& node) const {
    const toml::array* elements = node.as_array();
    if (!elements) refuse(node, "a list of keys");
    std::vector<WrittenKeyframe> keys;
    for (const toml::node& element : *elements) {
      const toml::table* key = element.as_table();
      if (!key) refuse(element, "a key { t = ..., value = ... }");
      require_known(*key, std::array<std::string_view, 2>{"t", "value"});
      const toml::node *time = key->get("t"), *value = key->get("value");
      if (!time || !value) refuse(element, "a key of t and value");
      Place value_place = place_of(*value, parameter_.key);
      value_place.assignment = "value = ";
      keys.push_back({.time = written_value(*time),
                      .value = written_value(*value),
                      .time_place = place_of(*time, fmt::format("{}: t", parameter_.key)),
                      .value_place = std::move(value_place)});
    }
    return keys;
  }

  Interpolation interpolation_of(const toml::table& table) const {
    const toml::node* node = table.get("interpolation");
    if (!node) return {};
    const std::optional<std::string> name = node->value_exact<std::string>();
    if (name == "smooth") return Interpolation::smooth;
    if (name == "linear") return Interpolation::linear;
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected one of smooth, linear, got {}",
                            place_of(*node, fmt::format("{}: interpolation", parameter_.key)).subject,
                            shown_text(*node)),
                "write interpolation = \"smooth\"");
  }

  const Parameter& parameter_;
  std::string_view file_;
};

}  // namespace

void read_track(Scene& scene, const Parameter& parameter, const toml::table& table, std::string_view file) {
  TrackReader(parameter, file).read(scene, table);
}

}  // namespace offing::scene
