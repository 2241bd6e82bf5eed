#include "host/cli/pictures/contact_sheet.h"

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "tests/io/temporary_folder.h"

namespace offing::cli {
namespace {

RgbImage grey(int width, int height, int level) {
  return {width, height,
          std::vector<std::uint8_t>(std::size_t{3} * width * height, static_cast<std::uint8_t>(level))};
}

class ContactSheetFiles : public testing::Test {
 protected:
  std::filesystem::path picture_of(int frame) const {
    return folder_.path() / (std::to_string(frame) + ".png");
  }
  ContactSheet sheet_of(const FrameRange& frames) const {
    return {frames, [this](int frame) { return picture_of(frame); }};
  }
  /// The sheet of `count` plain pictures of 640 x 360, frame i of the grey level 5 i.
  RgbImage grey_sheet(int count) const {
    for (int i = 0; i < count; ++i) write_png(picture_of(i), grey(640, 360, 5 * i));
    return sheet_of({0, count - 1}).draw();
  }

 private:
  TemporaryFolder folder_;
};

int grey_at(const RgbImage& image, int column, int row) {
  return image.rgb[3 * (static_cast<std::size_t>(row) * image.width + column)];
}

// Fails if frames are out of order, out of place or scaled wrongly: 5 frames make 3 columns and 2 rows of 320
// x 180.
TEST_F(ContactSheetFiles, AreLaidOutInReadingOrder) {
  const RgbImage sheet = grey_sheet(5);
  EXPECT_EQ(sheet.width, 3 * 324 + 4);
  EXPECT_EQ(sheet.height, 2 * 184 + 4);
  for (int i = 0; i < 5; ++i)
    EXPECT_EQ(grey_at(sheet, 4 + (i % 3) * 324 + 160, 4 + (i / 3) * 184 + 90), 5 * i);
}

// Fails if a long bake loses its first or last frame on the sheet, or the sheet grows without end.
TEST_F(ContactSheetFiles, AreChosenEvenlyFromMany) {
  const RgbImage sheet = grey_sheet(50);
  EXPECT_EQ(sheet.width, 5 * 324 + 4);
  EXPECT_EQ(grey_at(sheet, 164, 94), 0);
  EXPECT_EQ(grey_at(sheet, 4 + 3 * 324 + 160, 4 + 4 * 184 + 90), 5 * 49);  // the 24th cell
}

// Fails if numbers are missing or the same: the plates of two frames differ, and hold white pixels.
TEST_F(ContactSheetFiles, HaveNumbers) {
  const RgbImage first = grey_sheet(1);
  ContactSheet other = sheet_of({1234567890, 1234567890});
  other.keep(1234567890, grey(640, 360, 0));
  EXPECT_NE(first.rgb, other.draw().rgb);
  int white = 0;
  for (int column = 0; column < 100; ++column) white += grey_at(first, column, 4 + 6 + 2) == 255;
  EXPECT_EQ(white, 4 * 3 * 2);  // top row of "0000": three columns a digit, each two pixels wide
}

// Fails if pictures that were kept look other than those that are read, or if frames that the sheet does not
// show are kept. Ramps, so that scaling shows.
TEST_F(ContactSheetFiles, AreNotReadWhereKept) {
  ContactSheet some = sheet_of({3, 40}), none = sheet_of({3, 40});
  for (int frame = 3; frame <= 40; ++frame) {
    RgbImage picture = grey(512, 512, 0);
    for (std::size_t i = 0; i < picture.rgb.size(); ++i)
      picture.rgb[i] = static_cast<std::uint8_t>(i / 7 + static_cast<std::size_t>(frame));
    write_png(picture_of(frame), picture, Existing::replace, PngCompression::fast);
    if (frame % 2 == 1) some.keep(frame, picture);
  }
  const RgbImage expected = none.draw();
  for (int frame = 3; frame <= 40; frame += 2) std::filesystem::remove(picture_of(frame));
  EXPECT_EQ(some.draw().rgb, expected.rgb);
  EXPECT_THROW(none.draw(), Error);
}

// Fails if a missing picture goes unnoticed.
TEST_F(ContactSheetFiles, AreNeeded) {
  EXPECT_THROW(sheet_of({0, 0}).draw(), Error);
}

}  // namespace
}  // namespace offing::cli
