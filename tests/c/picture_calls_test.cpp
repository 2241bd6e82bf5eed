// Pictures of a scene by the C interface, which loads the presenter as a module.
#include <algorithm>
#include <cstddef>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/c/offing.h"
#include "tests/c/small_sea.h"

namespace offing {
namespace {

using testing::HasSubstr;

class PictureCallsTest : public SmallSea {
 protected:
  void SetUp() override {
    SmallSea::SetUp();
    ASSERT_EQ(offing_make_renderer(device(), scene(), &renderer_), OFFING_OK) << offing_last_error();
  }
  void TearDown() override {
    offing_free_renderer(renderer_);
    SmallSea::TearDown();
  }

  static constexpr int width = 48, height = 27;
  static constexpr std::size_t values = 3 * width * height;

  OffingStatus draw(double time_s, std::vector<unsigned char>* rgb, std::vector<float>* light) {
    OffingPicture picture{};
    picture.size = sizeof picture;
    picture.width_px = width;
    picture.height_px = height;
    picture.time_s = time_s;
    picture.rgb = rgb == nullptr ? nullptr : rgb->data();
    picture.light = light == nullptr ? nullptr : light->data();
    return offing_render(renderer_, &picture);
  }

  OffingRenderer* renderer_ = nullptr;
};

// Fails if a picture depends on the thread that asks, on the one before it, or is upside down: the sky is
// brighter than the sea below.
TEST_F(PictureCallsTest, AreDrawnForAnyThread) {
  std::vector<unsigned char> first(values), other(values), again(values);
  std::vector<float> light(values);
  ASSERT_EQ(draw(2.0, &first, &light), OFFING_OK) << offing_last_error();
  ASSERT_EQ(draw(7.0, &other, nullptr), OFFING_OK);
  OffingStatus elsewhere = OFFING_FAILED;
  std::thread([&] { elsewhere = draw(2.0, &again, nullptr); }).join();
  ASSERT_EQ(elsewhere, OFFING_OK);
  EXPECT_EQ(first, again);
  EXPECT_NE(first, other);
  const auto mean = [&](std::size_t first_row) {
    double sum = 0.0;
    for (std::size_t i = 0; i < values / 3; ++i) sum += light[first_row * width * 3 + i];
    return sum;
  };
  EXPECT_GT(mean(0), mean(2 * height / 3));
}

// Fails if a size that is none is drawn.
TEST_F(PictureCallsTest, RefusesSizes) {
  std::vector<unsigned char> rgb(values);
  OffingPicture picture{};
  picture.size = sizeof picture;
  picture.width_px = 0;
  picture.height_px = height;
  picture.rgb = rgb.data();
  EXPECT_EQ(offing_render(renderer_, &picture), OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_hint(), HasSubstr("1280 x 720"));
  EXPECT_EQ(offing_render(nullptr, &picture), OFFING_BAD_INPUT);
  EXPECT_EQ(offing_render(renderer_, nullptr), OFFING_BAD_INPUT);
}

}  // namespace
}  // namespace offing
