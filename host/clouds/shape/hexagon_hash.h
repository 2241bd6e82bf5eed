#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <unordered_map>
#include <vector>

#include <glm/vec3.hpp>

namespace offing::clouds {

/// Places in hexagonal cells (C7): prisms on a lattice of regular hexagons in x and z, as high as their edges
/// are long. What lies within an edge's length of a place is in its own prism or the 20 around it: the border
/// of the seven hexagons around a point is nowhere nearer than that, at the notches between two of them.
class HexagonHash {
 public:
  /// edge_m: the largest distance that will be asked for.
  explicit HexagonHash(double edge_m) : edge_m_(edge_m) {}

  void insert(const glm::dvec3& place_m, std::uint32_t number) {
    cells_[key(cell_of(place_m))].push_back(number);
  }

  /// Calls visit(number) for every place within an edge's length, and for some beyond, until one returns
  /// false; whether none did.
  template <typename Visit>
  bool all_near(const glm::dvec3& place_m, const Visit& visit) const {
    constexpr std::array<std::array<int, 2>, 7> ring{
        {{0, 0}, {1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}}};
    const Cell middle = cell_of(place_m);
    for (int layer = -1; layer <= 1; ++layer) {
      for (const auto& [q, r] : ring) {
        const auto found = cells_.find(key({middle.q + q, middle.r + r, middle.layer + layer}));
        if (found == cells_.end()) continue;
        for (const std::uint32_t number : found->second) {
          if (!visit(number)) return false;
        }
      }
    }
    return true;
  }

 private:
  struct Cell {
    std::int64_t q, r, layer;
  };

  /// Axial coordinates: the nearest hexagon's middle is that of the nearest of cubes on the plane
  /// q + r + s = 0.
  Cell cell_of(const glm::dvec3& place_m) const {
    const double r = 2.0 / 3.0 * place_m.z / edge_m_;
    const double q = (place_m.x / std::numbers::sqrt3 - place_m.z / 3.0) / edge_m_;
    double whole_q = std::round(q), whole_r = std::round(r);
    const double whole_s = std::round(-q - r);
    const double off_q = std::abs(whole_q - q), off_r = std::abs(whole_r - r),
                 off_s = std::abs(whole_s + q + r);
    if (off_q > off_r && off_q > off_s) {
      whole_q = -whole_r - whole_s;
    } else if (off_r > off_s) {
      whole_r = -whole_q - whole_s;
    }
    return {static_cast<std::int64_t>(whole_q), static_cast<std::int64_t>(whole_r),
            static_cast<std::int64_t>(std::floor(place_m.y / edge_m_))};
  }

  /// Cells 2^21 apart share a list, which costs time alone.
  static std::uint64_t key(const Cell& cell) {
    constexpr std::uint64_t mask = (1u << 21) - 1;
    return (static_cast<std::uint64_t>(cell.q) & mask) | (static_cast<std::uint64_t>(cell.r) & mask) << 21 |
           (static_cast<std::uint64_t>(cell.layer) & mask) << 42;
  }

  double edge_m_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

}  // namespace offing::clouds
