#pragma once

#include <cmath>
#include <vector>

namespace offing::ocean {

template <class Value>
double mean_of(const std::vector<Value>& values) {
  double sum = 0.0;
  for (const Value value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// Mean square of values whose mean is 0.
template <class Value>
double mean_square(const std::vector<Value>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return sum / static_cast<double>(values.size());
}

/// Root mean square of the difference, over that of `expected`.
template <class Found, class Expected>
double relative_error(const std::vector<Found>& found, const std::vector<Expected>& expected) {
  double sum = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const double difference = static_cast<double>(found[i]) - static_cast<double>(expected[i]);
    sum += difference * difference;
  }
  return std::sqrt(sum / static_cast<double>(expected.size()) / mean_square(expected));
}

}  // namespace offing::ocean
