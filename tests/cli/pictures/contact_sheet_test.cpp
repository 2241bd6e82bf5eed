#include "host/cli/pictures/contact_sheet.h"

#include <vector>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "tests/io/temporary_folder.h"

namespace offing::cli {
namespace {

/// `count` plain pictures of 640 x 360, frame i of the grey level 5 i.
std::vector<ContactFrame> grey_frames(const TemporaryFolder& folder, int count) {
  std::vector<ContactFrame> frames;
  for (int i = 0; i < count; ++i) {
    const RgbImage picture{
        640, 360, std::vector<std::uint8_t>(std::size_t{640} * 360 * 3, static_cast<std::uint8_t>(5 * i))};
    frames.push_back({folder.path() / (std::to_string(i) + ".png"), i});
    write_png(frames.back().picture, picture);
  }
  return frames;
}

int grey_at(const RgbImage& image, int column, int row) {
  return image.rgb[3 * (static_cast<std::size_t>(row) * image.width + column)];
}

// Fails if frames are out of order, out of place or scaled wrongly: 5 frames make 3 columns and 2 rows of 320
// x 180.
TEST(ContactSheet, LaysFramesOutInReadingOrder) {
  const TemporaryFolder folder;
  const RgbImage sheet = make_contact_sheet(grey_frames(folder, 5));
  EXPECT_EQ(sheet.width, 3 * 324 + 4);
  EXPECT_EQ(sheet.height, 2 * 184 + 4);
  for (int i = 0; i < 5; ++i)
    EXPECT_EQ(grey_at(sheet, 4 + (i % 3) * 324 + 160, 4 + (i / 3) * 184 + 90), 5 * i);
}

// Fails if a long bake loses its first or last frame on the sheet, or the sheet grows without end.
TEST(ContactSheet, ChoosesEvenlyFromMany) {
  const TemporaryFolder folder;
  const RgbImage sheet = make_contact_sheet(grey_frames(folder, 50));
  EXPECT_EQ(sheet.width, 5 * 324 + 4);
  EXPECT_EQ(grey_at(sheet, 164, 94), 0);
  EXPECT_EQ(grey_at(sheet, 4 + 3 * 324 + 160, 4 + 4 * 184 + 90), 5 * 49);  // the 24th cell
}

// Fails if numbers are missing or the same: the plates of two frames differ, and hold white pixels.
TEST(ContactSheet, PrintsNumbers) {
  const TemporaryFolder folder;
  std::vector<ContactFrame> frames = grey_frames(folder, 1);
  const RgbImage first = make_contact_sheet(frames);
  frames[0].number = 1234567890;
  const RgbImage second = make_contact_sheet(frames);
  EXPECT_NE(first.rgb, second.rgb);
  int white = 0;
  for (int column = 0; column < 100; ++column) white += grey_at(first, column, 4 + 6 + 2) == 255;
  EXPECT_EQ(white, 4 * 3 * 2);  // top row of "0000": three columns a digit, each two pixels wide
}

// Fails if nothing to show, or a missing picture, goes unnoticed.
TEST(ContactSheet, BadInputIsRefused) {
  EXPECT_THROW(make_contact_sheet({}), Error);
  const std::vector<ContactFrame> missing{{"/nowhere/a.png", 0}};
  EXPECT_THROW(make_contact_sheet(missing), Error);
}

}  // namespace
}  // namespace offing::cli
