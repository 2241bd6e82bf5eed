// Each way from OpenCL to OpenGL brings every float, as it is.
#include "present/gl/transfer.h"

#include <algorithm>
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

  static std::vector<float> texels_of(const MapTexture& texture, GLenum format) {
    std::vector<float> texels(texture.count());
    texture.bind(0);
    glGetTexImage(GL_TEXTURE_2D_ARRAY, 0, format, GL_FLOAT, texels.data());
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
