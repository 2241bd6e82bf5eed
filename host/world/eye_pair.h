#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace offing::world {

/// What is kept for the last two eyes: over a sea an eye and its mirror image take turns. A Kept's `eye_m` is
/// the place of its eye, or nothing where it is nobody's.
template <typename Kept>
class EyePair {
 public:
  EyePair(Kept first, Kept second) : kept_{std::move(first), std::move(second)} {}

  /// Makes current() what is kept for an eye that is_alike(its place), or else what is given up for this one:
  /// nobody's, or that of the nearest eye. Whether there was an alike eye.
  template <typename IsAlike>
  bool choose(const glm::dvec3& eye_m, const IsAlike& is_alike) {
    const auto alike =
        std::ranges::find_if(kept_, [&](const Kept& of) { return of.eye_m && is_alike(*of.eye_m); });
    const bool has_alike = alike != kept_.end();
    const auto far_m = [&](const Kept& of) { return of.eye_m ? glm::distance(*of.eye_m, eye_m) : 0.0; };
    const auto chosen = has_alike ? alike : std::ranges::min_element(kept_, {}, far_m);
    current_ = static_cast<std::size_t>(chosen - kept_.begin());
    return has_alike;
  }

  Kept& current() { return kept_[current_]; }
  const Kept& current() const { return kept_[current_]; }
  std::array<Kept, 2>& both() { return kept_; }

 private:
  std::array<Kept, 2> kept_;
  std::size_t current_ = 0;
};

}  // namespace offing::world
