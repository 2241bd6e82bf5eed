#pragma once

#include <gtest/gtest.h>

#include "host/highlights/search/highlight_points.h"
#include "tests/highlights/example_surfaces.h"

namespace offing::highlights {

inline Source direction(const glm::dvec3& v) {
  return {Source::Kind::direction, v};
}
inline Source place(const glm::dvec3& v) {
  return {Source::Kind::place, v};
}

/// A search on the default device.
class HighlightSearch : public testing::Test {
 protected:
  HighlightSurface surface(const test::ExampleSurface& example, const SurfaceOptions& options = {}) const {
    return {device_, example.mesh, example.curvatures, options};
  }

  ocl::Device device_ = ocl::Device::open();
  HighlightFinder search_{device_};
};

}  // namespace offing::highlights
