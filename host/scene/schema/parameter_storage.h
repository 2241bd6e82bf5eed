#pragma once

#include <cstddef>
#include <numbers>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "host/scene/schema/parameter.h"

namespace offing::scene {

/// The member that a path of member pointers leads to.
template <auto... path>
auto& member(Scene& scene, ElementIndex) {
  return (scene.*....*path);
}

/// That of an element of a list of the scene.
template <auto list, auto... path>
auto& element(Scene& scene, ElementIndex index) {
  return ((scene.*list)[index.outer].*....*path);
}

/// That of an element of a list in an element of a list.
template <auto list, auto inner_list, auto... path>
auto& inner_element(Scene& scene, ElementIndex index) {
  return (((scene.*list)[index.outer].*inner_list)[index.inner].*....*path);
}

/// One of several named values at such a place.
template <auto at>
ChoiceStorage choice_at(const std::vector<std::string_view>& names) {
  using Enum = std::remove_reference_t<decltype(at(std::declval<Scene&>(), ElementIndex{}))>;
  return {.names = names,
          .get = [](Scene& scene, ElementIndex index) { return static_cast<std::size_t>(at(scene, index)); },
          .set = [](Scene& scene, ElementIndex index,
                    std::size_t value) { at(scene, index) = static_cast<Enum>(value); }};
}

template <auto... path>
ChoiceStorage choice(const std::vector<std::string_view>& names) {
  return choice_at<&member<path...>>(names);
}

/// The section of a list of the scene.
template <auto list>
inline constexpr RepeatedSection section_of_list{
    .count = [](const Scene& scene, ElementIndex) { return (scene.*list).size(); },
    .append = [](Scene& scene, ElementIndex) { (scene.*list).emplace_back(); },
    .remove =
        [](Scene& scene, ElementIndex index) {
          (scene.*list).erase((scene.*list).begin() + static_cast<std::ptrdiff_t>(index.outer));
        }};

/// The section of a list in the elements of a list.
template <auto list, auto inner_list>
inline constexpr RepeatedSection section_of_inner_list{
    .parent = &section_of_list<list>,
    .count = [](const Scene& scene,
                ElementIndex index) { return ((scene.*list)[index.outer].*inner_list).size(); },
    .append = [](Scene& scene,
                 ElementIndex index) { ((scene.*list)[index.outer].*inner_list).emplace_back(); },
    .remove =
        [](Scene& scene, ElementIndex index) {
          auto& inner = (scene.*list)[index.outer].*inner_list;
          inner.erase(inner.begin() + static_cast<std::ptrdiff_t>(index.inner));
        }};

/// Rows of one repeated section: of scene files only.
inline std::vector<Parameter> rows_of_section(const RepeatedSection& section, ParameterGroup group,
                                              std::size_t max_count, std::vector<Parameter> rows) {
  for (Parameter& row : rows) {
    row.elements = &section;
    row.group = group;
    row.max_count = max_count;
  }
  return rows;
}

inline constexpr double radians_per_degree = std::numbers::pi / 180.0;

}  // namespace offing::scene
