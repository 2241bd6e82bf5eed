#include "present/editing/edit_words.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/scene_elements.h"
#include "present/editing/objects/scene_objects.h"
#include "present/output/camera_path.h"
#include "present/panels/panels.h"
#include "present/panels/parameter_widget.h"

namespace offing::present {
namespace {

using scene::ElementIndex;
using scene::Parameter;
using scene::Scene;

// Objects that bring others with them come first: a body has meshes and wakes.
constexpr std::array listed_kinds{
    ObjectKind::body,    ObjectKind::mesh, ObjectKind::cloud_layer, ObjectKind::cloud, ObjectKind::light,
    ObjectKind::terrain, ObjectKind::lake, ObjectKind::sea,         ObjectKind::wake,  ObjectKind::bookmark};

bool is_same_in(const Parameter& row, const Scene& one, ElementIndex in_one, const Scene& other,
                ElementIndex in_other) {
  return scene::is_same_value(row, scene::struct_at(&one, *row.section, in_one),
                              scene::struct_at(&other, *row.section, in_other));
}

/// The first object of a kind that `scene` has and `other` lacks. `other` has fewer of this kind.
SceneObject missing_object(const Scene& scene, const Scene& other, ObjectKind kind) {
  const std::size_t count = count_of(other, kind);
  const scene::ParameterGroup group = groups_of(kind).front();
  const auto is_same = [&](std::size_t index) {
    return std::ranges::all_of(scene::parameter_table(), [&](const Parameter& row) {
      return row.group != group || is_same_in(row, scene, {index, 0}, other, {index, 0});
    });
  };
  std::size_t index = 0;
  while (index < count && is_same(index)) ++index;
  return {kind, index};
}

/// Which object came or went; empty if there are as many of each kind as before.
std::string words_of_objects(const Scene& before, const Scene& after) {
  for (const ObjectKind kind : listed_kinds) {
    const std::size_t count = count_of(before, kind), count_after = count_of(after, kind);
    if (count_after > count) return "add " + label_of(after, missing_object(after, before, kind));
    if (count_after == count) continue;
    const std::string label = label_of(before, missing_object(before, after, kind));
    const bool keeps_meshes = count_of(before, ObjectKind::mesh) == count_of(after, ObjectKind::mesh);
    return (kind == ObjectKind::body && keeps_meshes ? "stop floating " : "delete ") + label;
  }
  return {};
}

/// "particle edit" of `cloud.particle_edit`.
std::string section_words(const scene::Section& section) {
  std::string words(scene::name_of(section.name));
  std::ranges::replace(words, '_', ' ');
  return words;
}

/// The name of the object, or else of the panel, that shows a row's value.
std::string owner_of(const Scene& scene, const Parameter& row, ElementIndex element) {
  const scene::Section* listed = row.section->is_repeated() ? row.section : row.section->repeated_parent();
  if (listed == nullptr) return std::ranges::find(group_panels(), row.group, &GroupPanel::group)->title;
  const scene::Section* outer = listed->repeated_parent();
  const std::string within =
      outer ? fmt::format(", {} {}", section_words(*listed), element.inner + 1) : std::string();
  for (const ObjectKind kind : listed_kinds) {
    const auto is_of_kind = [&](const Parameter& own) {
      return own.group == groups_of(kind).front() && own.section == (outer ? outer : listed);
    };
    if (std::ranges::any_of(scene::parameter_table(), is_of_kind))
      return label_of(scene, {kind, element.outer}) + within;
  }
  return fmt::format("{} {}", section_words(*listed), element.outer + 1) + within;
}

/// How a value differs from what it was.
enum class Difference { none, value, keyframes };

Difference difference(const Scene& before, const Scene& after, const Parameter& row, ElementIndex element) {
  const bool is_of_eye = row.group == scene::ParameterGroup::camera;
  if (!is_of_eye && !is_same_in(row, before, element, after, element)) return Difference::value;
  if (is_of_eye && !(has_camera_path(before) && has_camera_path(after))) return Difference::none;
  constexpr std::size_t most_numbers = 3;
  for (std::size_t number = 0; number < most_numbers; ++number) {
    const auto was = before.tracks.find({row.key, element, number}),
               is = after.tracks.find({row.key, element, number});
    const bool was_there = was != before.tracks.end(), is_there = is != after.tracks.end();
    if (was_there != is_there || (is_there && was->second != is->second)) return Difference::keyframes;
  }
  return Difference::none;
}

}  // namespace

std::string edit_words(const Scene& before, const Scene& after) {
  if (std::string words = words_of_objects(before, after); !words.empty()) return words;
  constexpr std::size_t most_named = 3;
  std::string owner;
  std::vector<std::string> values;
  bool has_one_owner = true;
  for (const Parameter& row : scene::parameter_table()) {
    const std::vector<ElementIndex> elements = scene::elements_of(after, *row.section);
    const std::vector<ElementIndex> were = scene::elements_of(before, *row.section);
    if (were.size() != elements.size())
      return fmt::format("{} {}", were.size() < elements.size() ? "add" : "delete",
                         section_words(*row.section));
    // As many, but others: of clouds with other balls each.
    if (were != elements) return fmt::format("change {}", section_words(*row.section));
    for (const ElementIndex element : elements) {
      const Difference differs = difference(before, after, row, element);
      if (differs == Difference::none) continue;
      const std::string owned_by = owner_of(after, row, element);
      if (owner.empty()) owner = owned_by;
      has_one_owner &= owner == owned_by;
      values.push_back(words_of(row) + (differs == Difference::keyframes ? " (keyframes)" : ""));
    }
  }
  if (values.empty()) return "no change";
  std::string words = fmt::format("{}: {}", owner, values.front());
  if (!has_one_owner || values.size() > most_named)
    return fmt::format("{} and {} more", words, values.size() - 1);
  for (std::size_t i = 1; i < values.size(); ++i) words += ", " + values[i];
  return words;
}

}  // namespace offing::present
