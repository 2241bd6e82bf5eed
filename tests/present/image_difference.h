#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include "host/io/png_image.h"

namespace offing::test {

/// Mean difference of two pictures, in steps of a byte: 0 ... 255. Fails the test if their sizes differ.
inline double mean_difference(const RgbImage& found, const RgbImage& expected) {
  EXPECT_EQ(found.width, expected.width);
  EXPECT_EQ(found.rgb.size(), expected.rgb.size());
  if (found.rgb.size() != expected.rgb.size() || found.rgb.empty()) return 255.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < found.rgb.size(); ++i) sum += std::abs(found.rgb[i] - expected.rgb[i]);
  return sum / static_cast<double>(found.rgb.size());
}

/// The share of pixels with a colour that differs by more than so many steps of a byte, of pictures of one
/// size.
inline double share_beyond(const RgbImage& found, const RgbImage& expected, int steps) {
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < found.rgb.size(); i += 3) {
    int most = 0;
    for (std::size_t k = i; k < i + 3; ++k) most = std::max(most, std::abs(found.rgb[k] - expected.rgb[k]));
    if (most > steps) ++beyond;
  }
  return 3.0 * static_cast<double>(beyond) / static_cast<double>(found.rgb.size());
}

}  // namespace offing::test
