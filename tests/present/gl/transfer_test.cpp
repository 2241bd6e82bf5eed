// Each way from OpenCL to OpenGL brings every float, as it is.
#include "present/gl/transfer.h"

#include <algorithm>
#include <string>
#include <vector>

#include "present/gl/map_texture.h"
#include "tests/present/gl_test.h"

namespace offing::present {
namespace {

class TransferTest : public test::GlTest, public testing::WithParamInterface<TransferRung> {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (IsSkipped()) return;
    try {
      ladder_.emplace(*context_, device_, GetParam());
    } catch (const Error& error) {
      GTEST_SKIP() << error.what();
    }
  }
  void TearDown() override {
    ladder_.reset();  // while its context lives
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
  std::optional<TransferLadder> ladder_;
};

std::string name_of(const testing::TestParamInfo<TransferRung>& tested) {
  std::string name(to_string(tested.param));
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Rungs, TransferTest, testing::ValuesIn(all_transfer_rungs), name_of);

// Fails if a rung loses, moves or rounds a texel, mixes up two maps, or hands out an older frame: five frames
// go three times round the ring of buffers.
TEST_P(TransferTest, BringsEveryTexel) {
  EXPECT_EQ(ladder_->rung(), GetParam());
  const MapTexture wide(64, 3, 4), narrow(32, 2, 1);
  ocl::Buffer<float> wide_source(device_, wide.count(), "wide map"),
      narrow_source(device_, narrow.count(), "narrow map");
  for (int frame = 0; frame < 5; ++frame) {
    const std::vector<float> wide_values = numbers(wide.count(), static_cast<float>(1000 * frame));
    const std::vector<float> narrow_values = numbers(narrow.count(), static_cast<float>(-777 * frame));
    wide_source.write(wide_values);
    narrow_source.write(narrow_values);
    const std::array<Upload, 2> uploads{{{wide_source, &wide}, {narrow_source, &narrow}}};
    ladder_->upload(uploads);
    EXPECT_EQ(texels_of(wide, GL_RGBA), wide_values) << "frame " << frame;
    EXPECT_EQ(texels_of(narrow, GL_RED), narrow_values) << "frame " << frame;
  }
}

// Fails if a map of another size is read beyond its end instead of being refused.
TEST_P(TransferTest, RefusesAnotherSize) {
  const MapTexture texture(64, 1, 4);
  const ocl::Buffer<float> source(device_, texture.count() - 1, "map");
  const std::array<Upload, 1> uploads{{{source, &texture}}};
  EXPECT_THROW(ladder_->upload(uploads), Error);
}

using TransferLadderTest = test::GlTest;

// Fails if the ladder begins on a rung that cannot be used here, or on none.
TEST_F(TransferLadderTest, ChoosesARungByItself) {
  const ocl::Device device = ocl::Device::open();
  const TransferLadder ladder(*context_, device);
  RecordProperty("rung", std::string(to_string(ladder.rung())));
  EXPECT_EQ(ladder.rung() == TransferRung::mapped_pointer, device.info().type == ocl::DeviceType::cpu);
}

// Fails if a name is misread, or an unknown one taken for some rung.
TEST(TransferRungTest, IsNamedOnTheCommandLine) {
  for (const TransferRung rung : all_transfer_rungs) EXPECT_EQ(transfer_rung(to_string(rung)), rung);
  try {
    transfer_rung("pbo");
    FAIL() << "an unknown rung was taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_usage);
    EXPECT_NE(std::string(error.what()).find("pbo-ring"), std::string::npos);
  }
}

}  // namespace
}  // namespace offing::present
