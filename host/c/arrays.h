#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>

#include <glm/vec3.hpp>

/// Arrays of the caller. NULL means not wanted: nothing is written.
namespace offing::c {

/// Writes the row `index` of array [count][values.size()].
template <class Number>
void write_values(Number* array, std::size_t index, std::initializer_list<Number> values) {
  if (array != nullptr) std::copy(values.begin(), values.end(), array + index * values.size());
}

/// Writes the row `index` of array [count][3].
template <class Number>
void write_vector(Number* array, std::size_t index, const glm::dvec3& vector) {
  write_values<Number>(
      array, index,
      {static_cast<Number>(vector.x), static_cast<Number>(vector.y), static_cast<Number>(vector.z)});
}

/// The row `index` of array [count][3].
inline glm::dvec3 vector_at(const double* array, std::size_t index) {
  return {array[3 * index], array[3 * index + 1], array[3 * index + 2]};
}

}  // namespace offing::c
