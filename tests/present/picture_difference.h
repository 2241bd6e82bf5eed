#pragma once

#include <cmath>

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

}  // namespace offing::test
