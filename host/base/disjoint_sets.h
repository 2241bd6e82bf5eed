#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace offing {

/// Which of n things belong together (union-find; Tarjan 1975, with halved paths). Each thing also has a
/// parity against the first of its set: whether it lies the other way round.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parents_(count), parities_(count, 0) {
    std::iota(parents_.begin(), parents_.end(), 0u);
  }

  /// The item that stands for a set, as another item of it sees that.
  struct Root {
    std::uint32_t index;
    bool is_turned;  ///< against the root
  };

  Root root_of(std::uint32_t item) {
    bool is_turned = false;
    while (parents_[item] != item) {
      const std::uint32_t parent = parents_[item];
      parities_[item] ^= parities_[parent];
      parents_[item] = parents_[parent];
      is_turned ^= parities_[item] != 0;
      item = parents_[item];
    }
    return {item, is_turned};
  }

  /// How an item stands to another of its set, for example whether two faces turn the same way.
  enum class Relation : std::uint8_t { same, turned };

  /// Joins two things; false if they are in one set already with the other relation.
  bool join(std::uint32_t a, std::uint32_t b, Relation relation = Relation::same) {
    const Root first = root_of(a), second = root_of(b);
    const bool is_turned = (relation == Relation::turned) != (first.is_turned != second.is_turned);
    if (first.index == second.index) return !is_turned;
    // The lower index is the root: sets do not depend on the order of joins.
    const auto [root, child] = std::minmax(first.index, second.index);
    parents_[child] = root;
    parities_[child] = is_turned ? 1 : 0;
    return true;
  }

 private:
  std::vector<std::uint32_t> parents_;
  std::vector<std::uint8_t> parities_;  // against the parent
};

}  // namespace offing
