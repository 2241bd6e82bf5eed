#include "host/base/vertex_places.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace offing {

std::vector<std::uint32_t> first_at_place(std::span<const glm::dvec3> positions_m) {
  std::vector<std::uint32_t> order(positions_m.size()), first(positions_m.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto place = [&](std::uint32_t i) {
    const glm::dvec3& p = positions_m[i];
    return std::tie(p.x, p.y, p.z);
  };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return place(a) < place(b) || (place(a) == place(b) && a < b);
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_new = i == 0 || place(order[i]) != place(order[i - 1]);
    first[order[i]] = is_new ? order[i] : first[order[i - 1]];
  }
  return first;
}

}  // namespace offing
