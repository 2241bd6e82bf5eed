// Half an hour of storm: bodies and wake are the same bits at each minute, whatever the frames are.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <functional>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "host/world/world.h"
#include "tests/world/floating_world.h"

namespace offing::world {
namespace {

constexpr int minutes = 30;

/// FNV-1a of 64 bits.
class Hash {
 public:
  template <class Value>
  void add(std::span<const Value> values) {
    for (const std::byte byte : std::as_bytes(values)) {
      hash_ = (hash_ ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3u;
    }
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325u;
};

/// Bodies and wakes alone: the rest of a world has no history.
struct Histories {
  explicit Histories(const WorldParameters& parameters)
      : bodies(device, parameters.bodies, {parameters.spectrum, parameters.ocean}, parameters.run_up_s, 0.0),
        wakes(device, parameters.wakes) {}

  void at(double time_s) {
    bodies.reach(time_s);
    wakes.at(time_s, {}, &bodies);
  }

  std::uint64_t hash(double time_s) const {
    Hash hash;
    for (std::size_t body = 0; body < bodies.size(); ++body) {
      const BodyState state = bodies::device_state(bodies.pose(body, time_s));
      hash.add(std::span(&state, 1));
    }
    const ocean::WakeState wake = wakes.windows()[0].read_state();
    hash.add(std::span<const float>(wake.height_m));
    hash.add(std::span<const float>(wake.second_m));
    return hash.value();
  }

  ocl::Device device = ocl::Device::open();
  WorldBodies bodies;
  WorldWakes wakes;
};

/// The hash of each minute; each frame is followed by that of `next_s`.
std::vector<std::uint64_t> hashes_of(const char* name, const std::function<double(double time_s)>& next_s) {
  Histories histories(test::floating_world(20.0));
  const std::clock_t start = std::clock();
  std::vector<std::uint64_t> hashes;
  double time_s = 0.0;
  for (int minute = 1; minute <= minutes; ++minute) {
    for (; time_s < 60.0 * minute; time_s = std::min(next_s(time_s), 60.0 * minute)) histories.at(time_s);
    histories.at(time_s);
    hashes.push_back(histories.hash(time_s));
    std::printf("%s, minute %d: %016llx\n", name, minute, static_cast<unsigned long long>(hashes.back()));
    std::fflush(stdout);
  }
  std::printf("%s: %.2f s of CPU a simulated minute\n", name,
              static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / minutes);
  return hashes;
}

// Fails if any frame rate leads elsewhere. Measured on two cores with PoCL: 2.7 s of CPU a simulated minute.
TEST(BodyStormTest, IsTheSameAtEachMinuteWhateverTheFramesAre) {
  const auto at_rate = [](double frames_per_s) {
    return [frames_per_s](double time_s) {
      return (std::floor(time_s * frames_per_s + 0.5) + 1.0) / frames_per_s;
    };
  };
  const std::vector<std::uint64_t> expected = hashes_of("30 frames a second", at_rate(30.0));
  EXPECT_EQ(hashes_of("15 frames a second", at_rate(15.0)), expected);
  EXPECT_EQ(hashes_of("60 frames a second", at_rate(60.0)), expected);
  std::uint32_t seed = 1;
  EXPECT_EQ(hashes_of("irregular frames",
                      [&](double time_s) {
                        seed = 1664525u * seed + 1013904223u;
                        return time_s + 0.004 + 0.15 * (seed >> 8) / 0x1p24;
                      }),
            expected);
}

}  // namespace
}  // namespace offing::world
