#pragma once

#include <cstddef>
#include <numbers>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "host/scene/parameter.h"

namespace offing::scene {

/// The member that a path of member pointers leads to.
template <auto... path>
auto& member(OceanScene& scene) {
  return (scene.*....*path);
}

/// One of several named values at the end of such a path.
template <auto... path>
ChoiceStorage choice(const std::vector<std::string_view>& names) {
  using Enum = std::remove_reference_t<decltype(member<path...>(std::declval<OceanScene&>()))>;
  return {
      .names = names,
      .get = [](OceanScene& scene) { return static_cast<std::size_t>(member<path...>(scene)); },
      .set = [](OceanScene& scene, std::size_t index) { member<path...>(scene) = static_cast<Enum>(index); }};
}

/// A number of each element of a list of the scene.
template <auto list, auto field>
ElementStorage element() {
  using Scene = OceanScene;
  using Number = std::remove_reference_t<decltype((std::declval<Scene&>().*list).front().*field)>;
  return {.count = [](const Scene& scene) { return (scene.*list).size(); },
          .append = [](Scene& scene) { (scene.*list).emplace_back(); },
          .remove =
              [](Scene& scene, std::size_t index) {
                (scene.*list).erase((scene.*list).begin() + static_cast<std::ptrdiff_t>(index));
              },
          .at = [](Scene& scene, std::size_t index) -> Number& { return (scene.*list)[index].*field; }};
}

inline constexpr double radians_per_degree = std::numbers::pi / 180.0;

}  // namespace offing::scene
