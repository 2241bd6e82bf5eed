#include "kernels/shared/random.h"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "host/ocl/buffer.h"
#include "host/ocl/program.h"
#include "tests/ocl/test_kernels.h"

namespace offing {
namespace {

struct KnownAnswer {
  std::array<std::uint32_t, 4> counter;
  std::array<std::uint32_t, 2> key;
  std::array<std::uint32_t, 4> block;
};

// The known answers for philox4x32-10 that its authors publish with Random123 (Salmon et al. 2011): all bits
// zero, all bits one, and the digits of pi.
const std::vector<KnownAnswer> known_answers{
    {{0, 0, 0, 0}, {0, 0}, {0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}},
    {{0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff},
     {0xffffffff, 0xffffffff},
     {0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}},
    {{0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344},
     {0xa4093822, 0x299f31d0},
     {0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}},
};

constexpr const char* source = R"(
#include "shared/random.h"
kernel void blocks(global const PhiloxBlock* counters, global const uint* keys, global PhiloxBlock* blocks) {
  const size_t i = get_global_id(0);
  blocks[i] = philox_4x32_10(counters[i], keys[2 * i], keys[2 * i + 1]);
}
kernel void uniforms(uint seed_low, uint seed_high, int row, global PhiloxBlock* blocks, global float* values) {
  const int i = get_global_id(0);
  blocks[i] = philox_block(seed_low, seed_high, OFFING_STREAM_OCEAN_CASCADE + 2, i - 100, row, 5);
  values[i] = uniform_open01(blocks[i].v[1]);
}
)";

PhiloxBlock block_of(const std::array<std::uint32_t, 4>& words) {
  return {{words[0], words[1], words[2], words[3]}};
}

class RandomTest : public ::testing::Test {
 protected:
  RandomTest() { kernels_.write("random.cl", source); }

  test::TestKernels kernels_;
  ocl::Device device_ = ocl::Device::open();
};

// Fails if any round, multiplier or key step differs from the published generator, on either side.
TEST_F(RandomTest, GivesThePublishedBlocks) {
  std::vector<PhiloxBlock> counters;
  std::vector<std::uint32_t> keys;
  for (const KnownAnswer& answer : known_answers) {
    counters.push_back(block_of(answer.counter));
    keys.insert(keys.end(), answer.key.begin(), answer.key.end());
  }
  const ocl::Buffer<PhiloxBlock> counter_buffer(device_, counters, "counters");
  const ocl::Buffer<std::uint32_t> key_buffer(device_, keys, "keys");
  const ocl::Buffer<PhiloxBlock> block_buffer(device_, counters.size(), "blocks");
  ocl::Program::build(device_, "random.cl")
      .kernel("blocks")
      .launch({{counters.size()}}, counter_buffer, key_buffer, block_buffer);
  const std::vector<PhiloxBlock> on_device = block_buffer.read();
  for (std::size_t i = 0; i < known_answers.size(); ++i) {
    const PhiloxBlock on_host = philox_4x32_10(counters[i], keys[2 * i], keys[2 * i + 1]);
    for (std::size_t word = 0; word < 4; ++word) {
      EXPECT_EQ(on_host.v[word], known_answers[i].block[word]) << "answer " << i << ", word " << word;
      EXPECT_EQ(on_device[i].v[word], known_answers[i].block[word]) << "answer " << i << ", word " << word;
    }
  }
}

// Fails if the device packs (stream, n, m, index) or turns words into floats differently; negative n
// included.
TEST_F(RandomTest, AgreesBetweenHostAndDevice) {
  constexpr std::size_t count = 256;
  constexpr std::uint32_t seed_low = 0xdeadbeef, seed_high = 42;
  constexpr int row = -7;
  const ocl::Buffer<PhiloxBlock> blocks(device_, count, "blocks");
  const ocl::Buffer<float> values(device_, count, "values");
  ocl::Program::build(device_, "random.cl")
      .kernel("uniforms")
      .launch({{count}}, seed_low, seed_high, row, blocks, values);
  const std::vector<PhiloxBlock> device_blocks = blocks.read();
  const std::vector<float> device_values = values.read();
  for (std::size_t i = 0; i < count; ++i) {
    const PhiloxBlock expected =
        philox_block(seed_low, seed_high, OFFING_STREAM_OCEAN_CASCADE + 2, static_cast<int>(i) - 100, row, 5);
    for (std::size_t word = 0; word < 4; ++word) ASSERT_EQ(device_blocks[i].v[word], expected.v[word]) << i;
    ASSERT_EQ(device_values[i], uniform_open01(expected.v[1])) << i;
  }
}

// Fails if a word can become 0 or 1, which a logarithm or an inverse distribution turns into infinity.
TEST(UniformTest, StaysInsideTheOpenInterval) {
  EXPECT_GT(uniform_open01(0u), 0.0f);
  EXPECT_LT(uniform_open01(0xffffffffu), 1.0f);
}

// The mean of 4096 uniforms has the deviation 1 / sqrt(12 * 4096) = 0.00451. Gate 4.5 deviations: a false
// alarm has probability 7e-6, and the seed is fixed, so it happens never or always.
TEST(UniformTest, HasMeanOneHalf) {
  double sum = 0;
  for (int n = 0; n < 1024; ++n) {
    const PhiloxBlock block = philox_block(1, 0, OFFING_STREAM_OCEAN_CASCADE, n, 0, 0);
    for (const std::uint32_t word : block.v) sum += static_cast<double>(uniform_open01(word));
  }
  EXPECT_NEAR(sum / 4096, 0.5, 4.5 * 0.00451);
}

}  // namespace
}  // namespace offing
