#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace offing::test {

/// The mean square by which pixels of a picture of so many columns differ that are 1 ... 4 apart in a row or
/// a column.
inline double gradient_energy(const std::vector<double>& image, std::size_t columns) {
  double sum = 0.0;
  std::size_t count = 0;
  const auto add = [&](std::size_t i, std::size_t j) {
    sum += std::pow(image[j] - image[i], 2);
    ++count;
  };
  for (std::size_t i = 0; i < image.size(); ++i) {
    for (std::size_t away = 1; away <= 4; ++away) {
      if (i % columns + away < columns) add(i, i + away);
      if (i + away * columns < image.size()) add(i, i + away * columns);
    }
  }
  return sum / static_cast<double>(count);
}

/// Gradient energy of the difference between a picture and means over squares of pixels of one that is so
/// many times as fine, over that of the picture.
inline double aliasing(const std::vector<double>& found, const std::vector<double>& fine, std::size_t columns,
                       std::size_t times) {
  std::vector<double> errors = found;
  for (std::size_t i = 0; i < fine.size(); ++i) {
    const std::size_t row = i / (columns * times) / times, column = i % (columns * times) / times;
    errors[row * columns + column] -= fine[i] / static_cast<double>(times * times);
  }
  return gradient_energy(errors, columns) / gradient_energy(found, columns);
}

}  // namespace offing::test
