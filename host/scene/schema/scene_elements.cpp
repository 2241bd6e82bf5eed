#include "host/scene/schema/scene_elements.h"

#include <map>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/scene/schema/parameter_table.h"

namespace offing::scene {

namespace {

/// Drops what a map knows of an element and counts those behind it one less.
template <class Value>
void forget(std::map<ValueKey, Value>& map, const RepeatedSection& section, ElementIndex element) {
  std::map<ValueKey, Value> kept;
  for (auto& [key, value] : map) {
    const RepeatedSection* of_key = find_parameter(key.key)->elements;
    ValueKey now = key;
    if (of_key == &section && section.parent) {
      if (key.element == element) continue;
      if (key.element.outer == element.outer && key.element.inner > element.inner) --now.element.inner;
    } else if (of_key && (of_key == &section || of_key->parent == &section)) {
      if (key.element.outer == element.outer) continue;
      if (key.element.outer > element.outer) --now.element.outer;
    }
    kept.emplace(now, std::move(value));
  }
  map = std::move(kept);
}

}  // namespace

ElementIndex last_element(const Scene& scene, const RepeatedSection* section) {
  if (!section) return {};
  ElementIndex last = last_element(scene, section->parent);
  if (section->parent && section->parent->count(scene, {}) == 0) return last;
  const std::size_t count = section->count(scene, last);
  (section->parent ? last.inner : last.outer) = count == 0 ? 0 : count - 1;
  return last;
}

std::vector<ElementIndex> elements_of(const Scene& scene, const RepeatedSection* section) {
  if (!section) return {{}};
  std::vector<ElementIndex> elements;
  for (const ElementIndex parent : elements_of(scene, section->parent)) {
    for (std::size_t i = 0; i < section->count(scene, parent); ++i) {
      elements.push_back(section->parent ? ElementIndex{parent.outer, i} : ElementIndex{i, 0});
    }
  }
  return elements;
}

ElementIndex last_element_or_first(Scene& scene, const Parameter& parameter, const Place& place) {
  const RepeatedSection* section = parameter.elements;
  const auto has_none = [&] {
    return (section->parent && section->parent->count(scene, {}) == 0) ||
           section->count(scene, last_element(scene, section->parent)) == 0;
  };
  if (section && has_none()) append_element(scene, parameter, place);
  return last_element(scene, section);
}

void append_element(Scene& scene, const Parameter& parameter, const Place& place) {
  const RepeatedSection* section = parameter.elements;
  if (!section) return;
  if (section->parent && section->parent->count(scene, {}) == 0) section->parent->append(scene, {});
  const ElementIndex parent = last_element(scene, section->parent);
  if (section->count(scene, parent) == parameter.max_count) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("{}: expected at most {} sections, found more", place.subject, parameter.max_count),
        "remove the sections that are too many");
  }
  section->append(scene, parent);
}

void remove_element(Scene& scene, const RepeatedSection& section, ElementIndex element) {
  section.remove(scene, element);
  forget(scene.tracks, section, element);
  forget(scene.set_at, section, element);
}

std::vector<double*> numbers_of(Scene& scene, const Parameter& parameter, ElementIndex element) {
  const auto numbers = [&](const auto& storage) -> std::vector<double*> {
    using Kind = std::remove_cvref_t<decltype(storage)>;
    if constexpr (std::is_same_v<Kind, ValueAt<double>>) {
      return {&storage(scene, element)};
    } else if constexpr (std::is_same_v<Kind, ValueAt<std::optional<double>>>) {
      std::optional<double>& number = storage(scene, element);
      if (!number) return {};
      return {&*number};
    } else if constexpr (std::is_same_v<Kind, ValueAt<glm::dvec3>>) {
      glm::dvec3& triple = storage(scene, element);
      return {&triple.x, &triple.y, &triple.z};
    } else {
      return {};
    }
  };
  return std::visit(numbers, parameter.storage);
}

void copy_value(Scene& from, ElementIndex from_element, const Parameter& parameter, Scene& to,
                ElementIndex to_element) {
  std::visit(
      [&](const auto& storage) {
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(storage)>, ChoiceStorage>) {
          storage.set(to, to_element, storage.get(from, from_element));
        } else {
          storage(to, to_element) = storage(from, from_element);
        }
      },
      parameter.storage);
}

}  // namespace offing::scene
