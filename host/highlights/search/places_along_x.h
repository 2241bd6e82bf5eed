#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

namespace offing::highlights {

/// Places in the order of their x, so that those near another are found without looking at all: noisy scans
/// have thousands of highlights.
class PlacesAlongX {
 public:
  void add(std::size_t index, const glm::dvec3& place_m) { places_.emplace_back(place_m.x, index); }
  /// Once, after all are added.
  void sort() { std::sort(places_.begin(), places_.end()); }

  /// Visits the indices of all places that are within the reach along x, and so all within it.
  template <class Visit>
  void visit_near(const glm::dvec3& place_m, double reach_m, const Visit& visit) const {
    auto place =
        std::lower_bound(places_.begin(), places_.end(), std::pair(place_m.x - reach_m, std::size_t{0}));
    for (; place != places_.end() && place->first <= place_m.x + reach_m; ++place) visit(place->second);
  }

 private:
  std::vector<std::pair<double, std::size_t>> places_;  // x, index
};

}  // namespace offing::highlights
