// Each way from OpenCL to OpenGL brings every float, as it is.
#include "present/gl/transfer.h"

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "present/gl/texture_array.h"
#include "tests/present/gl_test.h"

namespace offing::present {
namespace {

class TransferTest : public test::GlTest, public testing::WithParamInterface<TransferPath> {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (IsSkipped()) return;
    try {
      paths_.emplace(*context_, device_, GetParam());
    } catch (const Error& error) {
      GTEST_SKIP() << error.what();
    }
  }
  void TearDown() override {
    paths_.reset();  // while its context lives
    GlTest::TearDown();
  }

  static std::vector<float> numbers(std::size_t count, float seed) {
    std::vector<float> values(count);
    for (std::size_t i = 0; i < count; ++i) values[i] = seed + 0.125f * static_cast<float>(i);
    return values;
  }

  static std::vector<float> texels_of(const MapTexture& texture, GLenum format, int level = 0) {
    std::vector<float> texels(texture.count() >> (2 * level));
    texture.bind(0);
    glGetTexImage(GL_TEXTURE_2D_ARRAY, level, format, GL_FLOAT, texels.data());
    return texels;
  }

  ocl::Device device_ = ocl::Device::open();
  std::optional<Transfer> paths_;
};

std::string name_of(const testing::TestParamInfo<TransferPath>& tested) {
  std::string name(to_string(tested.param));
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Paths, TransferTest, testing::ValuesIn(all_transfer_paths), name_of);

// Fails if a transfer path loses, moves or rounds a texel, mixes up two maps, or hands out an older frame:
// five frames go three times round the ring of buffers.
TEST_P(TransferTest, BringsEveryTexel) {
  EXPECT_EQ(paths_->path(), GetParam());
  const MapTexture wide(64, 3, 4), narrow(32, 2, 1);
  ocl::Buffer<float> wide_source(device_, wide.count(), "wide map"),
      narrow_source(device_, narrow.count(), "narrow map");
  for (int frame = 0; frame < 5; ++frame) {
    const std::vector<float> wide_values = numbers(wide.count(), static_cast<float>(1000 * frame));
    const std::vector<float> narrow_values = numbers(narrow.count(), static_cast<float>(-777 * frame));
    wide_source.write(wide_values);
    narrow_source.write(narrow_values);
    const std::array<Upload, 2> uploads{{{wide_source, &wide}, {narrow_source, &narrow}}};
    paths_->upload(uploads);
    EXPECT_EQ(texels_of(wide, GL_RGBA), wide_values) << "frame " << frame;
    EXPECT_EQ(texels_of(narrow, GL_RED), narrow_values) << "frame " << frame;
  }
}

// Fails if a coarser level is not the mean of the finest one's texels, of its own layer and channel.
TEST_P(TransferTest, FillsAllLevels) {
  constexpr int size = 16, layers = 3;
  for (const int channels : {1, 4}) {
    const MapTexture texture(size, layers, channels);
    ocl::Buffer<float> source(device_, texture.count(), "map");
    const auto index = [&](int layer, int y, int x, int channel, int width) {
      return static_cast<std::size_t>(((layer * width + y) * width + x) * channels + channel);
    };
    std::vector<float> values(texture.count());
    std::mt19937 random(7);  // the same numbers everywhere
    for (float& value : values) value = static_cast<float>(random() % 4096);
    source.write(values);
    const std::array<Upload, 1> uploads{{{source, &texture}}};
    paths_->upload(uploads);
    for (int level = 1; size >> level > 0; ++level) {
      const std::vector<float> texels = texels_of(texture, channels == 1 ? GL_RED : GL_RGBA, level);
      const int width = size >> level, covered = 1 << level;
      for (int place = 0; place < layers * width * width * channels; ++place) {
        const int channel = place % channels, x = place / channels % width,
                  y = place / channels / width % width;
        const int layer = place / channels / width / width;
        double sum = 0.0;
        for (int i = 0; i < covered * covered; ++i)
          sum += values[index(layer, y * covered + i / covered, x * covered + i % covered, channel, size)];
        // A few roundings of numbers below 4096.
        EXPECT_NEAR(texels[index(layer, y, x, channel, width)], sum / (covered * covered), 2e-3)
            << channels << " channels, level " << level << ", layer " << layer << ", " << x << ", " << y;
      }
    }
  }
}

// Fails if a map of another size is read beyond its end instead of being refused.
TEST_P(TransferTest, RefusesAnotherSize) {
  const MapTexture texture(64, 1, 4);
  const ocl::Buffer<float> source(device_, texture.count() - 1, "map");
  const std::array<Upload, 1> uploads{{{source, &texture}}};
  EXPECT_THROW(paths_->upload(uploads), Error);
}

using ChosenTransferTest = test::GlTest;

// Fails if the paths begins on a transfer path that cannot be used here, or on none.
TEST_F(ChosenTransferTest, ChoosesAPathByItself) {
  const ocl::Device device = ocl::Device::open();
  const Transfer paths(*context_, device);
  RecordProperty("path", std::string(to_string(paths.path())));
  EXPECT_EQ(paths.path() == TransferPath::mapped_pointer, device.info().type == ocl::DeviceType::cpu);
}

}  // namespace
}  // namespace offing::present
