#include "host/clouds/particles/radix_sort.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/clouds/particles/particle_order.h"
#include "kernels/shared/random.h"
#include "tests/ocl/scoped_environment.h"

namespace offing::clouds {
namespace {

std::uint32_t word(std::size_t i, std::uint32_t index) {
  return philox_block(11, 0, 0, static_cast<int>(i), 0, index).v[0];
}

/// Both shapes: that of CPUs and that of GPUs.
class RadixSortTest : public testing::TestWithParam<std::string> {
 protected:
  const offing::test::ScopedEnvironment shape_{"OFFING_SHAPE", GetParam()};
  const ocl::Device device_ = ocl::Device::open();
};

// Fails if a key is lost or misplaced, or two equal ones change places: beside std::stable_sort, for numbers
// of keys around the sizes of spans and tiles, all 32 bits, few different keys, and keys in either order.
TEST_P(RadixSortTest, IsStableAndSorted) {
  RadixSort sort(device_);
  for (const std::size_t count : {1, 2, 63, 64, 65, 1023, 1025, 3000, 8193, 100003}) {
    for (int kind = 0; kind < 4; ++kind) {
      std::vector<std::uint32_t> keys(count), values(count);
      for (std::size_t i = 0; i < count; ++i) {
        const auto rising = static_cast<std::uint32_t>(i * 40000u);
        keys[i] = kind == 0 ? word(i, 0) : kind == 1 ? word(i, 1) % 7u << 28 : kind == 2 ? rising : ~rising;
        values[i] = static_cast<std::uint32_t>(count - i);
      }
      std::vector<std::size_t> order(count);
      std::iota(order.begin(), order.end(), std::size_t{0});
      std::stable_sort(order.begin(), order.end(),
                       [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
      sort.reserve(static_cast<std::uint32_t>(count));
      sort.keys().write(keys);
      sort.values().write(values);
      sort.sort(static_cast<std::uint32_t>(count));
      std::vector<std::uint32_t> found_keys(count), found_values(count);
      sort.keys().read(found_keys);
      sort.values().read(found_values);
      for (std::size_t i = 0; i < count; ++i) {
        ASSERT_EQ(found_keys[i], keys[order[i]]) << count << ", " << kind << " at " << i;
        ASSERT_EQ(found_values[i], values[order[i]]) << count << ", " << kind << " at " << i;
      }
    }
  }
}

// Fails if particles are blended in a wrong order: distances fall, those at one distance keep their order,
// and one that is nowhere comes first. Along a light the ways rise, and what is nowhere comes last: the
// second one is as far away as can be, beside the light's way, and 0 times that is no number.
TEST_P(RadixSortTest, OrdersParticlesByDistance) {
  constexpr std::size_t count = 5000;
  std::vector<CloudParticle> particles(count);
  for (std::size_t i = 0; i < count; ++i) {
    CloudParticle& particle = particles[i];
    particle.x = std::floor(40.0f * uniform_open01(word(i, 0))) - 20.0f;
    particle.y = std::floor(40.0f * uniform_open01(word(i, 1))) - 20.0f;
    particle.z = std::floor(40.0f * uniform_open01(word(i, 2))) - 20.0f;
  }
  particles[77].y = std::nanf("");
  particles[78].x = std::numeric_limits<float>::infinity();
  const ocl::Buffer<CloudParticle> buffer(device_, particles, "particles");
  const glm::vec3 eye(3.0f, -7.0f, 1.0f), light(0.0f, -1.0f, 0.0f);
  ParticleOrder order(device_);
  const auto expect_order = [&](const ocl::Buffer<std::uint32_t>& found, const auto& key,
                                std::size_t lost_at) {
    std::vector<std::uint32_t> places(count);
    found.read(places);
    EXPECT_EQ(places[lost_at], 77u);
    for (std::size_t i = 1; i < count; ++i) {
      const float before = key(particles[places[i - 1]]), here = key(particles[places[i]]);
      if (std::isnan(before) || std::isnan(here)) continue;
      ASSERT_TRUE(before < here || (before == here && places[i - 1] < places[i])) << i;
    }
  };
  expect_order(
      order.far_to_near(buffer, count, eye),
      [&](const CloudParticle& p) {
        const glm::vec3 way = glm::vec3(p.x, p.y, p.z) - eye;
        return -(way.x * way.x + way.y * way.y + way.z * way.z);
      },
      0);

  expect_order(
      order.along_light(buffer, count, light),
      [&](const CloudParticle& p) { return std::isinf(p.x) ? std::nanf("") : p.y; }, count - 2);
  EXPECT_THROW(order.far_to_near(buffer, count + 1, eye), Error);
  order.far_to_near(buffer, 0, eye);
}

INSTANTIATE_TEST_SUITE_P(Shapes, RadixSortTest, testing::Values("simd", "workgroup"));

}  // namespace
}  // namespace offing::clouds
